#!/usr/bin/env python3
"""Compiles every variant once, all in one translation unit: after an edit of the solution a patch may apply and yet not compile.

    tests/variants/compile.py COMPILER INCLUDE...

Each variant gets a namespace of its own inside rt. Exits with 1 where one does not apply or not compile.
"""
import pathlib
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import ROOT, variant  # noqa: E402


def main():
    compiler, *includes = sys.argv[1:]
    patches = sorted((ROOT / "tests/variants").glob("*/*.patch"))
    unit = ["constexpr double DOSE = 0.01;\n"]
    for number, patch in enumerate(patches):
        fragment, text = variant(patch)
        if "\nnamespace rt {\n" not in text:
            sys.exit(f"{patch}:1:1: solution/{fragment}.cpp is not in namespace rt; expected: as in the solution")
        unit.append(f'#line 1 "{patch.relative_to(ROOT)} applied to solution/{fragment}.cpp"\n')
        unit.append(text.replace("\nnamespace rt {\n", f"\nnamespace rt::variant_{number} {{\n", 1))
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "variants.cpp"
        source.write_text("".join(unit))
        command = [compiler, "-std=c++20", "-fsyntax-only", *(f"-I{path}" for path in includes), str(source)]
        done = subprocess.run(command)
    print(f"{len(patches)} variants {'compile' if done.returncode == 0 else 'do not all compile'}")
    sys.exit(1 if done.returncode != 0 else 0)


main()
