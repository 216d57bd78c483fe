#!/usr/bin/env python3
"""Prints the true cause of each wrong variant beside the hint that it gets, so that a reader can judge.

    tests/variants/causes.py [--seed N] [--jobs N] GRADE FOLDER [NAME...]

FOLDER holds patches of the solution, as wrong/ does, or whole fragments whose heads say `// fragment:`, `// kind:` and
`// what:`. Only the variant's own fragment is graded, among the solution's others. The table is Markdown; below it stand the
CPU seconds that each grading took in all.
"""
import argparse
import concurrent.futures
import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import cpu_seconds, head_of, record_of_one, variant  # noqa: E402


def read(path):
    """Its fragment, the fragment's text, and what is wrong with it; none for one that is right."""
    if path.suffix == ".patch":
        return *variant(path), head_of(path)["what"]
    text = path.read_text()
    head = dict(re.findall(r"^// ([a-z]+): (.*)$", text, re.MULTILINE))
    return head["fragment"], text, None if head["kind"] == "right" else head["what"]


def in_cell(text):
    return " ".join(text.split()).replace("|", "\\|")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=101)
    parser.add_argument("--jobs", type=int, default=1, help="how many are graded at a time")
    parser.add_argument("program", metavar="GRADE", help="the built grader")
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path)
    parser.add_argument("names", metavar="NAME", nargs="*", help="only variants whose names hold one of these words")
    asked = parser.parse_args()
    print("| variant | verdict | what is wrong | hint |\n|---|---|---|---|")
    wrong = [(path, *read(path)) for path in sorted([*asked.folder.glob("*.cpp"), *asked.folder.glob("*.patch")])
             if not asked.names or any(word in path.stem for word in asked.names)]
    wrong = [one for one in wrong if one[3] is not None]
    before = cpu_seconds()
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        records = pool.map(lambda one: record_of_one(asked.program, one[1], one[2], asked.seed), wrong)
        for (path, _, _, what), record in zip(wrong, records):
            print(f"| {path.stem} | {record['verdict']} | {in_cell(what)} | {in_cell(record['message'])} |", flush=True)
    if wrong:
        print(f"\n{len(wrong)} variants, {(cpu_seconds() - before) / len(wrong):.1f} CPU seconds each")


if __name__ == "__main__":
    main()
