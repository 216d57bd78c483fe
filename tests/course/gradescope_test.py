#!/usr/bin/env python3
"""Gradescope's autograder, and the workflow of GitHub Actions that a course copies: gradescope_test.py GRADE

`grade hand-out FOLDER --gradescope ZIP`: the archive is unpacked into a folder laid out like Gradescope's, set up and run as root
with Docker's default rights (tests/hostile/docker_like.c), where there are no user namespaces; right, wrong and empty
submissions, and a machine that fails. Then the steps of grader/kit/github/grade.yml, run one after the other in the kit.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

from classes import WRONG_MIRROR
from helpers import ROOT, SOLUTION, end, expect, run, steps_of

GRADE = pathlib.Path(sys.argv[1]).absolute()


def unpack(zip_file, folder):
    """As Gradescope does: with the right to be run."""
    with zipfile.ZipFile(zip_file) as archive:
        for entry in archive.infolist():
            path = folder / entry.filename
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(archive.read(entry))
            path.chmod(entry.external_attr >> 16 & 0o777)


def launcher(work):
    """Starts a command as a container of Docker's would; as it is, where we are not root."""
    if os.geteuid() != 0:
        print("not root: the autograder runs without a container's bounds")
        return []
    subprocess.run(["cc", "-O1", "-o", work / "docker_like", ROOT / "tests/hostile/docker_like.c"], check=True)
    return [work / "docker_like"]


def check_gradescope(work, zip_file):
    root = work / "autograder"
    for name in ("source", "submission", "results"):
        (root / name).mkdir(parents=True)
    unpack(zip_file, root / "source")
    shutil.copy(root / "source/run_autograder", root / "run_autograder")
    start, surroundings = launcher(work), os.environ | {"AUTOGRADER_ROOT": str(root)}
    said = run([*start, root / "source/setup.sh"], env=surroundings)
    expect("mirror_direction        failed" in said, f"setup.sh: {said[-500:]}")
    results = root / "results/results.json"

    def graded(files, expected=0):
        shutil.rmtree(root / "submission")
        (root / "submission").mkdir()
        results.unlink(missing_ok=True)
        for name, text in files.items():
            (root / "submission" / name).write_text(text)
        said = run([*start, root / "run_autograder"], expected, env=surroundings)
        return json.loads(results.read_text()) if results.exists() else None, said

    result, said = graded({"moved.cpp": (SOLUTION / "moved.cpp").read_text(), "mirror_direction.cpp": WRONG_MIRROR})
    tests = {test["name"]: test for test in result["tests"]}
    expect(tests["moved"]["score"] == 2 == tests["moved"]["max_score"] and tests["moved"]["status"] == "passed", "a right fragment")
    expect(tests["mirror_direction"]["status"] == "failed" and tests["mirror_direction"]["output"], "a wrong fragment")
    expect(result["score"] == sum(t["score"] for t in result["tests"]), "the sum of the scores")
    expect(not start or "a user of its own for each step" in said, f"the sandbox is not the container's: {said[-300:]}")
    expect("seed 11" in said, "another seed than that of the archive")
    result, _ = graded({'odd "name".txt': "x"})
    expect(result["score"] == 0 and "holds no fragment" in result["output"], "a submission without a fragment")
    # neither a broken kit nor one that is not there is the student's fault
    (root / "source/kit/assignment.toml").write_text("broken")
    expect(graded({"moved.cpp": "x"}, 3)[0] is None, "a score where the assignment cannot be read")
    shutil.move(root / "source/kit/grader", root / "source/kit/away")
    expect(graded({"moved.cpp": "x"}, 3)[0] is None, "a score where the machine fails")


def check_workflow(work, kit):
    workflow = (kit / ".github/workflows/grade.yml").read_text()
    expect(workflow == (ROOT / "grader/kit/github/grade.yml").read_text(), "the kit's workflow is another one")
    steps = steps_of(workflow)
    expect(len(steps) == 2, f"steps: {steps}")
    shutil.copy(SOLUTION / "moved.cpp", kit / "starter/fragments")
    summary = work / "summary.md"
    said = ""
    for step in steps:
        # GitHub's way of running a step
        script = step.replace("./grade starter", "./grade starter moved shutter_time")
        said += run(["bash", "-e", "-o", "pipefail", "-c", script], cwd=kit, env=os.environ | {"GITHUB_STEP_SUMMARY": str(summary)})
    expect("::notice file=starter/fragments/shutter_time.cpp,line=1" in said, f"no annotation: {said[-400:]}")
    expect("| `moved` | passed | 2 of 2 |" in summary.read_text(), "no summary")
    for name in ("record.json", "junit.xml", "page/index.html"):
        expect((kit / name).is_file(), f"no {name} to keep")


def main():
    with tempfile.TemporaryDirectory(dir="/var/tmp") as work:
        work = pathlib.Path(work)
        work.chmod(0o755)
        run([GRADE, "hand-out", work / "kit", "--gradescope", work / "autograder.zip", "--seed", "11"])
        check_gradescope(work, work / "autograder.zip")
        check_workflow(work, work / "kit")
        run([GRADE, "hand-out", work / "other", "--seed", "1"], 2)
    end("Gradescope's autograder and the workflow do what they are for")


main()
