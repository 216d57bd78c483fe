#!/usr/bin/env python3
"""The folders of the grader are layers: a file includes files of its own folder and of those before it, of no other. No two
of its headers declare types of one name. So are the renderer's folders and the files beside them, as starter/README.md
says."""
import pathlib
import re
import sys

layers = ["files", "assignment", "statistics", "protocol", "checks/kit", "checks", "arithmetic", "submission", "record", "textbook",
          *(f"diagnosis/{part}" for part in "calls where changes forms rules samples source".split()), "diagnosis", "programs", "judging",
          "report", "hand_out", "studies", "convert", "class", "stress", "lesson", "convergence", "calibration", "authoring", "theory", "commands", ""]
# What is compiled for others: the child's program knows the protocol only; archives.cpp and its stand-in in a kit are submission's.
beside = {"child": {"protocol", "arithmetic", "textbook"}, "archives": {"submission", "files"}, "kit": {"submission", "files"}}
made_by_the_build = {"checks/fragment_checks.h": "checks/kit", "child/each_fragment.h": "child"}


def layer_of(folder):
    """A folder of checks belongs to one fragment, but for the kit."""
    return "checks" if folder.parts[:1] == ("checks",) and folder.name != "kit" else str(folder).removeprefix(".")


root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "grader")
wrong, seen, of_renderer = [], 0, 0
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
# The renderer's, each with the files at its top that belong there. Headers of several include each other in one layer.
renderer = ["answers batch elementary fragments lanes math not_started parts processor ray sampler scene", "tree", "calls lamps media plan plan_described world", "files",
            "stages", "passes path render trace", "show"]
layer = {name: number for number, names in enumerate(renderer) for name in names.split()}
starter = pathlib.Path("starter/rt")
for path in sorted([*starter.rglob("*.cpp"), *starter.rglob("*.h")]):
    own = path.relative_to(starter).parts[0].split(".")[0]
    if own not in layer:
        wrong.append(f"{path}:1:1: is of no layer; expected one of {', '.join(layer)}")
        continue
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if include := re.match(r'#include "rt/(\w+)', line):
            of_renderer += 1
            if layer.get(include[1], len(renderer)) > layer[own]:
                wrong.append(f"{path}:{number}:1: {own} includes {include[1]}; expected what is of its layer or one below: "
                             f"{', '.join(renderer[:layer[own] + 1])}")
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
if of_renderer < 100:
    sys.exit(f"{starter}: only {of_renderer} includes found; expected the renderer's sources")
sys.exit(bool(wrong))
