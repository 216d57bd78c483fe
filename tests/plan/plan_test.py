#!/usr/bin/env python3
"""What a scene does not need is not there: plan_test.py BUILD

1. Each scene's picture is the same, bit by bit, drawn by a program without the fragments of the integrals and stages
   that its plan leaves out: blanks stand in their places, and each would say that it was called.
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

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MOST = 1.02  # instructions, as a ratio

# By what the table of --plan calls them: the fragments that nothing else needs.
ONLY_FOR = {
    "lens": {"lens_ray"},
    "time": {"shutter_time"},
    "light": {"light_sample"},
    "lobe": {"glossy_reflection", "translucency"},
    "bounce": {"color_bleeding"},
    "medium": {"free_flight", "scatter_direction"},
    "scatter": {"whitted", "fresnel_dielectric", "mirror_direction", "refracted_direction"},
    "emission": {"emission_counts"},
    "direct": {"direct_light", "shadow_ray", "point_irradiance", "phong"},
    "surface": {"hit_sphere", "hit_triangle", "hit_quad"},
}
NEVER = {"integrate_uniform", "integrate_monte_carlo", "integrate_stratified"}

# Of the plan, what a Whitted scene without a tree does not have.
ABSENT = [
    "light",
    "lobe",
    "lens",
    "time",
    "bounce",
    "medium",
    "environment",
    "emission",
    "choice",
    "weigh",
    "solid_angle",
    "one_lamp",
    "environment_lit",
    "bvh",
    "triangles",
    "discs",
    "smooth",
]
NOTHING = """
/// A switch that is off, and that nothing turns on.
struct Absent {
    constexpr operator bool() const { return false; }
    constexpr Absent& operator=(bool) { return *this; }
    constexpr Absent& operator|=(bool) { return *this; }
};
"""

failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)
        print(f"FAILED: {what}", flush=True)


def unneeded(raytrace, scene):
    """The fragments that a scene's plan has no use for."""
    table = subprocess.run([raytrace, scene, "--plan"], capture_output=True, text=True, check=True).stdout
    on = dict(re.findall(r"^  (\w+) +(on|-) ", table, re.MULTILINE))
    missing = [row for row in ONLY_FOR if row not in on]
    expect(not missing, f"--plan has no rows {missing}")
    return NEVER | {f for row, fragments in ONLY_FOR.items() if on.get(row) == "-" for f in fragments}


def draw(program, scene, out):
    """The picture's hash, and what was said."""
    done = subprocess.run(
        [program, scene, "-o", out, "--size", "24x24", "--samples", "4", "--threads", "1"],
        capture_output=True,
        text=True,
        check=False,
    )
    hashed = re.search(r"^hash +(\w+)$", done.stdout, re.M)
    return (hashed.group(1) if hashed else done.stderr), done.stdout + done.stderr


def link_line(build):
    """How the build links the renderer from one object for each fragment."""
    done = subprocess.run(
        ["ninja", "-C", build, "-t", "commands", "-s", "raytrace_linked"], capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


def same_without(chain, build, scenes, work):
    """Part 1. Scenes that leave out the same share a program."""
    blanks = {pathlib.Path(o).name.split(".")[0]: o for o in chain["blank_objects"]}
    link = link_line(build)
    programs = {}
    for scene in scenes:
        programs.setdefault(frozenset(unneeded(build / "raytrace", scene)), []).append(scene)

    def check(job):
        number, (without, its_scenes) = job
        program = work / f"without-{number}"
        command = re.sub(r"\S*/(\w+)\.cpp\.o(?!\S)", lambda o: blanks[o[1]] if o[1] in without else o[0], link)
        command = re.sub(r"-o \S+", f"-o {program}", command)
        subprocess.run(command, shell=True, check=True, cwd=build)
        said = []
        for scene in its_scenes:
            name = work / f"{number}-{scene.stem}.exr"
            usual, _ = draw(build / "raytrace_linked", scene, name)
            name.unlink(missing_ok=True)
            other, text = draw(program, scene, name)
            said.append((usual == other, scene, text))
        return said

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for said in pool.map(check, enumerate(programs.items())):
            for same, scene, text in said:
                expect(same, f"{scene.relative_to(ROOT)}: another picture without what its plan leaves out")
                called = re.findall(r"(\w+)\.cpp.*not started", text)
                expect(not called, f"{scene.relative_to(ROOT)}: calls {called}, which its plan leaves out")
    print(f"{len(scenes)} scenes: the same pictures from {len(programs)} programs without what their plans leave out")


def includes(files):
    return "".join(f'#include "{f}"\n' for f in files)


def compile_whitted(chain, shadow, program):
    """The stages with the fragments inside them, as the build includes them; and what they need, in a file of its own."""
    lines = (ROOT / "starter/rt/fragments.h").read_text().splitlines()
    declared = [
        f"inline {line}" for line in lines if re.match(r"[A-Za-z].*\(.*\);$", line) and "report_not_started" not in line
    ]
    files = sorted(ROOT.glob("solution/*.cpp")) + sorted(ROOT.glob("starter/rt/stages/*.cpp"))
    stages, rest = (program.with_name(f"{program.name}_{part}.cpp") for part in ("stages", "rest"))
    stages.write_text('#include "rt/fragments.h"\nnamespace rt {\n' + "\n".join(declared) + "\n}\n" + includes(files))
    rest.write_text(
        includes(
            [ROOT / "starter/rt" / f"{name}.cpp" for name in ("tree/bvh", "lamps/lamp_tree", "path", "plan", "trace", "world")]
            + [ROOT / "tests/plan/whitted.cpp"]
        )
    )
    # valgrind knows no AVX-512
    options = [o for o in chain["options"] if not o.startswith("-m")]
    limits = (
        [
            "-fno-tree-sink",
            "-finline-limit=100000",
            "--param=inline-unit-growth=10000",
            "--param=large-function-growth=10000",
            "--param=large-stack-frame-growth=10000",
            "--param=max-inline-insns-single=100000",
            "--param=max-inline-insns-auto=100000",
        ]
        if "GNU" in chain["description"]
        else ["-mllvm", "-inline-threshold=100000"]
    )
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
    scenes = sorted(ROOT.glob("scenes/*.toml")) + sorted(ROOT.glob("scenes/bench/*.toml"))
    with tempfile.TemporaryDirectory() as work:
        same_without(chain, build, scenes, pathlib.Path(work))
        pure_whitted(chain, pathlib.Path(work))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
