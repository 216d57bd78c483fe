#!/usr/bin/env python3
"""What `grade new fragment` and `grade new check` write is as .clang-format has it, with the signature of each fragment, and blanks
are made of solutions: new_format_test.py BUILD. Skipped (77) where there is no clang-format 14."""

import pathlib
import re
import shutil
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import ROOT, SOLUTION, end, expect, run, skip  # noqa: E402

BUILD = pathlib.Path(sys.argv[1]).absolute()
PARTS = ("assignment.toml", "handout.md", ".clang-format", "solution", "starter/fragments", "starter/rt", "grader/checks",
         "grader/authoring/templates")


def check_refusals(new, tree):
    """What no command could read or compile afterwards is not written."""
    before = {path: path.read_bytes() for path in tree.rglob("*") if path.is_file()}
    for name, why in {"double": "word of C++", "class": "word of C++", "main": "word of C++", "picture": "./grade picture means",
                      "theory": "./grade theory means", "compare": "./grade compare means", "solution": "means something else",
                      "cross": ".h has this name already", "unit": ".h has this name already", "reflect": "glm has a function"}.items():
        said = run([*new, "fragment", name, "--declare", f"DiskSample {name}(vec2 u)"], 2)
        expect(f"{name}: " in said and why in said and "expected another name" in said, f"a name that is taken: {said}")
    for points in ("1001", "nan", "-3", "inf", "1e9", "two"):
        said = run([*new, "fragment", "of_points", "--like", "phong", "--points", points], 2)
        expect("expected a number from 0 to 1000" in said and len(said) < 200, f"points that are none: {said}")
    expect(before == {path: path.read_bytes() for path in tree.rglob("*") if path.is_file()}, "files have changed all the same")


def main():
    if " version 14." not in run(["sh", "-c", "/usr/bin/clang-format --version || true"]):
        skip("there is no clang-format 14 here")
    with tempfile.TemporaryDirectory() as work:
        tree = pathlib.Path(work) / "tree"
        for part in PARTS:
            (tree / part).parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if (ROOT / part).is_dir() else shutil.copy)(ROOT / part, tree / part)
        chain = (BUILD / "toolchain.toml").read_text()
        (tree / "toolchain.toml").write_text(re.sub(r'^source = ".*"', f'source = "{tree}"', chain, flags=re.MULTILINE))
        new = [BUILD / "grader/grade", "--toolchain", tree / "toolchain.toml", "new"]
        for number, name in enumerate(sorted(path.stem for path in SOLUTION.glob("*.cpp"))):
            mine = "new_" + "x" * (number % 8) + str(number)
            run([*new, "fragment", mine, "--like", name])
            run([*new, "check", "far_away", "--of", mine])
            run([*new, "check", "far_away", "--of", name])
        run([*new, "fragment", "of_types", "--declare", "Color of_types(const Material& material, vec3 n, Real cosine)"])
        said = run([*new, "fragment", "x" * 110, "--like", "phong"], 2)
        expect("expected at most 120" in said, f"a declaration that is too long: {said}")
        check_refusals(new, tree)
        sources = sorted(path for path in tree.rglob("*.cpp"))
        expect(len(sources) > 3 * 64, f"{len(sources)} sources")
        run(["clang-format", "--dry-run", "--Werror", *sources])
        run([BUILD / "grader/strip_solution", "--check", "solution", "starter/fragments"], cwd=tree)
    end("what is new is laid out as the rest")


main()
