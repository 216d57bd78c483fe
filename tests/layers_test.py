#!/usr/bin/env python3
"""The folders of the grader are layers: a file includes files of its own folder and of those before it, of no other. No two
of its headers declare types of one name."""
import pathlib
import re
import sys

layers = ["files", "assignment", "statistics", "protocol", "checks/kit", "checks", "arithmetic", "submission", "record", "textbook", "diagnosis", "programs",
          "judging", "report", "hand_out", "studies", "convert", "class", "stress", "lesson", "convergence", "calibration", "authoring", "theory", "commands", ""]
# What is compiled for others: the child's program knows the protocol only; archives.cpp and its stand-in in a kit are submission's.
beside = {"child": {"protocol", "arithmetic", "textbook"}, "archives": {"submission", "files"}, "kit": {"submission", "files"}}
made_by_the_build = {"checks/fragment_checks.h": "checks/kit", "child/each_fragment.h": "child"}


def layer_of(folder):
    """A folder of checks belongs to one fragment, but for the kit."""
    return "checks" if folder.parts[:1] == ("checks",) and folder.name != "kit" else str(folder).removeprefix(".")


root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "grader")
wrong, seen = [], 0
for path in sorted([*root.rglob("*.cpp"), *root.rglob("*.h")]):
    if path.parent.parent.name == "textbook":
        continue  # what wrap_forms reads
    folder = layer_of(path.parent.relative_to(root))
    known = layers + list(beside)
    if folder not in known:
        wrong.append(f"{path}:1:1: the folder is no layer; expected one of {', '.join(known)}")
        continue
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not (include := re.match(r'#include "((?!rt/)[^"]+)"', line)):
            continue
        seen += 1
        other = made_by_the_build.get(include[1]) or layer_of(pathlib.PurePath(include[1]).parent)
        other = "checks/kit" if other == "asked" else other  # the declarations of one fragment
        allowed = beside.get(folder) or layers[:layers.index(folder)]
        if other != folder and other not in allowed:
            wrong.append(f"{path}:{number}:1: {folder or 'the top'} includes {include[1]}; expected a file of {folder} or a layer below: "
                         f"{', '.join(sorted(allowed))}")
# Two types of one name in one namespace are one to the linker, which takes either's functions for both.
types = {}
for path in sorted(root.rglob("*.h")):
    space = ""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        space = found[1] if (found := re.match(r"namespace ([\w:]+) \{", line)) else space
        if not (found := re.match(r"(?:struct|class|enum class|using) (\w+)\b.*[{=]", line)):
            continue
        name = f"{space}::{found[1]}"
        if name in types and types[name] != path and "template" not in path.read_text().splitlines()[number - 2]:
            wrong.append(f"{path}:{number}:1: a second {name}, beside that of {types[name]}; expected another name or namespace")
        types.setdefault(name, path)

print("\n".join(wrong))
if seen < 100:
    sys.exit(f"{root}: only {seen} includes found; expected the grader's sources")
sys.exit(bool(wrong))
