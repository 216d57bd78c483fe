#!/usr/bin/env python3
"""A class on a Slurm cluster: slurm_test.py GRADE

The two lines at the head of grader/class/slurm.sbatch, on a cluster of three virtual nodes (munged, slurmctld, slurmd in a
temporary folder). A node is killed while it grades: its task starts again on another, keeps what it had graded, and the
class is that of one machine. Exit status 77: there is no Slurm here.
"""

import os
import pathlib
import sys
import tempfile

from classes import light_class, outcome, records
from cluster import cluster
from helpers import ROOT, end, expect, run

GRADE = pathlib.Path(sys.argv[1]).absolute()
PARTS, SIZE = 3, 9


def submit(folder, *words):
    return run(["sbatch", "--parsable", *words], cwd=folder).strip().split(";")[0]


def kill_one_at_work(machines, out):
    """Kills the node of a part that has graded one submission and not yet all; the part, and what it had."""
    found = []

    def at_work():
        for job in machines.jobs():
            if job["JobState"] != "RUNNING" or "ArrayTaskId" not in job:
                continue
            part = out / f"parts/{job['ArrayTaskId']}-of-{PARTS}"
            done = sorted((part / "records").glob("*.json"))
            if 1 <= len(done) < SIZE / PARTS:
                found.extend([job["NodeList"], part, {path.name: path.stat().st_mtime_ns for path in done}])
                return True
        return False

    machines.until(at_work, "a part that has graded some of its submissions", 300)
    machines.kill_node(found[0])
    return found


def check(machines, work):
    export, out, alone = work / "export", work / "out", work / "alone"
    light_class(export, SIZE)
    os.environ["GRADE"] = str(GRADE)
    script = ROOT / "grader/class/slurm.sbatch"
    machines.ready()
    array = submit(work, f"--array=1-{PARTS}", script, export, out, "5")
    merging = submit(work, f"--dependency=afterany:{array}", script, out)
    node, part, before = kill_one_at_work(machines, out)
    # meanwhile the whole class on this machine
    run([GRADE, "class", export, "-o", alone, "--seed", "5", "--jobs", "1"])
    over = ("COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL")
    machines.until(lambda: all(job["JobState"] in over for job in machines.jobs()), "the end of all jobs", 600)

    jobs = {job["JobId"]: job for job in machines.jobs()}
    tasks = [job for job in jobs.values() if job.get("ArrayJobId") == array]
    expect(len(tasks) == PARTS, f"{len(tasks)} tasks")
    expect(all(job["ExitCode"] == "0:0" for job in jobs.values()), f"exit codes: {[job['ExitCode'] for job in jobs.values()]}")
    expect(merging in jobs, "the job that merges is not there")
    again = [job for job in tasks if job["Restarts"] != "0"]
    expect(len(again) == 1 and again[0]["NodeList"] != node, f"who has started again, and where: {again}; {node} was killed")
    log = (work / f"grade-{array}-{part.name[0]}.log").read_text()
    expect(f"{len(before)} as before" in log, f"the second start does not go on from the first: {log[-400:]}")
    same = all((part / "records" / name).stat().st_mtime_ns == when for name, when in before.items())
    expect(same, "what was graded before is graded again")
    expect(outcome(out) == outcome(alone), "another outcome than that of one machine")
    expect(len(records(out)) == SIZE, f"{len(records(out))} records of {SIZE} submissions that differ")
    said = run(["bash", script, export], 2, env=os.environ | {"SLURM_ARRAY_TASK_ID": "1"})
    expect("expected SUBMISSIONS OUT SEED" in said, f"too few words: {said}")


def main():
    with tempfile.TemporaryDirectory(prefix="slurm-") as work:
        work = pathlib.Path(work)
        work.chmod(0o755)
        machines = cluster(work / "cluster", PARTS)
        try:
            check(machines, work)
        finally:
            machines.stop()
    end("a class on a Slurm cluster, one of whose nodes is killed, is that of one machine")


main()
