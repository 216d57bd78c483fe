#!/usr/bin/env python3
"""An instructor follows grader/INSTRUCTORS.md: author_test.py BUILD [--all] [SECTION...]

Runs the page's own blocks, in their order, in a copy of the tree and of its build:

    sh           commands, each of which must end with 0; what stands after "# says " must be among what it prints
    diff         is applied
    LANG FILE    is the whole text of that file

The copy is mounted over the tree for these commands alone, since a build holds the paths of its sources. Sections whose
heading ends in "(long)" are followed with --all alone. Exit status 77: nothing can be mounted here, or the page's
fragments are there. With --names nothing is run: what its tables of files, and the calls of its checks, name must stand in
the files that they link to.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import ROOT, cpu_seconds  # noqa: E402

PAGE = ROOT / "grader/INSTRUCTORS.md"
# what the walk needs of a build; the tests' programs are larger than all of it
NOT_COPIED = {"tests", "calibration", "report", "kept"}


def sections(text):
    """Headings of the first two levels, and their blocks: where it begins, the words of its fence, its text."""
    found, heading, lines = {}, "", text.splitlines()
    end = 0  # of the last block: what begins with a hash in it is no heading
    for number, line in enumerate(lines, 1):
        if number <= end:
            continue
        if line.startswith(("# ", "## ")):
            heading = line.lstrip("# ")
            found[heading] = []
        elif re.match(r"```\w", line):
            end = lines.index("```", number) + 1
            found[heading].append((number, line.removeprefix("```").split(), "\n".join(lines[number:end - 1]) + "\n"))
    return found


def copied(work):
    """The tree without what is no source, and with its build."""
    tree = work / "tree"
    shutil.copytree(ROOT, tree, symlinks=True, ignore=lambda folder, names: {
        n for n in names if folder == str(ROOT) and (n.startswith("build") or n == ".git") or n == "__pycache__"})
    return tree


def copy_build(build, tree):
    target = tree / build.relative_to(ROOT)
    target.mkdir(parents=True)
    for entry in build.iterdir():
        if entry.name not in NOT_COPIED and not (entry.is_file() and entry.name in ("unit_tests", "threads")):
            subprocess.run(["cp", "-a", entry, target], check=True)


class Walk:
    def __init__(self, tree):
        self.tree = tree
        self.wrong = 0
        over = 'mount --bind "$0" "$1" && cd "$1" && shift && exec "$@"'
        own = [] if os.getuid() == 0 else ["--map-root-user"]
        self.inside = ["unshare", "--mount", *own, "sh", "-c", over, str(tree), str(ROOT)]

    def can_mount(self):
        return subprocess.run([*self.inside, "true"], capture_output=True).returncode == 0

    def fail(self, number, what, said):
        self.wrong += 1
        print(f"{PAGE.relative_to(ROOT)}:{number}:1: {what}\n{said[-4000:]}", flush=True)

    def run(self, number, command, said_too=""):
        before = cpu_seconds()
        done = subprocess.run([*self.inside, "bash", "-ec", command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        print(f"{cpu_seconds() - before:6.1f} s  {command[:90]}", flush=True)
        if done.returncode != 0:
            self.fail(number, f"{command}: ended with {done.returncode}; expected 0", done.stdout)
        elif said_too not in done.stdout:
            self.fail(number, f'{command}: expected "{said_too}" among what it says', done.stdout)
        return done.stdout

    def follow(self, number, words, text):
        if words[0] == "sh":
            for k, line in enumerate(text.splitlines(), number + 1):
                command, _, said = line.partition("  # says ")
                if command.strip():
                    self.run(k, command, said)
        elif words[0] == "diff":
            done = subprocess.run(["patch", "-p1", "--silent", "--no-backup-if-mismatch"], cwd=self.tree, input=text,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            if done.returncode != 0:
                self.fail(number, "does not apply; expected a change of today's tree", done.stdout)
        elif len(words) == 2:
            (self.tree / words[1]).write_text(text)


def names_that_are_not_there(text):
    """Of the rows "| [file](path) | `name` ... |", and of calls in the page's C++ of checks."""
    missing, there = [], set()
    for number, line in enumerate(text.splitlines(), 1):
        row = re.match(r"\| \[\w+\.h\]\(([\w/.]+\.h)\) \|(.*)\|$", line)
        if row:
            words = set(re.findall(r"\w+", (PAGE.parent / row[1]).read_text()))
            there |= words
            named = {name for code in re.findall(r"`([^`]+)`", row[2]) for name in re.findall(r"^[a-z_]+(?=$|[(<])", code)}
            missing += [f"{number}:1: `{name}` is not in {row[1]}" for name in sorted(named - words)]
    assert there, "no table of files was found"
    for number, fence, code in (block for blocks in sections(text).values() for block in blocks):
        if fence[0] == "cpp" and fence[1:] and fence[1].startswith("grader/checks/"):
            own = set(re.findall(r"\w+(?= = )", code)) | set(re.findall(r"^\w+ (\w+)\(", code, re.M))
            called = set(re.findall(r"(?<![\w:.>])[a-z_]+(?=[(<])", code)) - own - {"if", "for"}
            missing += [f"{number}:1: {name} of {fence[1]} is in none of the files of the table" for name in sorted(called - there)]
    return missing


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("build", type=pathlib.Path)
    words.add_argument("--all", action="store_true", help="also the sections that take long")
    words.add_argument("--names", action="store_true", help="only whether the names in its tables are there")
    words.add_argument("sections", nargs="*", help="only those with one of these words in their heading")
    words = words.parse_intermixed_args()
    if words.names:
        for line in (missing := names_that_are_not_there(PAGE.read_text())):
            print(f"{PAGE.relative_to(ROOT)}:{line}")
        sys.exit(bool(missing))
    page = sections(PAGE.read_text())
    made = re.findall(r"grade new fragment (\w+)", PAGE.read_text())
    if there := [name for name in made if (ROOT / f"solution/{name}.cpp").exists()]:
        print(f"this tree is a course's own: {', '.join(there)} is there already")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        tree = copied(pathlib.Path(folder))
        walk = Walk(tree)
        if not walk.can_mount():
            print("nothing can be mounted here")
            sys.exit(77)
        copy_build(words.build.resolve(), tree)
        count = 0
        for heading, blocks in page.items():
            chosen = not words.sections or any(word in heading for word in words.sections)
            if not chosen or (heading.endswith("(long)") and not words.all):
                continue
            before = cpu_seconds()
            for block in blocks:
                walk.follow(*block)
                count += 1
            print(f"{heading}: {len(blocks)} blocks, {cpu_seconds() - before:.0f} s of one processor", flush=True)
    print(f"{count} blocks, {walk.wrong} not as the page says")
    sys.exit(walk.wrong > 0 or count < 5)


if __name__ == "__main__":
    main()
