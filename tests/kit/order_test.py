#!/usr/bin/env python3
"""The student's way: order_test.py GRADE

The fragments of a kit are filled in one after the other, in the handout's order: each passes at once, alone, and the
picture of its scene, drawn by all that are filled in so far with the reference's others, is the right one bit by bit.
After part 2 the student's own fragments alone draw the whole picture, with blanks for the rest; at the end they get full
points, and an edit runs the checks of the edited fragment and no others.
"""

import pathlib
import re
import sys
import tempfile

from kit import Kit
from helpers import ROOT, SOLUTION, end, expect, points_in_order

sys.path.append(str(ROOT / "tests/plan"))
from part_two_test import COMPLETE_WITH  # noqa: E402


def scene_of(fragment):
    """As the handout shows it."""
    text = (ROOT / "scenes/render_pictures").read_text()
    return re.search(rf"^picture {fragment} (\S+)", text, re.MULTILINE)


def main():
    points = points_in_order()
    with tempfile.TemporaryDirectory() as work:
        kit = Kit(pathlib.Path(sys.argv[1]).absolute(), pathlib.Path(work) / "kit")
        expect(kit.grade()["score"] == 0, "the kit as it is handed out gets points")
        filled = []
        for fragment, most in points.items():
            kit.write({fragment: (SOLUTION / f"{fragment}.cpp").read_text()})
            filled.append(fragment)
            record = kit.grade(fragment)
            verdict = record["fragments"][0]["verdict"]
            expect(verdict == "passed" and record["score"] == most, f"{fragment}: {verdict} when it is filled in")
            if scene := scene_of(fragment):
                picture = [f"scenes/{scene.group(1)}.toml", "-o", "a.png", "--size", "48x36"]
                said, code = kit.run("picture", *picture, "--mine", ",".join(filled))
                expect(code == 0 and "the same, bit by bit" in said, f"{fragment}: its scene differs:\n{said}")
            if fragment == "whitted":
                for alone in sorted({s for f in filled for s in COMPLETE_WITH.get(f, "").split()}):
                    said, code = kit.run("picture", f"scenes/{alone}.toml", "-o", "a.png", "--size", "48x36")
                    expect("the same, bit by bit" in said, f"{alone}: part 2 alone draws another picture:\n{said}")

        expect(kit.grade()["score"] == sum(points.values()), "all filled in, not full points")
        kit.write({"phong": (SOLUTION / "phong.cpp").read_text() + "// edited\n"})
        said, _ = kit.run()
        expect(re.search(r"^(\d+) checks as before", said, re.MULTILINE), f"nothing is left out after an edit:\n{said}")
        again = int(re.search(r"^(\d+) checks as before", said, re.MULTILINE).group(1))
        said, _ = kit.run()
        all_of_them = int(re.search(r"^(\d+) checks as before", said, re.MULTILINE).group(1))
        of_phong = len({c["name"] for c in kit.grade("phong")["fragments"][0]["checks"]})
        expect(all_of_them - again == of_phong, f"an edit of phong ran {all_of_them - again} checks; phong has {of_phong}")
    end(f"{len(points)} fragments pass as they are filled in")


if __name__ == "__main__":
    main()
