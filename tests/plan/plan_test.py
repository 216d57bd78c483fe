#!/usr/bin/env python3
"""What a scene does not need is not there: plan_test.py BUILD [--all]

1. Each scene's picture is the same, bit by bit, drawn by a program without the fragments that its plan does not name:
   blanks stand in their places, and each would say that it was called. Each fragment that the plan does name is called,
   tried with some twelve of its scenes, with --all of them.
2. A Whitted scene drawn by the stages compiled with a plan whose other members are constants, so that the compiler
   removes what they switch on: the same bits as by the stages as they are, which need at most 2 % more instructions.
   Instructions are counted by valgrind, where it is there.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

from programs import Programs, draw, named
from helpers import ROOT, end, expect, fragments_in_order

MOST = 1.02  # instructions, as a ratio

# What the stages need besides themselves.
BESIDE_STAGES = ["tree/bvh", "lamps/lamp_tree", "lamps/ways", "lamps/sight", "path", "calls", "plan", "world", "media/regions", "media/bodies"]

# What a picture is drawn with.
SMALL = ["--size", "24x24"]
SETTINGS = [["--samples", "4"], ["--samples", "1"], ["--samples", "4", "--sampler", "stratified"]]

# Of the plan, what a Whitted scene without a tree does not have.
ABSENT = """pixel light lobe lens time bounce medium environment emission choice weigh solid_angle one_lamp
environment_lit sky_by_bounces media_lit roulette counts_twice glossy translucent bvh triangles discs smooth through""".split()
NOTHING = """
/// A switch that is off, and that nothing turns on.
struct Absent {
    constexpr operator bool() const { return false; }
    constexpr Absent& operator=(bool) { return *this; }
    constexpr Absent& operator|=(bool) { return *this; }
};
"""

def same_without(build, scenes, work, all_scenes=False):
    """Part 1. Pictures that leave out the same share a program; of each, whether it is the same, and what it calls."""
    programs = Programs(build)
    pictures = [(scene, options) for scene in scenes for options in SETTINGS]
    names = [named(build / "raytrace", *picture) for picture in pictures]
    groups = {}
    for picture, fragments in zip(pictures, names):
        groups.setdefault(frozenset(programs.with_called(fragments)), []).append(picture)

    def draw_group(job):
        number, (fragments, group) = job
        program = programs.link(fragments, work / f"only-{number}")
        out = work / f"{number}.exr"
        for scene, options in group:
            usual, _ = draw(build / "raytrace_linked", scene, out, SMALL + options)
            out.unlink(missing_ok=True)
            other, blanks = draw(program, scene, out, SMALL + options)
            said = f"{scene.relative_to(ROOT)}, {' '.join(options)}"
            expect(usual == other, f"{said}: another picture without the fragments that its plan does not name")
            expect(not blanks, f"{said}: calls {blanks}, which its plan does not name")

    def draw_without(fragment):
        program = programs.link(set(programs.filled) - {fragment}, work / f"without-{fragment}")
        out = work / f"{fragment}.exr"
        # of settings with which the plan of a scene names the same, one is enough
        of_plans = {
            (picture[0], frozenset(fragments)): picture
            for picture, fragments in zip(pictures, names)
            if fragment in fragments
        }
        users = list(of_plans.values())
        for scene, options in users if all_scenes else users[:: 1 + len(users) // 12]:
            _, blanks = draw(program, scene, out, SMALL + options)
            said = f"{scene.relative_to(ROOT)}, {' '.join(options)}"
            expect(fragment in blanks, f"{said}: does not call {fragment}, which its plan names")

    in_use = set().union(*names)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(draw_group, enumerate(groups.items())))
        list(pool.map(draw_without, sorted(in_use)))
    nowhere = set(programs.filled) - programs.with_called(in_use)
    # what no stage calls is drawn by itself
    pictures_of = tomllib.loads((ROOT / "tests/variants/pictures.toml").read_text())
    alone = {name for name, table in pictures_of.items() if "warp" in table}
    integrals = set(fragments_in_order()["integrals"])
    expect(integrals <= nowhere <= integrals | alone, f"no picture calls {sorted(nowhere)}")
    print(f"{len(pictures)} pictures of {len(scenes)} scenes: the same from {len(groups)} programs without the fragments that")
    print(f"their plans do not name, and each of the {len(in_use)} that they name is called")


def includes(files):
    return "".join(f'#include "{f}"\n' for f in files)


def compile_whitted(chain, shadow, program):
    """The stages with the fragments inside them, as the build includes them; and what they need, in a file of its own."""
    lines = (ROOT / "starter/rt/fragments.h").read_text().splitlines()
    declared = [f"inline {line}" for line in lines if re.match(r"[A-Za-z].*\(.*\);$", line) and "report_not_started" not in line]
    files = sorted(ROOT.glob("solution/*.cpp")) + sorted(ROOT.glob("starter/rt/stages/*.cpp"))
    stages, rest = (program.with_name(f"{program.name}_{part}.cpp") for part in ("stages", "rest"))
    stages.write_text('#include "rt/fragments.h"\nnamespace rt {\n' + "\n".join(declared) + "\n}\n" + includes(files))
    beside = [ROOT / "starter/rt" / f"{name}.cpp" for name in BESIDE_STAGES]
    rest.write_text(includes([*beside, ROOT / "tests/plan/whitted.cpp"]))
    # valgrind knows no AVX-512
    options = [o for o in chain["options"] if not o.startswith("-m")]
    growth = [f"--param={what}=10000" for what in ("inline-unit-growth", "large-function-growth", "large-stack-frame-growth")]
    inlined = [f"--param=max-inline-insns-{what}=100000" for what in ("single", "auto")]
    of_gcc = ["-fno-tree-sink", "-finline-limit=100000", *growth, *inlined]
    limits = of_gcc if chain["gcc"] else ["-mllvm", "-inline-threshold=100000"]
    command = [chain["compiler"], *chain["compile"], *options, "-w", "-iquote", shadow, "-I", ROOT / "starter"]
    for source, more in ((stages, limits), (rest, [])):
        subprocess.run([*command, *more, "-c", source, "-o", source.with_suffix(".o")], check=True)
    subprocess.run([*command, stages.with_suffix(".o"), rest.with_suffix(".o"), "-o", program, *chain["libraries"]], check=True)


def instructions(program, work):
    log = work / f"{program.name}.callgrind"
    subprocess.run(
        ["valgrind", "--tool=callgrind", "--toggle-collect=measured", f"--callgrind-out-file={log}", program],
        capture_output=True,
        check=True,
    )
    return int(re.search(r"^(?:summary|totals): (\d+)", log.read_text(), re.MULTILINE).group(1))


def pure_whitted(chain, work):
    """Part 2."""
    folder = work / "without" / "rt"
    folder.mkdir(parents=True)
    text = (ROOT / "starter/rt/plan.h").read_text()
    for member in ABSENT:
        text, found = re.subn(rf"\b{member} = false\b", member, text)
        expect(found == 1, f"plan.h has no member {member}")
    names = "|".join(ABSENT)
    fields = re.search(r"struct RenderPlan \{.*?\n\};", text, re.DOTALL).group(0)
    body = re.sub(rf"\b(?:{names})\b,? ?", "", "\n".join(re.sub(r"//.*", "", line) for line in fields.splitlines()))
    body = re.sub(r",(\s*;)", r"\1", re.sub(r"bool\s*;", "", body))
    body = body.replace("struct RenderPlan {", NOTHING + "struct RenderPlan {\n    Absent " + ", ".join(ABSENT) + ";")
    (folder / "plan.h").write_text(text.replace(fields, body))
    (work / "with").mkdir()

    full, pure = work / "full", work / "pure"
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        list(pool.map(lambda job: compile_whitted(chain, *job), [(work / "with", full), (work / "without", pure)]))
    pictures = [subprocess.run([p], capture_output=True, text=True, check=True).stdout for p in (full, pure)]
    expect(
        pictures[0] == pictures[1], f"a Whitted scene: {pictures[0]} by all stages, {pictures[1]} by a Whitted tracer's"
    )
    if not shutil.which("valgrind"):
        print("valgrind is missing: instructions are not counted")
        return
    if any("-fsanitize" in flag for flag in chain["compile"]):
        print("a sanitizer's instructions are not counted")
        return
    a, b = instructions(full, work), instructions(pure, work)
    print(f"a Whitted scene: {a} instructions, {b} by a tracer with nothing else: {100 * (a / b - 1):+.2f} %")
    expect(a <= MOST * b, f"what is absent costs {100 * (a / b - 1):.2f} % instructions; expected at most 2 %")


def main():
    build = pathlib.Path(sys.argv[1]).absolute()
    chain = tomllib.loads((build / "toolchain.toml").read_text())
    scenes = sorted(ROOT.glob("scenes/*.toml")) + sorted(ROOT.glob("scenes/*/*.toml"))
    with tempfile.TemporaryDirectory() as work:
        same_without(build, scenes, pathlib.Path(work), "--all" in sys.argv)
        pure_whitted(chain, pathlib.Path(work))
    end("nothing of what a scene does not need is there")


if __name__ == "__main__":
    main()
