#!/usr/bin/env python3
"""A class in parts: parts_test.py GRADE

grader/class/parallel with GNU parallel, where it is there, and the steps of grader/class/matrix.yml, run one after the other with
the artifacts in place: both give the class of one call.
"""

import os
import pathlib
import re
import shutil
import sys
import tempfile

from classes import light_class, outcome
from helpers import ROOT, end, expect, run, steps_of

GRADE = pathlib.Path(sys.argv[1]).absolute()


def check_parallel(work, export, alone):
    if not shutil.which("parallel"):
        print("GNU parallel is not installed: grader/class/parallel is not tried")
        return
    command = [ROOT / "grader/class/parallel", export, work / "by parallel", "5", "2"]
    surroundings = os.environ | {"GRADE": str(GRADE)}
    run(command, 1, env=surroundings)
    expect(outcome(work / "by parallel") == outcome(alone), "another outcome by GNU parallel")
    (work / "by parallel/parts/1-of-2/records").rename(work / "lost")
    said = run([*command, "--jobs", "1"], 1, env=surroundings)
    expect(" as before" in said and outcome(work / "by parallel") == outcome(alone), f"a part that is lost is not graded again: {said}")
    run(command[:3], 2, env=surroundings)
    run([command[0], work / "none", *command[2:]], 3, env=surroundings)


def check_matrix(work, export, alone):
    """In a repository, as GitHub's machines run it; installed is a link to the grader."""
    place, programs = work / "repository", work / "bin"
    place.mkdir()
    programs.mkdir()
    (programs / "grade").symlink_to(GRADE)
    shutil.copytree(export, place / "submissions")
    workflow = (ROOT / "grader/class/matrix.yml").read_text()
    parts = re.search(r"part: \[(.*)\]", workflow)[1].split(", ")
    _, grading, _, merging = steps_of(workflow)
    expect(f"/{len(parts)}\n" in grading, f"the shards are not of {len(parts)}: {grading}")
    surroundings = os.environ | {"PATH": f"{programs}:{os.environ['PATH']}"}
    for part in parts:
        step = grading.replace("${{ matrix.part }}", part).replace("--seed 1", "--seed 5")
        run(["bash", "-e", "-o", "pipefail", "-c", step], cwd=place, env=surroundings)
    run(["bash", "-e", "-o", "pipefail", "-c", merging], 1, cwd=place, env=surroundings)
    expect(outcome(place / "class") == outcome(alone), "another outcome by the matrix")


def main():
    with tempfile.TemporaryDirectory() as work:
        work = pathlib.Path(work)
        export, alone = work / "export", work / "alone"
        light_class(export, 4)
        (export / "hw1-essay.pdf").write_text("%PDF")  # the whole ends with 1 for it, its parts with 0
        run([GRADE, "class", export, "-o", alone, "--seed", "5"], 1)
        check_parallel(work, export, alone)
        check_matrix(work, export, alone)
    end("a class in parts is that of one call")


main()
