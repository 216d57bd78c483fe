#!/usr/bin/env python3
"""Grades submissions whose points are known beforehand: the bare starter, the solution, and both with one fragment changed.

    tests/points.py BUILD [--all] [--seeds N]

The fast selection takes a few fragments of each part; --all takes every fragment in turn, and ten seeds.
"""

import argparse
import pathlib
import shutil
import tempfile
import time

from helpers import BLANKS, SOLUTION, end, expect, points_in_order, record_of

fragments = points_in_order()
some = ["integrate_stratified", "hit_sphere", "cosine_hemisphere", "lens_ray"]


def submission(folder, base, changed=()):
    """A folder with the fragments of base, but those in changed from the other set."""
    sets = {"starter": BLANKS, "solution": SOLUTION}
    other = {"starter": "solution", "solution": "starter"}[base]
    shutil.copytree(sets[base], folder)
    for name in changed:
        shutil.copy(sets[other] / f"{name}.cpp", folder / f"{name}.cpp")
    return folder


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("build", type=pathlib.Path, help="the build folder")
    words.add_argument("--all", action="store_true", help="every fragment in turn, and ten seeds")
    words.add_argument("--seeds", type=int, help="grading seeds for the solution")
    words = words.parse_args()
    program = words.build / "grader/grade"
    chosen = list(fragments) if words.all else some
    seeds = words.seeds or (10 if words.all else 1)
    cases = [("bare starter", "starter", (), 1)]
    cases += [(f"solution, seed {seed}", "solution", (), seed) for seed in range(1, seeds + 1)]
    cases += [(f"starter with {name}", "starter", (name,), 1) for name in chosen]
    cases += [(f"solution without {name}", "solution", (name,), 1) for name in (chosen if words.all else some[:1])]

    for what, base, changed, seed in cases:
        expected = {name: "passed" if (base == "solution") != (name in changed) else "not_started" for name in fragments}
        with tempfile.TemporaryDirectory() as work:
            start = time.monotonic()
            folder = submission(pathlib.Path(work) / "submission", base, changed)
            record = record_of([program, folder, "--trusted", "--seed", seed])
            seconds = time.monotonic() - start
        found = {f["name"]: f["verdict"] for f in record["fragments"]}
        points = {f["name"]: f["points"] for f in record["fragments"]}
        off = [
            f"{name} is {found.get(name)}, {points.get(name)} points"
            for name, verdict in expected.items()
            if found.get(name) != verdict or points[name] != (fragments[name] if verdict == "passed" else 0)
        ]
        total = sum(fragments[name] for name, verdict in expected.items() if verdict == "passed")
        if abs(record["score"] - total) > 1e-9:
            off.append(f"score {record['score']} instead of {total}")
        expect(not off, f"{what}: {'; '.join(off)}")
        print(f"{what:45} {record['score']:6g} points {seconds:6.1f} s", flush=True)
    end(f"all of {len(cases)} right")


if __name__ == "__main__":
    main()
