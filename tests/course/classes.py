"""Folders as course systems export them, and what a graded class must be the same in."""

import csv
import io
import pathlib
import sys
import zipfile

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import SOLUTION, record_at, timeless  # noqa: E402

WRONG_MIRROR = ('#include "rt/fragments.h"\nnamespace rt { vec3 mirror_direction(vec3 d, vec3 n) { return d - dot(d, n) * n; } }\n')


def text(name):
    return (SOLUTION / f"{name}.cpp").read_text()


def archive(path, files):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as out:
        for name, content in files.items():
            out.writestr(name, content)
    return path.read_bytes()


def folder(path, files):
    for name, content in files.items():
        (path / name).parent.mkdir(parents=True, exist_ok=True)
        (path / name).write_text(content)


def light_class(at, size):
    """Submissions that differ, of two quick fragments each."""
    for student in range(size):
        mirror = WRONG_MIRROR if student % 3 == 0 else text("mirror_direction")
        folder(at / f"hw1-student{student:02}", {"moved.cpp": text("moved") + f"// {student}\n", "mirror_direction.cpp": mirror})


def rows(path):
    return list(csv.DictReader(io.StringIO(pathlib.Path(path).read_bytes().decode(), newline="")))


def records(out):
    """By name: all that are there."""
    return {path.name: timeless(record_at(path)) for path in sorted((out / "records").glob("*.json"))}


def outcome(out):
    """What must be the same of two gradings of one class."""
    tables = [path.read_bytes() for path in sorted(out.glob("*.csv"))]
    return records(out), *tables
