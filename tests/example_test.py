#!/usr/bin/env python3
"""Grades the example submission: each fragment must get the verdict that the table in tests/example/README.md says.

    tests/example_test.py GRADE
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

example = pathlib.Path(__file__).resolve().parent / "example"
verdicts = ["passed", "failed", "not started", "did not build", "crashed", "timed out", "not finite"]


def table():
    """The verdict of each fragment that the table names."""
    expected = {}
    for line in (example / "README.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if len(cells) != 3 or not cells[0].startswith("`"):
            continue
        verdict = next(v for v in verdicts if cells[2].startswith(v))
        expected.update({name: verdict.replace(" ", "_") for name in re.findall(r"`(\w+)`", cells[0])})
    return expected


def main():
    with tempfile.TemporaryDirectory() as work:
        file = pathlib.Path(work) / "record.json"
        done = subprocess.run([sys.argv[1], example, "--seed", "1", "--json", file], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"grade ended with {done.returncode}:\n{done.stdout}{done.stderr}")
        record = json.loads(file.read_text())

    expected = table()
    wrong = 0
    for fragment in record["fragments"]:
        verdict = expected.get(fragment["name"], "passed")
        if fragment["verdict"] != verdict:
            wrong += 1
            print(f"{fragment['name']}: {fragment['verdict']}, expected {verdict}: {fragment['message']}")
        elif verdict not in ("passed", "not_started") and not fragment["message"]:
            wrong += 1
            print(f"{fragment['name']}: {verdict}, and no word about it")
    missing = set(expected) - {fragment["name"] for fragment in record["fragments"]}
    if missing:
        sys.exit(f"no such fragments: {', '.join(sorted(missing))}")
    print(f"{len(record['fragments']) - wrong} of {len(record['fragments'])} fragments have the verdict of the table")
    sys.exit(wrong > 0)


main()
