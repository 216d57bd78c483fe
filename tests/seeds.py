#!/usr/bin/env python3
"""Whether verdicts and points depend on the seed: grades submissions under many, and compares check by check.

    tests/seeds.py [--seeds 40] [--first N] [--jobs N] GRADE [SUBMISSION...]

Without a SUBMISSION: tests/example. Variants of single fragments: `grade calibrate --fast --seeds 40 wrong/ right/`.
Exit status 1: a submission has not the same points under all seeds.
"""

import argparse
import collections
import concurrent.futures
import pathlib
import sys

from helpers import ROOT, record_of


def said(program, submission, seed):
    """What may differ: points, each fragment's verdict and each check's."""
    fragments = record_of([program, submission, "--trusted", "--jobs", "1", "--seed", seed])["fragments"]
    values = {"points": round(sum(f["points"] for f in fragments), 2)}
    for f in fragments:
        values[f"{f['name']}: points"], values[f"{f['name']}: verdict"] = f["points"], f["verdict"]
        values |= {f"{f['name']}.{check['name']}: verdict": check["verdict"] for check in f["checks"]}
    return values


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=40)
    parser.add_argument("--first", type=int, default=1, help="the first seed")
    parser.add_argument("--jobs", type=int, default=1, help="seeds at a time")
    parser.add_argument("program", metavar="GRADE", help="the built grader")
    parser.add_argument("submissions", metavar="SUBMISSION", nargs="*", type=pathlib.Path)
    asked = parser.parse_args()

    seeds = range(asked.first, asked.first + asked.seeds)
    differs = False
    for submission in asked.submissions or [ROOT / "tests/example"]:
        with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
            by_seed = list(pool.map(lambda seed: said(asked.program, submission, seed), seeds))
        for what in by_seed[0]:
            counts = collections.Counter(values[what] for values in by_seed)
            if len(counts) > 1:
                rest = [f"{values[what]} under {seed}" for seed, values in zip(seeds, by_seed)
                        if values[what] != counts.most_common(1)[0][0]]
                print(f"{submission.name}, {what}: {counts.most_common(1)[0][0]} under most seeds, {', '.join(rest[:8])}")
        points = sorted({values["points"] for values in by_seed})
        differs = differs or len(points) > 1
        print(f"{submission.name}: {', '.join(map(str, points))} points under {asked.seeds} seeds")
    sys.exit(differs)


if __name__ == "__main__":
    main()
