#!/usr/bin/env python3
"""One record, all formats: formats_test.py GRADE

Real records hold to their schema, and their page names every field; each format of `grade convert` holds to the rules of who
reads it; an older record, a broken one and one that is not complete are refused with a sentence.
"""

import csv
import hashlib
import io
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import xml.etree.ElementTree as xml

from classes import WRONG_MIRROR
from helpers import BLANKS, ROOT, SOLUTION, end, expect, record_at, run, timeless, validator

GRADE = pathlib.Path(sys.argv[1]).absolute()
HOSTILE = '// <script>alert(1)</script> =cmd|"/c calc" \\x1b[2J\n#error "]]> <b>&lt; | `x` %0A::set-env name=A::B\x1b[2J"\n'


def submission(folder):
    """A right, a wrong, a blank and a hostile fragment, and one that crashes."""
    folder.mkdir()
    shutil.copy(SOLUTION / "moved.cpp", folder)
    shutil.copy(BLANKS / "shutter_time.cpp", folder)
    (folder / "mirror_direction.cpp").write_text(WRONG_MIRROR)
    (folder / "uniform_disk.cpp").write_text(
        '#include "rt/fragments.h"\n#include <cstdlib>\nnamespace rt { DiskSample uniform_disk(vec2) { std::abort(); } }\n')
    (folder / "point_irradiance.cpp").write_text(HOSTILE)
    return ["moved", "shutter_time", "mirror_direction", "uniform_disk", "point_irradiance"]


def keys_of(value):
    if isinstance(value, dict):
        for key, child in value.items():
            yield key
            yield from keys_of(child)
    elif isinstance(value, list):
        for child in value:
            yield from keys_of(child)


def check_record(record, folder):
    if schema := validator():
        errors = [f"{'/'.join(map(str, e.path))}: {e.message[:200]}" for e in schema.iter_errors(record)]
        expect(not errors, f"the record does not hold to its schema: {errors[:5]}")
        for key in ("seed", "score", "grader"):
            expect(list(schema.iter_errors({k: v for k, v in record.items() if k != key})), f"the schema misses no {key}")
        expect(list(schema.iter_errors(record | {"more": 1})), "the schema takes any field")
    page = (ROOT / "grader/record/README.md").read_text()
    for key in sorted(set(keys_of(record))):
        expect(re.search(rf"`[^`]*\b{key}\b[^`]*`", page), f"grader/record/README.md does not name {key}")
    for fragment in record["fragments"]:
        text = folder / f"{fragment['name']}.cpp"
        expect(fragment["sha256"] == hashlib.sha256(text.read_bytes()).hexdigest(), f"{text.name}: another hash than sha256sum's")
        sums = sum(check["points"] for check in fragment["checks"])
        expect(abs(sums - fragment["points"]) < 0.01, f"{fragment['name']}: its checks have {sums} points")
        most = sum(check["max_points"] for check in fragment["checks"])
        expect(abs(most - fragment["max_points"]) < 1e-9, f"{fragment['name']}: its checks are worth {most} points")
    names = [f["name"] for f in record["fragments"]]
    lines = "".join(f"{f['sha256']}  {f['name']}.cpp\n" for f in record["fragments"])
    expect(record["submission"]["sha256"] == hashlib.sha256(lines.encode()).hexdigest(), "another hash of the submission")
    expect(sorted(record["selection"]) == sorted(names), "the selection is not in the record")


def check_gradescope(text, record):
    result = json.loads(text)
    expect(result["score"] == record["score"] and isinstance(result["execution_time"], (int, float)), "Gradescope: score, time")
    expect(sum(t["score"] for t in result["tests"]) == result["score"], "Gradescope: the tests' scores are not the sum")
    for test in result["tests"]:
        expect(all(isinstance(test[k], (int, float)) for k in ("score", "max_score")), "Gradescope: scores are numbers")
        expect(isinstance(test["number"], str) and re.fullmatch(r"\d+\.\d+", test["number"]), "Gradescope: numbers are texts")
        expect(test["status"] in ("passed", "failed"), "Gradescope: status")
        expect(test["visibility"] in ("visible", "hidden", "after_due_date", "after_published"), "Gradescope: visibility")
        expect(test["output_format"] in ("text", "html", "simple_format", "md", "ansi"), "Gradescope: output_format")
        expect("\x1b" not in test["output"], "Gradescope: control characters")


def check_prairielearn(text, record):
    result = json.loads(text)
    expect(result["gradable"] is True and abs(result["score"] - record["score"] / record["max_score"]) < 1e-12, "PrairieLearn: score")
    for test in result["tests"]:
        expect(set(test) == {"name", "description", "points", "max_points", "message", "output", "images"}, "PrairieLearn: fields")
        expect(0 <= test["points"] <= test["max_points"] and test["images"] == [], "PrairieLearn: points")


def check_junit(path, record):
    """By the rules of Jenkins' schema: attributes, order of elements, counts; then by a reader of its own, if there is one."""
    root = xml.parse(path).getroot()
    expect(root.tag == "testsuites", "JUnit: no testsuites")
    totals = {"tests": 0, "failures": 0, "errors": 0, "skipped": 0}
    for suite in root:
        expect(suite.tag == "testsuite" and suite.get("name"), "JUnit: a suite without a name")
        expect(re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d", suite.get("timestamp") or ""), "JUnit: timestamp")
        expect([e.tag for e in suite][0] == "properties" and {e.tag for e in suite[1:]} == {"testcase"}, "JUnit: order")
        cases = suite.findall("testcase")
        have = {"tests": len(cases), "failures": len(suite.findall("testcase/failure")),
                "errors": len(suite.findall("testcase/error")), "skipped": len(suite.findall("testcase/skipped"))}
        for key, count in have.items():
            expect(int(suite.get(key)) == count, f"JUnit: {key} of {suite.get('name')}")
            totals[key] += count
        properties = {p.get("name"): p.get("value") for p in suite.iter("property")}
        fragment = next(f for f in record["fragments"] if f"{f['part']}.{f['name']}" == suite.get("name"))
        expect(float(properties["points"]) == round(fragment["points"], 2), "JUnit: points")
        kind = {"passed": None, "failed": "failure", "not_finite": "failure", "not_started": "skipped"}.get(fragment["verdict"], "error")
        found = {e.tag for case in cases for e in case}
        expect((kind is None and not found) or kind in found, f"JUnit: {fragment['name']} is {fragment['verdict']}, has {found}")
        expect(all(c.get("classname") and c.get("name") and float(c.get("time")) >= 0 for c in cases), "JUnit: a case's attributes")
    expect(all(int(root.get(k)) == v for k, v in totals.items()), "JUnit: totals")
    try:
        import junitparser
    except ImportError:
        return
    read = junitparser.JUnitXml.fromfile(str(path))
    expect((read.tests, read.failures, read.errors, read.skipped) == tuple(totals.values()), "JUnit: junitparser counts otherwise")


def check_actions(summary, commands, record):
    expect(len(summary.encode()) < 2**20, "Actions: the summary is too large")
    expect("<script" not in summary and "\x1b" not in summary, "Actions: markup of a submission in the summary")
    rows = [line for line in summary.splitlines() if line.startswith("| `")]
    expect(len(rows) == len(record["fragments"]) and all(row.count("|") == 5 for row in rows), "Actions: rows of the table")
    lines = commands.splitlines()
    expect(0 < len(lines) <= 10, f"Actions: {len(lines)} annotations")
    pattern = re.compile(r"::(error|notice|warning) (file=[^:,]+,line=\d+,)?title=[^:,]*::[^\r\n]*")
    expect(all(pattern.fullmatch(line) for line in lines), f"Actions: {lines}")
    expect(any("point_irradiance.cpp,line=2," in line for line in lines), "Actions: the line of the error")
    expect(not any("::set-env" in line[2:] and line.startswith("::set-env") for line in lines), "Actions: a command of a submission")


def check_classroom(text, record):
    result = json.loads(text)
    expect(result["schema"] == "classroom50/result/v1" and result["classroom"] == "cs1" and result["assignment"] == "rays", "Classroom 50: identity")
    for key in ("submission", "commit", "release", "review", "datetime", "graded_at"):
        expect(isinstance(result[key], str) and result[key], f"Classroom 50: {key}")
    expect(re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", result["graded_at"]), "Classroom 50: graded_at")
    expect(type(result["score"]) is int and type(result["max-score"]) is int, "Classroom 50: whole scores")
    expect(result["score"] == sum(t["score"] for t in result["tests"]) == round(100 * record["score"]), "Classroom 50: the sum")
    expect(all(type(t["score"]) is int and type(t["passed"]) is bool for t in result["tests"]), "Classroom 50: tests")


def rows_of(text):
    return list(csv.DictReader(io.StringIO(text, newline="")))


def check_tables(convert, file, record):
    row, = rows_of(convert("csv"))
    expect(float(row["points"]) == record["score"] and row["seed"] == "7", "CSV: points, seed")
    expect(all(float(row[f["name"]]) == round(f["points"], 2) for f in record["fragments"]), "CSV: a column for each fragment")
    possible, row = rows_of(convert("canvas"))
    expect(list(row)[:5] == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"], "Canvas: columns")
    expect(possible["Student"].strip() == "Points Possible", "Canvas: no row of possible points")
    expect(row["ID"] == "12345" and float(row[list(row)[5]]) == record["score"], "Canvas: student and points")
    moodles = json.loads(file.read_text())
    moodles["submission"]["name"] = "Jane Doe_12345_assignsubmission_file_"
    (file.parent / "moodle.json").write_text(json.dumps(moodles))
    expect("no ID of Moodle's" in run([GRADE, "convert", file, "--to", "moodle"], 2), "a Canvas ID for Moodle's participant")
    row, = rows_of(moodle := run([GRADE, "convert", file.parent / "moodle.json", "--to", "moodle"]))
    expect(set(row) >= {"Identifier", "Full name", "Grade", "Maximum Grade", "Feedback comments"}, "Moodle: columns")
    expect(row["Identifier"] == "Participant 12345" and float(row["Grade"]) == record["score"], "Moodle: participant and grade")
    for kind, text in [("csv", convert("csv")), ("canvas", convert("canvas")), ("moodle", moodle)]:
        for row in csv.reader(io.StringIO(text, newline="")):
            expect(not any(len(cell) > 1 and cell[0] in "=+-@\t" for cell in row), f"{kind}: a formula")


def check_hidden(record, work):
    hidden = json.loads(json.dumps(record))
    hidden["fragments"][0]["visibility"] = "hidden"
    (work / "hidden.json").write_text(json.dumps(hidden))
    result = json.loads(run([GRADE, "convert", work / "hidden.json", "--to", "gradescope"]))
    expect(result["tests"][0]["visibility"] == "hidden" and "no total" in result["output"], "Gradescope: a hidden test")
    expect(str(record["score"]) not in result["output"], "Gradescope: the words tell a score that is hidden")
    expect(record["fragments"][0]["name"] not in run([GRADE, "convert", work / "hidden.json", "--to", "annotations"]), "Actions: a hidden result")


def check_no_record(record, file, work):
    old = work / "old.json"
    old.write_text(json.dumps(record | {"schema": "penumbra/result/v1"}))
    expect("a record of an older grader" in run([GRADE, "convert", old, "--to", "csv"], 2), "an older record is taken")
    for change, words in [({"complete": False, "fragments": []}, "not complete"), ({"fragments": 3}, "/fragments is no such thing"),
                          ({"seed": "x"}, "/seed"), ({"limits": {}}, "/limits/time_limit is missing")]:
        old.write_text(json.dumps(record | change))
        expect(words in run([GRADE, "convert", old, "--to", "csv"], 2), f"a record with {change} is not refused")
    old.write_text("{")
    expect("is no record" in run([GRADE, "convert", old, "--to", "csv"], 2), "a broken record is taken")
    run([GRADE, "convert", file, "--to", "pdf"], 2)


def check_again(record, file, folder, work):
    """The same submission again, then another one."""
    expect("the same points and verdicts" in run([GRADE, "verify", file, folder]), "verify: the same")
    run([GRADE, "replay", file, folder, "-o", work / "again.json"])
    same = lambda r: timeless(r) | {"command": "", "submission": ""}
    expect(same(record_at(work / "again.json")) == same(record), "replay: another record")
    before = file.read_bytes()
    run([GRADE, "replay", file, folder, "-o", file], 2)
    expect(file.read_bytes() == before, "replay overwrites a record")
    expect("0 -> 0" not in run([GRADE, "compare", file, work / "again.json"]), "compare: what is the same")
    shutil.copy(BLANKS / "moved.cpp", folder)
    expect("other texts" in run([GRADE, "verify", file, folder], 2), "verify: other texts")
    run([GRADE, "replay", file, folder, "-o", work / "third.json"])
    said = run([GRADE, "compare", file, work / "third.json"], 1)
    expect("moved: not started, was passed; another text" in said, f"compare: {said}")
    broken = json.loads(file.read_text())
    broken["fragments"][0]["verdict"] = "failed"
    (work / "forged.json").write_text(json.dumps(broken))
    shutil.copy(SOLUTION / "moved.cpp", folder)
    run([GRADE, "verify", work / "forged.json", folder], 1)


def main():
    with tempfile.TemporaryDirectory() as work:
        work = pathlib.Path(work)
        folder = work / "doejane_12345_678_work"
        names = submission(folder)
        file = work / "record.json"
        run([GRADE, folder, *names, "--seed", "7", "--json", file])
        record = record_at(file)
        check_record(record, folder)
        # one submission is no class: its fragments are no students
        expect("the folder above it" in run([GRADE, "class", folder, "-o", work / "class"], expected=2),
               "the folder of one submission is taken for a class")
        environment = os.environ | {"CLASSROOM": "cs1", "ASSIGNMENT": "rays"}

        def convert(kind):
            out = work / f"out.{kind}"
            run([GRADE, "convert", file, "--to", kind, "-o", out], env=environment)
            # the same on stdout
            said = run([GRADE, "convert", file, "--to", kind], env=environment)
            expect(said == out.read_text(), f"{kind}: -o and stdout differ")
            return out.read_bytes().decode()

        check_gradescope(convert("gradescope"), record)
        check_prairielearn(convert("prairielearn"), record)
        convert("junit")
        check_junit(work / "out.junit", record)
        check_actions(convert("actions"), convert("annotations"), record)
        check_classroom(convert("classroom50"), record)
        check_tables(convert, file, record)
        page = convert("html")
        expect("<script>alert" not in page and all(f'id="{name}"' in page for name in names), "the page")
        table = convert("terminal")
        expect(all(name in table for name in names) and "\x1b" not in table, "the table")
        said = run([GRADE, folder, *names, "--seed", "7"])
        for line in table.splitlines():
            expect(line in said or "Efficiency" in line, f"the converted table says: {line}")
        check_hidden(record, work)
        check_no_record(record, file, work)
        check_again(record, file, folder, work)
    end("one record, all formats")


main()
