#!/usr/bin/env python3
"""Grades submissions whose points are known beforehand: the bare starter, the solution, and both with one fragment changed.

    tests/points.py BUILD [--all] [--seeds N]

The fast selection takes a few fragments of each part; --all takes every fragment in turn, and ten seeds.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib

root = pathlib.Path(__file__).resolve().parent.parent
fragments = {
    f["name"]: f["points"]
    for part in tomllib.loads((root / "assignment.toml").read_text())["part"]
    for f in part["fragments"]
    if not f.get("given", False)
}
some = ["integrate_stratified", "hit_sphere", "cosine_hemisphere", "lens_ray"]


def submission(folder, base, changed=()):
    """A folder with the fragments of base, but those in changed from the other set."""
    sets = {"starter": root / "starter/fragments", "solution": root / "solution"}
    other = {"starter": "solution", "solution": "starter"}[base]
    shutil.copytree(sets[base], folder)
    for name in changed:
        shutil.copy(sets[other] / f"{name}.cpp", folder / f"{name}.cpp")
    return folder


def grade(program, folder, seed):
    """The record of a grading."""
    record = folder.parent / "record.json"
    record.unlink(missing_ok=True)
    done = subprocess.run(
        [program, folder, "--trusted", "--seed", str(seed), "--json", record], capture_output=True, text=True
    )
    if done.returncode != 0:
        sys.exit(f"grade ended with {done.returncode}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return json.loads(record.read_text())


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

    wrong = 0
    for what, base, changed, seed in cases:
        expected = {
            name: "passed" if (base == "solution") != (name in changed) else "not_started" for name in fragments
        }
        with tempfile.TemporaryDirectory() as work:
            start = time.monotonic()
            record = grade(program, submission(pathlib.Path(work) / "submission", base, changed), seed)
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
        wrong += bool(off)
        print(f"{what:45} {record['score']:6g} points {seconds:6.1f} s  {'; '.join(off) or 'right'}", flush=True)
    print(f"{len(cases) - wrong} of {len(cases)} right")
    return wrong != 0


if __name__ == "__main__":
    sys.exit(main())
