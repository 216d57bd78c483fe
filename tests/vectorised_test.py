#!/usr/bin/env python3
"""Every loop of the stages that is marked with ivdep is vectorised, says the compiler itself.

    tests/vectorised_test.py BUILD

One loop becomes several: for each sampling pattern, kind of light, way on. The table says how many of them are
vectorised, and how many GCC gives up; the test fails where none is, or where more are given up than is known of GCC 12.
Skipped (exit code 77) where the build's compiler is not GCC or has sanitizers on, or the processor has no AVX-512; with
another GCC, after the table.
"""

import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

from helpers import skip

root = pathlib.Path(__file__).resolve().parent.parent

# Loops that stay scalar, at most so many: strata are shuffled by a loop of unknown length, for any number of samples;
# translucency returns early.
known = {
    "draw_pairs": 3,  # stratified and uniform, for one key or several
    "draw_singles": 2,
    "send": 1,  # translucency
    "try_shape": 2,  # triangles in scenes without a tree
}


def marked_loops():
    """File, line of the `for`, and the function in which it stands."""
    for path in sorted((root / "starter/rt").rglob("*")):
        if path.suffix not in (".cpp", ".h"):
            continue
        function = "?"
        lines = path.read_text().splitlines()
        for i, line in enumerate(lines):
            found = re.match(r"\S.*?(\w+)\(", line)
            if found and not line.startswith(("#", "//")):
                function = found.group(1)
            if line.strip() == "#pragma GCC ivdep":
                yield path.name, i + 2, function


def report(build):
    """What GCC says of each loop when it compiles the stages with the fragments inside them."""
    commands = json.loads((build / "compile_commands.json").read_text())
    entry = next(c for c in commands if c["file"].endswith("/raytrace_inlined.cpp"))
    words = shlex.split(entry["command"])
    compiler = next(i for i, word in enumerate(words) if re.search(r"(c\+\+|g\+\+)(-\d+)?$", word))
    words = words[compiler : words.index("-o")]
    version = subprocess.run([words[0], "--version"], capture_output=True, text=True).stdout
    if "Free Software Foundation" not in version:
        skip("the compiler is not GCC")
    global of_known
    of_known = re.search(r"\) (\d+)\.", version)[1] == "12"
    if any("-fsanitize" in word for word in words):
        skip("sanitizers stand in the way")
    if "avx512dq" not in pathlib.Path("/proc/cpuinfo").read_text():
        skip("no AVX-512 here")
    with tempfile.TemporaryDirectory() as folder:
        notes = pathlib.Path(folder) / "notes"
        command = words + ["-c", entry["file"], "-o", folder + "/object", f"-fopt-info-vec-all={notes}"]
        subprocess.run(command, cwd=entry["directory"], check=True)
        return notes.read_text()


of_known = True
vectorised, given_up = {}, {}
for line in report(pathlib.Path(sys.argv[1]).resolve()).splitlines():
    found = re.match(r".*/(\w+\.\w+):(\d+):\d+: (optimized: loop vectorized|missed: couldn't vectorize loop)", line)
    if found:
        counts = vectorised if found.group(3).startswith("optimized") else given_up
        place = (found.group(1), int(found.group(2)))
        counts[place] = counts.get(place, 0) + 1

failures = 0
print(f"{'loop':<34}{'vectorised':>12}{'given up':>12}{'known':>8}")
for file, line, function in marked_loops():
    yes, no = vectorised.get((file, line), 0), given_up.get((file, line), 0)
    allowed = known.get(function, 0)
    good = yes > 0 and no <= allowed
    failures += not good
    print(f"{file + ':' + str(line) + ' ' + function:<34}{yes:>12}{no:>12}{allowed:>8}{'' if good else '   FAILED'}")
if failures and not of_known:
    skip("another GCC than 12 does it in another way")
sys.exit(1 if failures else 0)
