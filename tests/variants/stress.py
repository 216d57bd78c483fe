#!/usr/bin/env python3
"""Stresses fragments that are numerically naive, and fragments that are right in another way.

    tests/variants/stress.py [--fast] [--share 0.95] GRADE [NAME...]

`grade stress` must see each naive variant fail earlier than the solution, in the family that its header names, and must
give each right one its full scored tier. Prints a row for each; exits with 1 where fewer than that share of the naive ones
are found, or a right one loses its scored tier.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent))
from helpers import SOLUTION, fragments_in_order, head_of, record_of, variant  # noqa: E402


def stress(program, patch):
    """The record of `grade stress` for the solution with a patch; only the families of the patched fragment are run."""
    with tempfile.TemporaryDirectory() as work:
        folder = shutil.copytree(SOLUTION, pathlib.Path(work) / "solution")
        fragment, text = variant(patch)
        (folder / f"{fragment}.cpp").write_text(text)
        return record_of([program, "stress", folder, "--trusted", "--only", fragment, "--time-limit", "3"])["families"]


def words(reach):
    return "none" if reach is None else f"1e{reach[0]} to 1e{reach[1]}"


def is_short(family):
    """Whether a family passes fewer decades than it does for the solution."""
    reach, solution = family["reach"], family["solution_reach"]
    if not family["started"]:
        sys.exit(f"{family['name']}: {family['message']}")
    return solution is not None and (reach is None or reach[0] > solution[0] or reach[1] < solution[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fast", action="store_true", help="every eighth variant")
    parser.add_argument("--share", type=float, default=0.95, help="of the naive variants that must be found")
    parser.add_argument("program", metavar="GRADE", help="the built grader")
    parser.add_argument("names", metavar="NAME", nargs="*", help="only variants whose names hold one of these words")
    asked = parser.parse_args()

    listed = subprocess.run([asked.program, "stress", "--list"], stdout=subprocess.PIPE, text=True, check=True).stdout
    fragments = {line.split()[1] for line in listed.splitlines()} & set(sum(fragments_in_order().values(), []))
    counts = {"naive": [0, 0], "right": [0, 0]}  # found or passed, of all
    for kind in counts:
        paths = [p for p in sorted((HERE / kind).glob("*.patch")) if not asked.names or any(n in f"{kind}/{p.stem}" for n in asked.names)]
        for path in paths[::8] if asked.fast else paths:
            keys = head_of(path)
            if keys["fragment"] not in fragments:
                continue
            families = stress(asked.program, path)
            counts[kind][1] += 1
            if kind == "right":
                lost = [f"{f['name']} passes {words(f['reach'])}" for f in families if f["scored"] is False]
                good = not lost
                told = ", ".join(lost) or "scored tier full"
            else:
                short = {f["name"]: f for f in families if is_short(f)}
                good = keys["family"] in short
                told = f"{keys['family']}: {words(short[keys['family']]['reach'])}" if good else "not found" + (
                    f"; but {', '.join(short)}" if short else "")
            counts[kind][0] += good
            print(f"{'ok ' if good else 'OFF'} {kind}/{path.stem:<36} {keys['fragment']:<22} {told}", flush=True)
    (found, naive), (passed, right) = counts["naive"], counts["right"]
    print(f"{found} of {naive} naive variants found, {passed} of {right} right ones with a full scored tier")
    if naive + right == 0:
        sys.exit("no variant has such a name")
    return 0 if found >= asked.share * naive and passed == right else 1


if __name__ == "__main__":
    sys.exit(main())
