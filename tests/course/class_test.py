#!/usr/bin/env python3
"""A class: class_test.py [--all] [--size N] [--kills N] [--filled N] [--whole] [--keep DIR] GRADE

Fast: submissions as Canvas, Moodle, Blackboard, Gradescope and repositories have them, of few fragments each: who they are of,
which of several is taken, what is wrong with those that cannot be graded, and that they are told; the same records whatever the
number of jobs and shards, and after SIGKILL; tables, pages, twins, comparison.

--all: a class of 60 (--size) made of the project's variants (tests/variants), with all (--filled) fragments filled in at most; with
--whole, everybody has filled in as many.
Graded whole; in parts, with other numbers of jobs, onto a disk that is full at first, and killed at 50 (--kills) random moments:
the same outcome. All records in all formats; regraded after points have changed; what it costs beside its submissions one by one.
"""

import argparse
import pathlib
import random
import re
import signal
import subprocess
import tarfile
import tempfile
import time

from classes import WRONG_MIRROR, archive, folder, outcome, rows, text
from helpers import BLANKS, ROOT, SOLUTION, end, expect, record_at, run
from trial import check_trial
from whole import check_whole


def small_class(at):
    """An export of every kind in one folder."""
    at.mkdir()
    right, mirror = {"moved.cpp": text("moved")}, {"fragments/mirror_direction.cpp": WRONG_MIRROR}
    inner = archive(at / "inner.zip", right)
    (at / "inner.zip").unlink()
    archive(at / "doejane_12345_678_work.zip", mirror)
    archive(at / "doejane_12345_701_work-1.zip", {"my work/inner.zip": inner})
    with tarfile.open(at / "roejim_LATE_222_702_work.tar.gz", "w:gz") as out:
        out.add(SOLUTION / "shutter_time.cpp", "HW Grüße/shutter_time.cpp")
    folder(at / "Zoë Müller_77_assignsubmission_file_", {"fragments/moved.cpp": text("moved")} | mirror)
    for when, content in [("30", WRONG_MIRROR), ("31", text("mirror_direction"))]:
        (at / f"Assignment 1_jsmith_attempt_2026-01-{when}-12-00-00_mirror_direction.cpp").write_text(content)
    (at / "Assignment 1_jsmith_attempt_2026-01-31-12-00-00.txt").write_text("Name: J. Smith\n")
    folder(at / "submission_9", {"Moved.cpp": text("moved")})
    (at / "submission_metadata.yml").write_text(
        "---\nsubmission_9:\n  :submitters:\n  - :name: '=Eve \"E\" <b>'\n    :sid: '4711'\n    :email: e@x\n  :created_at: 2026\n")
    renamed = text("phong").replace("mirrored", "bounced").replace("highlight", "shine") + "// mine\n"
    for name, phong in [("alice", text("phong")), ("bob", renamed), ("carol", None)]:
        folder(at / f"hw1-{name}", {"starter/fragments/phong.cpp": phong} if phong else {"readme.md": "x"})
    (at / "hw1-broken.zip").write_bytes(b"PK\x03\x04 no archive")


def grade_killed(command, out, kills, longest):
    """Kills the grading at random moments, then lets it end."""
    draw = random.Random(2)
    killed = 0
    for _ in range(kills):
        before = len(list((out / "records").glob("*.json")))
        started = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        # once the first record is there, and a while after: before that nothing can be lost
        while started.poll() is None and len(list((out / "records").glob("*.json"))) == before:
            time.sleep(0.02)
        try:
            started.wait(timeout=draw.uniform(0, longest))
        except subprocess.TimeoutExpired:
            started.send_signal(signal.SIGKILL)
            started.wait()
            killed += 1
        after = len(list((out / "records").glob("*.json")))
        expect(after >= before, "a record is lost")
        for path in (out / "records").glob("*.json"):
            expect(record_at(path)["complete"], "a record is not whole")
    expect(killed > 0, "it was never killed")
    print(f"killed {killed} times", flush=True)
    return run(command, 1)


def check_tables(grade, work, export, out):
    """The first grading of the class: what it says, its tables and its pages."""
    said = run([grade, "class", export, "-o", out, "--seed", "5", "--jobs", "2"], 1)
    table = {row["student"]: row for row in rows(out / "class.csv")}
    points = {name: row["points"] for name, row in table.items()}
    expected = {"doejane": "2", "roejim": "2", "Zoë Müller": "2", "jsmith": "2", "'=Eve \"E\" <b>": "0", "alice": "3", "bob": "3",
                "carol": "", "broken": ""}
    expect(points == expected, f"points are {points}, expected {expected}")
    expect(table["doejane"]["id"] == "12345" and "work-1.zip was taken" in table["doejane"]["notes"], "the later of two")
    expect(table["roejim"]["late"] == "late" and not table["doejane"]["late"], "who is late")
    expect(table["'=Eve \"E\" <b>"]["id"] == "4711", "Gradescope's number of a student")
    expect("cannot be unpacked" in table["broken"]["notes"] and "holds no fragment" in table["carol"]["notes"], "what is wrong")
    expect(str(work) not in (out / "class.csv").read_text(), "a path of this machine in the table")
    expect("9 submissions, 7 graded" in said and "; cannot be read: hw1-broken.zip, hw1-carol\n" in said, f"the terminal: {said}")
    expect(re.search(r"^[1-6] of 7(, about [1-9]\d* s left)?$", said, re.MULTILINE), f"where there is no terminal nobody hears how far it is: {said}")
    eve = record_at(out / "submissions/submission_9.json")
    moved = next(f for f in eve["fragments"] if f["name"] == "moved")
    expect("there is Moved.cpp: rename it" in moved["message"], f"a name that is nearly right: {moved['message']}")
    possible, *canvas = rows(out / "canvas.csv")
    expect([row["ID"] for row in canvas] == ["12345", "222"] and "Points Possible" in possible["Student"], "Canvas's table")
    expect([row["Identifier"] for row in rows(out / "moodle.csv")] == ["Participant 77"], "Moodle's table")
    for path in (out / "submissions").glob("*.json"):
        run([grade, "convert", path, "--to", "csv", "-o", work / "one.csv"])
        row, = rows(work / "one.csv")
        expect(row == table[row["student"]], f"{path.name}: another row than the class has: {row}")
    expect("no ID of Moodle's" in run([grade, "convert", out / "submissions/hw1-bob.json", "--to", "moodle"], 2), "whom Moodle does not know")
    expect((out / "submissions/Zoë_Müller_77_assignsubmission_file_.html").is_file(), "a page's name has lost letters")
    page = (out / "index.html").read_text()
    expect("<b>" not in re.sub(r"<b>[\d.]+</b>", "", page) and "&lt;b&gt;" in page, "a name's markup in the page")
    twins = page[page.index('<h2 id="twins">'):page.index("class.csv")]
    expect("alice" in twins and "bob" in twins and "jsmith" not in twins, "twins: the same but for names and comments")
    expect("mirror_direction" in page[page.index('<h2 id="frequent-mistakes">'):page.index('<h2 id="twins">')], "a mistake")
    for link in re.findall(r'href="([^"#:]+)"', page):
        expect((out / link).is_file(), f"the page links {link}, which is not there")


def check_again(grade, work, export, out):
    """Again: nothing is graded; one at a time, in parts, and killed: the same."""
    expect("0 graded now, 7 as before" in (said := run([grade, "class", export, "-o", out], 1)), f"graded again: {said}")
    one = work / "one"
    run([grade, "class", export, "-o", one, "--seed", "5", "--jobs", "1"], 1)
    expect(outcome(one) == outcome(out), "another outcome with one job")
    for part in ("1/2", "2/2"):
        run([grade, "class", export, "-o", work / f"part{part[0]}", "--seed", "5", "--shard", part])
    expect("not graded yet" in (work / "part1/class.csv").read_text(), "a part of the class is all of it")
    run([grade, "merge", work / "half", work / "part1"], 3)
    run([grade, "merge", work / "whole", work / "part1", work / "part2"], 1)
    expect(outcome(work / "whole") == outcome(out), "another outcome in two parts")
    (work / "killed/records").mkdir(parents=True)
    grade_killed([grade, "class", export, "-o", work / "killed", "--seed", "5", "--jobs", "1"], work / "killed", 2, 0.2)
    expect(outcome(work / "killed") == outcome(out), "another outcome after SIGKILL")

    # one that cannot be written costs its submission alone, and the same call grades it
    first = sorted((one / "records").glob("*.json"))[0]
    first.unlink()
    first.mkdir()
    said = run([grade, "class", export, "-o", one], 3)
    expect(re.search(r"9 submissions, 6 graded.*; not graded yet: \S", said) and "not graded: " in said, f"one that failed: {said}")
    first.rmdir()
    expect("1 graded now, 6 as before" in run([grade, "class", export, "-o", one], 1), "what failed is not graded by the same call")

    # a record that a full disk has cut off is graded again
    first.write_text(first.read_text()[:500])
    expect("1 graded now, 6 as before" in run([grade, "class", export, "-o", one], 1), "a broken record is taken")
    expect(outcome(one) == outcome(out), "another outcome after a broken record")


def check_regrade(grade, work, export, out):
    (export / "hw1-alice/starter/fragments/phong.cpp").write_text((BLANKS / "phong.cpp").read_text())
    folder(export / "hw1-carol", {"moved.cpp": text("moved")})
    after = work / "after"
    run([grade, "class", export, "-o", after, "--seed", "5"], 1)
    said = run([grade, "compare", out, after, "--better", work / "better.csv"], 1)
    expect("alice: 0, was 3 (-3)" in said and "phong: not started, was passed" in said, f"compare: {said}")
    expect("carol: 2, was none (+2)" in said and "1 rise, 1 fall, 7 as before" in said, f"compare: {said}")
    better = {row["student"]: row["points"] for row in rows(work / "better.csv")}
    expect(better["alice"] == "3" and better["carol"] == "2", f"the better of both: {better}")
    run([grade, "compare", out, out])
    file = next(path for path in (out / "submissions").glob("hw1-bob*.json"))
    run([grade, "verify", file, export / "hw1-bob"])
    run([grade, "compare", out, file], 2)


def check_small(grade, work):
    export, out = work / "export", work / "out"
    small_class(export)
    check_tables(grade, work, export, out)
    check_again(grade, work, export, out)
    check_regrade(grade, work, export, out)
    run([grade, "class", work / "none"], 2)
    run([grade, "class", export, "-o", work / "x", "--shard", "3/2"], 2)
    expect("--shard needs --seed" in run([grade, "class", export, "-o", work / "x", "--shard", "1/2"], 2), "a part without a seed")
    run([grade, "merge", work / "x", export], 2)


def check_whose(grade, work):
    """In a tree with an assignment of its own, a grader says whose assignment counts; in its own, and beside a copy, it does not."""
    mine, theirs, copy = (ROOT / "assignment.toml").read_text(), work / "theirs", work / "copy"
    folder(theirs, {"assignment.toml": mine.replace("points = 2", "points = 5"), "deep/moved.cpp": text("moved")})
    folder(copy, {"assignment.toml": mine, "moved.cpp": text("moved")})
    words = f"{theirs / 'assignment.toml'} is another one"
    graded = lambda place: run([grade, "class", copy, "-o", work / "whose", "--seed", "5"], 1, cwd=place)
    expect((said := graded(theirs / "deep")).count(words) == 1, f"whose assignment counts: {said}")
    for place in (copy, ROOT, work):
        expect("another one" not in (said := graded(place)), f"told in {place}: {said}")
    expect(words in run([grade, "describe", "--handed-out", work / "handout.md"], cwd=theirs), "describe says nothing")


def check_pictures(grade, work):
    """Only on request, and then for what has been graded without them as well; the record stays as it is."""
    export, out = work / "drawn", work / "drawn-out"
    folder(export / "hw1-pia", {"phong.cpp": text("phong").replace("material.shininess *", "material.shininess / 2 *")})
    command = [grade, "class", export, "-o", out, "--seed", "5"]
    run(command)
    expect(not (out / "canvas.csv").exists() and "canvas.csv" not in (out / "index.html").read_text(), "a table for Canvas without an ID")
    page, record = out / "submissions/hw1-pia.html", next((out / "records").glob("*.json"))
    bare, written = page.read_text(), record.stat().st_mtime_ns
    expect("data:image/png" not in bare, "pictures that nobody asked for")
    expect("1 graded now" in run([*command, "--pictures"]), "what has no pictures is not graded again")
    drawn = page.read_text()
    expect(drawn.count("data:image/png") >= 3 and 'alt="the right picture' in drawn, "no pictures")
    expect(record.stat().st_mtime_ns == written, "the record is written again")
    expect("1 as before" in run([*command, "--pictures"]) and page.read_text() == drawn, "pictures are drawn twice")
    expect("1 as before" in run(command) and page.read_text() == drawn, "pictures that are there are not shown")
    run([grade, "merge", work / "drawn-merged", out])
    expect((work / "drawn-merged/submissions/hw1-pia.html").read_text() == drawn, "pictures are lost where parts are put together")


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("grade", type=pathlib.Path)
    words.add_argument("--all", action="store_true")
    words.add_argument("--size", type=int, default=60)
    words.add_argument("--kills", type=int, default=50)
    words.add_argument("--filled", type=int, default=len(list(SOLUTION.glob("*.cpp"))))
    words.add_argument("--whole", action="store_true")
    words.add_argument("--keep", type=pathlib.Path, help="leave everything in this new folder")
    asked = words.parse_args()
    with tempfile.TemporaryDirectory() as work:
        work = asked.keep or pathlib.Path(work)
        work.mkdir(exist_ok=True)
        if asked.all:
            check_whole(asked.grade.absolute(), work, asked.size, asked.kills, asked.filled, not asked.whole)
        else:
            check_small(asked.grade.absolute(), work)
            check_trial(asked.grade.absolute(), work)
            check_pictures(asked.grade.absolute(), work)
            check_whose(asked.grade.absolute(), work)
    end("a class is graded, in parts, again, and after SIGKILL, to the same records")


main()
