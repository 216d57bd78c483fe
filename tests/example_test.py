#!/usr/bin/env python3
"""Grades the example submission: each fragment must get the verdict that the table in tests/example/README.md says.

    tests/example_test.py GRADE
"""

import re
import sys

from helpers import ROOT, end, expect, record_of

example = ROOT / "tests/example"
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
    record = record_of([sys.argv[1], example, "--seed", "1"])
    expected = table()
    for fragment in record["fragments"]:
        verdict = expected.get(fragment["name"], "passed")
        expect(fragment["verdict"] == verdict,
               f"{fragment['name']}: {fragment['verdict']}, expected {verdict}: {fragment['message']}")
        expect(verdict in ("passed", "not_started") or fragment["message"], f"{fragment['name']}: {verdict}, and no word about it")
    missing = set(expected) - {fragment["name"] for fragment in record["fragments"]}
    expect(not missing, f"no such fragments: {', '.join(sorted(missing))}")
    end(f"all {len(record['fragments'])} fragments have the verdict of the table")


main()
