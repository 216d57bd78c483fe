#!/usr/bin/env python3
"""Mutation score of the checks: mistakes made in the solution, each graded; one that passes must be none.

    tests/variants/mutants.py GRADE [FRAGMENT...] [--sample N] [--seed N] [--jobs N] [--forms] [--list]

mistakes.py makes the mistakes. Of each fragment N are taken at random (0: all), the same for the same seed; --forms takes
those of the right variants of the fragment as well, so of formulas as students write them. --list shows them alone.
Printed by fragment: mistakes, those taken that compile, and of these how many fail (killed), compute the same (equivalent: the
same machine code, or a line of equivalents.txt says why), and pass (alive). Exit status 1: one is alive.
"""
import argparse
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys

import mistakes
from expressions import ROOT

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import head_of, record_of_one, variant  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
COMPILER = os.environ.get("CXX", "c++")


def reasons():
    """Of mistakes that are none: fragment or "any", what their lines look like, why."""
    found = []
    for number, line in enumerate((HERE / "equivalents.txt").read_text().splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        parts = [part.strip() for part in line.split(" | ")]
        if len(parts) != 3:
            sys.exit(f"{HERE}/equivalents.txt:{number}:1: {len(parts)} parts; expected: fragment | line with the mistake | why it is none")
        pattern = ".*".join(re.escape(part) for part in parts[1].split("@"))
        found.append((parts[0], re.compile(pattern), parts[2], number))
    return found


def sources(fragment, with_forms):
    """The solution, and the right variants of it."""
    yield "solution", (ROOT / "solution" / f"{fragment}.cpp").read_text()
    for patch in sorted((HERE / "right").glob("*.patch")) if with_forms else []:
        if head_of(patch)["fragment"] == fragment:
            yield patch.stem, variant(patch)[1]


class Mutant:
    def __init__(self, source, fragment, mistake):
        self.source, self.kind, self.right, self.text = source, mistake.kind, fragment.text, fragment.with_mistake(mistake)
        first = fragment.text.count("\n", 0, mistake.begin)
        self.number = first + 1
        lines = self.text.splitlines()[first:first + 1 + mistake.text.count("\n")]
        self.line = " ".join(" ".join(lines).split())


def in_namespace(text, name):
    """A fragment's file, its includes and the rest of it in a namespace of its own."""
    rest = re.sub(r"^\s*#\s*include.*$", "", text, flags=re.MULTILINE)
    return re.findall(r"^\s*#\s*include.*$", text, re.MULTILINE), rest.replace("namespace rt {", f"namespace rt::{name} {{", 1)


def that_compile(mutants):
    """All at once; again without those that do not."""
    while mutants:
        heads, bodies = [], []
        for number, mutant in enumerate(mutants):
            head, body = in_namespace(mutant.text, f"mutant_{number}")
            heads += head
            bodies.append(f'# line 1 "mutant_{number}"\n{body}\n')
        done = subprocess.run([COMPILER, "-std=c++20", "-w", "-fsyntax-only", "-I", ROOT / "starter", "-x", "c++", "-"],
                              input="\n".join(dict.fromkeys(heads)) + "\n" + "".join(bodies), capture_output=True, text=True)
        wrong = {int(number) for number in re.findall(r"\bmutant_(\d+):", done.stderr)}
        if done.returncode != 0 and not wrong:
            sys.exit(done.stderr)
        mutants = [mutant for number, mutant in enumerate(mutants) if number not in wrong]
        if not wrong:
            return mutants
    return []


def machine_code(text):
    done = subprocess.run([COMPILER, "-std=c++20", "-w", "-O2", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-S",
                           "-I", ROOT / "starter", "-x", "c++", "-", "-o", "-"], input=text, capture_output=True, text=True)
    return done.stdout


def mutants_of(fragment, asked, known):
    """All, and those taken."""
    all_ = []
    for source, text in sources(fragment, asked.forms):
        whole = mistakes.Fragment(fragment, text)
        all_ += [Mutant(source, whole, mistake) for mistake in whole.mistakes()]
    for of, pattern, _, number in known if not asked.forms else []:
        if of == fragment and not any(pattern.fullmatch(mutant.line) for mutant in all_):
            sys.exit(f"{HERE}/equivalents.txt:{number}:1: no mistake makes such a line any more; expected: those of today's solution")
    order = random.Random(f"{asked.seed} {fragment}").sample(all_, len(all_))
    return all_, order[:asked.sample] if asked.sample else all_


def judged(asked, fragment, mutant, known):
    """killed, equivalent or alive, and why."""
    verdict = record_of_one(asked.program, fragment, mutant.text, asked.seed)["verdict"]
    if verdict != "passed":
        return "killed", verdict
    if machine_code(mutant.text) == machine_code(mutant.right):
        return "equivalent", "the same machine code"
    for of, pattern, why, _ in known:
        if of in (fragment, "any") and pattern.fullmatch(mutant.line):
            return "equivalent", why
    return "alive", "passes"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="GRADE", help="the built grader")
    parser.add_argument("fragments", metavar="FRAGMENT", nargs="*")
    parser.add_argument("--sample", type=int, default=10)
    parser.add_argument("--seed", type=int, default=101)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--forms", action="store_true")
    parser.add_argument("--list", action="store_true")
    asked = parser.parse_args()
    if not shutil.which("clang++"):
        print("no clang++")
        sys.exit(77)
    known, sums, living = reasons(), [0] * 5, []
    print("| fragment | mistakes | taken | killed | equivalent | alive |\n|---|---|---|---|---|---|")
    names = sorted(file.stem for file in (ROOT / "solution").glob("*.cpp"))
    for fragment in set(asked.fragments) - set(names):
        parser.error(f"{fragment}: no such fragment")
    for fragment in asked.fragments or names:
        all_, taken = mutants_of(fragment, asked, known)
        taken = that_compile(taken)
        if asked.list:
            print("\n".join(f"{mutant.source}:{mutant.number}: {mutant.kind}: {mutant.line}" for mutant in taken))
            continue
        with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
            results = list(pool.map(lambda mutant: judged(asked, fragment, mutant, known), taken))
        count = [sum(result == kind for result, _ in results) for kind in ("killed", "equivalent", "alive")]
        row = [len(all_), len(taken), *count]
        sums = [a + b for a, b in zip(sums, row)]
        living += [(fragment, mutant) for mutant, (result, _) in zip(taken, results) if result == "alive"]
        print(f"| {fragment} | {' | '.join(str(n) for n in row)} |", flush=True)
        for mutant, (result, why) in zip(taken, results):
            if result != "killed":
                print(f"    {result}: {mutant.source}:{mutant.number}: {mutant.kind}: {mutant.line}    ({why})", flush=True)
    if not asked.list:
        print(f"| all | {' | '.join(str(n) for n in sums)} |")
        if sums[1] > sums[3]:
            print(f"\nmutation score: {sums[2]} of {sums[1] - sums[3]} that are not equivalent, {100 * sums[2] / (sums[1] - sums[3]):.2f} %")
    sys.exit(1 if living else 0)


if __name__ == "__main__":
    main()
