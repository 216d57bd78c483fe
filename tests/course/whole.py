"""A whole class: what class_test.py --all does."""

import collections
import os
import random
import re
import shutil
import signal
import subprocess
import time

from classes import archive, outcome, records, text
from helpers import BLANKS, ROOT, SOLUTION, cpu_seconds, expect, record_at, run, variant

FORMATS = "gradescope prairielearn junit actions annotations classroom50 csv canvas html terminal".split()
PARTS = 2


def variants_by_fragment():
    """The texts of all right and wrong ones."""
    variants = {}
    for kind in ("right", "wrong"):
        for patch in sorted((ROOT / "tests/variants" / kind).glob("*.patch")):
            fragment, content = variant(patch)
            variants.setdefault(fragment, []).append(content)
    return variants


def make_class(at, size, filled, fewer):
    """As Canvas names them: archives of all fragments, of which so many are filled in, or, where fewer is said, often fewer; some of
    them by a right or a wrong variant; the last is cut off. Returns how many of the others differ."""
    at.mkdir()
    draw = random.Random(1)
    variants = variants_by_fragment()
    names = sorted(path.stem for path in SOLUTION.glob("*.cpp"))
    different = set()
    for student in range(size):
        written = set(draw.sample(names, filled - draw.choice([0, 0, filled // 8, filled // 4, filled // 2] if fewer else [0])))
        files = {name: text(name) if name in written else (BLANKS / f"{name}.cpp").read_text() for name in names}
        for fragment in draw.sample(sorted(written & variants.keys()), min(len(written & variants.keys()), draw.randint(0, filled // 3 + 1))):
            files[fragment] = draw.choice(variants[fragment])
        late = "LATE_" if student % 9 == 0 else ""
        path = at / f"student{student:03}_{late}{1000 + student}_{2000 + student}_work.zip"
        content = archive(path, {f"starter/fragments/{name}.cpp": code for name, code in files.items()})
        if student == size - 1:
            path.write_bytes(content[:len(content) // 2])
        else:
            different.add(tuple(sorted(files.items())))
    return len(different)


def timed(command, expected=0):
    """What it says, its CPU seconds, and those by the clock."""
    before, start = cpu_seconds(), time.monotonic()
    said = run(command, expected)
    return said, cpu_seconds() - before, time.monotonic() - start


def kill(command, out, draw, longest):
    """Starts it and kills it after a while, or lets it end before. Nothing that was there may be lost, or be half."""
    before = {path.name for path in (out / "records").glob("*.json")}
    started = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        started.wait(timeout=draw.uniform(0, longest))
        killed = False
    except subprocess.TimeoutExpired:
        started.send_signal(signal.SIGKILL)
        started.wait()
        killed = True
    after = {path.name for path in (out / "records").glob("*.json")}
    expect(after >= before, "a record is lost")
    for name in after - before:
        expect(record_at(out / "records" / name)["complete"], "a record is not whole")
    return killed


def fill_disk(command, out):
    """Grades onto a disk for a few records, then there is more room."""
    if os.geteuid() != 0 or run(["mount", "-t", "tmpfs", "-o", "size=700k", "grade", out], (0, 1, 32)):
        print("no disk can be mounted here: it is not filled")
        return False
    said = run(command, 3)
    expect("No space left" in said or "the disk is full" in said, f"a full disk: {said[-600:]}")
    print(f"{len(list((out / 'records').glob('*.json')))} records fit on the disk that is full", flush=True)
    run(["mount", "-o", "remount,size=2g", out])
    return True


def grade_disturbed(grade, export, work, kills, longest):
    """In parts, one of them with one job and the other with two, killed all the time, the first onto a disk that is full at first;
    then they are put together."""
    draw = random.Random(2)
    killed = 0
    outs = [work / f"part{part}" for part in range(1, PARTS + 1)]
    mounted = []
    try:
        for part, out in enumerate(outs, 1):
            out.mkdir()
            command = [grade, "class", export, "-o", out, "--seed", "5", "--shard", f"{part}/{PARTS}", "--jobs", part]
            if part == 1 and fill_disk(command, out):
                mounted.append(out)
            killed += sum(kill(command, out, draw, longest) for _ in range(kills // PARTS))
            run(command)
        run([grade, "merge", work / "merged", *outs], 1)
    finally:
        for out in mounted:
            shutil.copytree(out, work / f"{out.name}-kept")
            run(["umount", out])
    print(f"killed {killed} times", flush=True)
    expect(killed > 0, "it was never killed")


def check_cost(grade, export, out, cpu, clock, size):
    """Every tenth submission alone takes as much as it does in the class."""
    some = sorted(path for path in export.iterdir())[:-1][::10]
    alone = sum(timed([grade, path, "--seed", "5", "--json", out.parent / "one.json"])[1] for path in some)
    (out.parent / "some").mkdir()
    for path in some:
        shutil.copy(path, out.parent / "some")
    together = timed([grade, "class", out.parent / "some", "-o", out.parent / "some-graded", "--seed", "5"])[1]
    print(f"CPU time: {cpu:.0f} s for {size}; {len(some)} of them take {alone:.1f} s one by one and {together:.1f} s as a class: "
          f"{together / alone:.2f} of it; by the clock, the class takes {clock * os.cpu_count() * len(some) / (size * alone):.2f} "
          f"of {size} submissions' CPU time over {os.cpu_count()} cores", flush=True)
    expect(together <= 1.1 * alone, "a class takes more than its submissions one by one, and a tenth")


def with_other_points(grade, work):
    """The words that call a grader for which two fragments have other points: a project of its own, or, installed, a copy."""
    project = work / "project"
    if (grade.parent / "toolchain.toml").exists():
        shutil.copytree(grade.parents[2], project)
        words = [project / "grade"]
    else:
        project.mkdir()
        for path in ROOT.iterdir():
            if path.name not in ("build", "assignment.toml", ".git"):
                (project / path.name).symlink_to(path)
        chain = (grade.parent.parent / "toolchain.toml").read_text()
        (work / "toolchain.toml").write_text(re.sub(r'^source = ".*"', f'source = "{project}"', chain, flags=re.MULTILINE))
        words = [grade, "--toolchain", work / "toolchain.toml"]
    assignment = (ROOT / "assignment.toml").read_text()
    for name, points in [("mirror_direction", 4), ("phong", 1)]:
        assignment, count = re.subn(rf'(name = "{name}", points = )\d+', rf"\g<1>{points}", assignment)
        expect(count == 1, f"{name} is not in assignment.toml")
    (project / "assignment.toml").write_text(assignment)
    return words


def check_points_changed(grade, export, out, work):
    """Who passes the two rises or falls by that, and nothing else changes."""
    run([*with_other_points(grade, work), "class", export, "-o", work / "regraded", "--seed", "5"], 1)
    said = run([grade, "compare", out, work / "regraded"], 1)
    changed = collections.Counter()
    for path in sorted((out / "submissions").glob("*.json")):
        before, after = record_at(path), record_at(work / "regraded/submissions" / path.name)
        for a, b in zip(before["fragments"], after["fragments"], strict=True):
            expect(a["verdict"] == b["verdict"], f"{path.stem}: another verdict on {a['name']}")
            same = abs(a["points"] * b["max_points"] - b["points"] * a["max_points"]) < 1e-9
            expect(same, f"{path.stem}: {a['name']} has {b['points']} of {b['max_points']}, was {a['points']} of {a['max_points']}")
        changed[(after["score"] > before["score"]) - (after["score"] < before["score"])] += 1
    words = f"{changed[1]} rise, {changed[-1]} fall"
    expect(words in said, f"compare does not say: {words}: {said[-300:]}")
    print(f"points changed: {words}", flush=True)


def check_whole(grade, work, size, kills, filled, fewer):
    export, out = work / "class", work / "graded"
    different = make_class(export, size, filled, fewer)
    said, cpu, clock = timed([grade, "class", export, "-o", out, "--seed", "5"], 1)
    cores, load = os.cpu_count(), os.getloadavg()[0]
    expect(f"{size} submissions, {size - 1} graded" in said, f"the class: {said[-500:]}")
    print(f"{re.search('.* submissions, .* graded.*', said)[0]}; {clock:.0f} s by the clock on {cores} cores at a load of {load:.0f}", flush=True)
    check_cost(grade, export, out, cpu, clock, size - 1)
    grade_disturbed(grade, export, work, kills, 3 * clock / size)
    expect(outcome(work / "merged") == outcome(out), "another outcome in parts, after SIGKILL and a full disk")
    expect(len(records(out)) == different, f"{len(records(out))} records of {different} submissions that differ")
    for path in sorted((out / "submissions").glob("*.json")):
        for kind in FORMATS:
            run([grade, "convert", path, "--to", kind, "-o", work / f"converted.{kind}"])
    print(f"converted to {len(FORMATS)} formats", flush=True)
    check_points_changed(grade, export, out, work)
