#!/usr/bin/env python3
"""Prints the true cause of each wrong variant beside the hint that it gets, so that a reader can judge.

    tests/variants/causes.py [--seed N] [--jobs N] GRADE FOLDER [NAME...]

FOLDER holds patches of the solution, as wrong/ does, or whole fragments whose heads say `// fragment:`, `// kind:` and
`// what:`. Only the variant's own fragment is graded, among the solution's others. The table is Markdown; below it stand the
CPU seconds that each grading took in all.
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

SOLUTION = pathlib.Path(__file__).resolve().parent.parent.parent / "solution"


def variant(path):
    """Its fragment, and what is wrong with it; none for one that is right."""
    text = path.read_text()
    if path.suffix == ".patch":
        lines = [line[2:] for line in text.splitlines() if line.startswith("# ")]
        return next(line for line in lines if line.startswith("fragment: "))[10:], lines[0]
    head = dict(re.findall(r"^// ([a-z]+): (.*)$", text, re.MULTILINE))
    return head["fragment"], None if head["kind"] == "right" else head["what"]


def put(path, fragment, folder):
    """The fragment's file, as the variant has it."""
    if path.suffix != ".patch":
        shutil.copy(path, folder / f"{fragment}.cpp")
        return
    (folder / "solution").mkdir()
    shutil.copy(SOLUTION / f"{fragment}.cpp", folder / "solution")
    subprocess.run(["patch", "-p1", "--silent", "--no-backup-if-mismatch", "-i", path.resolve()], cwd=folder, check=True)
    (folder / "solution" / f"{fragment}.cpp").rename(folder / f"{fragment}.cpp")
    (folder / "solution").rmdir()


def grade(program, path, fragment, seed):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        put(path, fragment, folder)
        out = folder / "record.json"
        done = subprocess.run([program, str(folder), fragment, "--trusted", "--jobs", "1", "--seed", str(seed), "--json", str(out)],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            sys.exit(f"{path}: {done.stdout}")
        return json.loads(out.read_text())["fragments"][0]


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
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    wrong = [(path, *variant(path)) for path in sorted([*asked.folder.glob("*.cpp"), *asked.folder.glob("*.patch")])
             if not asked.names or any(word in path.stem for word in asked.names)]
    wrong = [one for one in wrong if one[2] is not None]
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        records = pool.map(lambda one: grade(asked.program, one[0], one[1], asked.seed), wrong)
        for (path, _, what), record in zip(wrong, records):
            print(f"| {path.stem} | {record['verdict']} | {in_cell(what)} | {in_cell(record['message'])} |", flush=True)
    count = len(wrong)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if count:
        print(f"\n{count} variants, {(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime) / count:.1f} CPU seconds each")


if __name__ == "__main__":
    main()
