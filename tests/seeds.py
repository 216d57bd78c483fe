#!/usr/bin/env python3
"""Whether verdicts and points depend on the seed: grades tests/example and variants under many, and compares check by check.

    tests/seeds.py [--seeds 40] [--first N] [--jobs N] GRADE [NAME...]

A NAME is "example", one of its fragments, "wrong" or "right" for tests/variants/wrong and right, a folder of patches or of whole fragments with
heads (as tests/variants/causes.py takes them), or a part of the names of wrong and right variants; without any: all three.
Variants of different fragments are graded in one submission, as none can spoil another's marks. Exit status 1: the example
has not the same points under all seeds.
"""

import argparse
import collections
import concurrent.futures
import importlib.util
import json
import pathlib
import subprocess
import sys
import tempfile

tests = pathlib.Path(__file__).resolve().parent
spec = importlib.util.spec_from_file_location("causes", tests / "variants/causes.py")
causes = importlib.util.module_from_spec(spec)
spec.loader.exec_module(causes)


def chosen(names):
    """What of the example is asked for, all of it or some fragments, and variants: paths."""
    of_example = {path.stem for path in (tests / "example/fragments").glob("*.cpp")}
    kinds = {"wrong": tests / "variants/wrong", "right": tests / "variants/right"}
    paths = []
    for name in names or ["wrong", "right"]:
        folder = kinds.get(name, pathlib.Path(name))
        if folder.is_dir():
            paths += sorted([*folder.glob("*.cpp"), *folder.glob("*.patch")])
        elif name != "example" and name not in of_example:
            paths += [path for kind in kinds.values() for path in sorted(kind.glob("*.patch")) if name in path.stem]
    whole = not names or "example" in names
    return whole, sorted(of_example & set(names)), paths


def packed(paths):
    """Variants in as few groups as possible, of each fragment one in a group."""
    groups = []
    for path in paths:
        fragment = causes.variant(path)[0]
        group = next((g for g in groups if fragment not in g), None)
        if group is None:
            groups.append(group := {})
        group[fragment] = path
    return groups


def grade(program, submission, fragments, seed):
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        done = subprocess.run([program, str(submission), *fragments, "--trusted", "--jobs", "1", "--time-limit", "1",
                               "--seed", str(seed), "--json", out.name], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{submission}, seed {seed}: {done.stdout}{done.stderr}")
        return json.loads(pathlib.Path(out.name).read_text())["fragments"]


def graded(program, groups, example, some, seed):
    """Fragments' records by name: of the example, and of each variant."""
    records = {}
    if example or some:
        fragments = [] if example else some
        records.update({f"example {f['name']}": f for f in grade(program, tests / "example", fragments, seed)})
    for group in groups:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for fragment, path in group.items():
                causes.put(path, fragment, folder)
            for f in grade(program, folder, sorted(group), seed):
                records[group[f["name"]].stem] = f
    return records


def verdicts(record):
    """What may differ: points, the fragment's verdict and each check's."""
    return {"points": record["points"], "verdict": record["verdict"],
            **{f"check {check['name']}": check["verdict"] for check in record["checks"]}}


def compare(by_seed):
    """Prints what differs; returns how many (variant, seed) have another verdict, and other points, than most."""
    other = collections.Counter()
    for name in next(iter(by_seed.values())):
        for what in verdicts(next(iter(by_seed.values()))[name]):
            values = {seed: verdicts(records[name])[what] for seed, records in by_seed.items()}
            usual, count = collections.Counter(values.values()).most_common(1)[0]
            if count == len(values):
                continue
            rest = {seed: value for seed, value in values.items() if value != usual}
            shown = ", ".join(f"{value} under {seed}" for seed, value in list(rest.items())[:8])
            print(f"{name}: {what}: {usual} under {count} of {len(values)} seeds; {shown}")
            other["checks" if what.startswith("check ") else what] += len(rest)
    return other


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=40)
    parser.add_argument("--first", type=int, default=1, help="the first seed")
    parser.add_argument("--jobs", type=int, default=1, help="seeds at a time")
    parser.add_argument("program", metavar="GRADE", help="the built grader")
    parser.add_argument("names", metavar="NAME", nargs="*")
    asked = parser.parse_args()

    example, some, paths = chosen(asked.names)
    groups = packed(paths)
    seeds = range(asked.first, asked.first + asked.seeds)
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        by_seed = dict(zip(seeds, pool.map(lambda seed: graded(asked.program, groups, example, some, seed), seeds)))
    other = compare(by_seed)
    pairs = len(next(iter(by_seed.values()))) * asked.seeds
    print(f"{asked.seeds} seeds: of {pairs} (fragment, seed) {other['verdict']} have another verdict, {other['points']} "
          f"other points; {other['checks']} checks have another verdict")
    if example or some:
        scores = {seed: round(sum(f["points"] for name, f in records.items() if name.startswith("example ")), 2)
                  for seed, records in by_seed.items()}
        print("the example has " + ", ".join(f"{score} points" for score in sorted(set(scores.values()))))
        sys.exit(len(set(scores.values())) > 1)


if __name__ == "__main__":
    main()
