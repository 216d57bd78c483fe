#!/usr/bin/env python3
"""At home as in the office: same_test.py [--all] GRADE

1. Wrong and right variants (tests/variants), one of each fragment at a time: the kit's record is the instructor's with that
   seed, verdicts, points, numbers and hints. --all takes every variant, else some.
2. One wrong fragment among right ones, at home: it alone loses points, and is named.
"""

import argparse
import pathlib
import tempfile

from kit import Kit, without_times
from helpers import ROOT, SOLUTION, end, expect, points_in_order, record_of, variant

VARIANTS = ROOT / "tests/variants"
# whose mistakes failed or blocked right fragments when fragments were run with each other
CULPRITS = """phong pixel_mean emission_counts hit_quad direct_light shutter_time moved fresnel_dielectric shadow_ray
    camera_ray light_sample film_sample""".split()


def bundles(patches):
    """Sets of variants, at most one of each fragment in each."""
    waiting = {}
    for patch in patches:
        waiting.setdefault(variant(patch)[0], []).append(patch)
    while waiting:
        yield [of_one.pop(0) for of_one in waiting.values()]
        waiting = {fragment: rest for fragment, rest in waiting.items() if rest}


def difference(home, office):
    for a, b in zip(home["fragments"], office["fragments"], strict=True):
        if a != b:
            keys = [k for k in a if a[k] != b[k]]
            return f"{a['name']}: {[(k, a[k], b[k]) for k in keys if k != 'checks'] or keys}"
    return f"{[k for k in home if home[k] != office[k]]}"


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("grade", type=pathlib.Path)
    words.add_argument("--all", action="store_true")
    asked = words.parse_args()
    grade = asked.grade.absolute()
    points = points_in_order()
    patches = sorted(VARIANTS.glob("wrong/*.patch")) + sorted(VARIANTS.glob("right/*.patch"))
    count = 0
    with tempfile.TemporaryDirectory() as work:
        kit = Kit(grade, pathlib.Path(work) / "kit")
        mine = kit.folder / "starter/fragments"
        for number, bundle in enumerate(bundles(patches if asked.all else patches[:: len(patches) // 20])):
            seed = 1 + number
            texts = dict(map(variant, bundle))
            kit.write(texts)
            home = without_times(kit.grade(*texts, "--seed", str(seed)))
            office = without_times(record_of([grade, mine.parent, *texts, "--seed", seed]))
            expect(home == office, f"seed {seed}, {[p.stem for p in bundle]}: {difference(home, office)}" if home != office else "")
            count += len(bundle)

        kit.write({name: (SOLUTION / f"{name}.cpp").read_text() for name in points})
        expect(kit.grade()["score"] == sum(points.values()), "the solution at home gets less than all points")
        for culprit in CULPRITS:
            of_it = [p for p in patches if p.parent.name == "wrong" and variant(p)[0] == culprit]
            expect(of_it, f"no wrong variant of {culprit}")
            for patch in of_it[: 99 if asked.all else 1]:
                fragment, text = variant(patch)
                kit.write({fragment: text})
                record = kit.grade()
                others = [f["name"] for f in record["fragments"] if f["verdict"] != "passed"]
                expect(others == [fragment], f"{patch.stem}: {others} do not pass; expected {fragment} alone")
                lost = sum(points.values()) - record["score"]
                expect(0 < lost <= points[fragment], f"{patch.stem} costs {lost} points; {fragment} has {points[fragment]}")
                kit.write({fragment: (SOLUTION / f"{fragment}.cpp").read_text()})
    end(f"{count} variants have one record at home and in the office")


if __name__ == "__main__":
    main()
