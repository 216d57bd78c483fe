#!/usr/bin/env python3
"""What lamps at scatterings (`media_lit`) and the end of paths at random (`roulette`) are worth: walks.py BUILD [OPTION]

Renders balls of media of several densities under lamps of several sizes, a room with many bounces, and the wax of
scenes/gallery/candle.toml, without and with each, in turn. Efficiency is 1/(MSE x CPU seconds), by raytrace's own
figures. With --write, tests/bench/walks.md is written; with --only, the rows whose scene has this word in its name are
printed alone.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from figures import machine, table

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent
TURNS = 1


def ball(extinction, albedo, g, lamp):
    """A ball before the eye, and a lamp that gives it as much light whatever its size."""
    return f"""environment = 0.05
[render]
samples = 128
depth = 64
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
vfov = 25
size = [24, 24]
[materials.milk]
transmittance = 1
medium = {{ extinction = {extinction}, albedo = {albedo}, g = {g} }}
[materials.lamp]
emission = {lamp ** -2:.6g}
[[shape]]
type = "sphere"
radius = 1
center = [0, 0, 0]
material = "milk"
[[shape]]
type = "disc"
center = [2, 2, 1]
normal = [-2, -2, -1]
radius = {lamp}
material = "lamp"
"""


def cases():
    """Name, switch, text of the scene, options."""
    for g, extinction in (0, 1), (0, 6), (0, 20), (0.8, 6):
        for lamp in 0.1, 0.5, 1.5, 4:
            name = f"lamp of radius {lamp}, extinction {extinction}, g {g}"
            yield name, "media_lit", ball(extinction, 0.98, g, lamp), []
    candle = (root / "scenes/gallery/candle.toml").read_text()
    wax = ["--samples", "16", "--crop", "141,140,111,106"]
    yield "candle", "media_lit", candle, wax
    yield "scattering", "media_lit", (root / "scenes/scattering.toml").read_text(), []
    yield "candle", "roulette", candle, wax
    for extinction in 6, 20, 60:
        for albedo in 0.3, 0.8, 0.95:
            yield f"extinction {extinction}, albedo {albedo}", "roulette", ball(extinction, albedo, 0, 0.5), []
    box = re.sub(r"size = \[.*\]", "size = [32, 32]", (root / "scenes/gallery/cornell.toml").read_text())
    for bounces in 4, 6, 12, 24:
        text = re.sub(r"bounces = \d+", f"bounces = {bounces}", box)
        yield f"cornell, {bounces} bounces", "roulette", text, ["--samples", "64"]


def with_key(text, switch, on):
    text = re.sub(rf"^{switch} = .*\n", "", text, flags=re.MULTILINE)
    return text if on is None else text.replace("[render]\n", f"[render]\n{switch} = {'true' if on else 'false'}\n")


def measured(raytrace, file, options):
    command = [raytrace, file, "-o", file.with_suffix(".exr"), *options]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    said = done.stdout + done.stderr
    return float(re.search(r"^error +(\S+)", said, re.MULTILINE)[1]), float(re.search(r"^time +(\S+)", said, re.MULTILINE)[1])


def judge(raytrace, work, name, switch, text, options):
    row = switch.replace("_", " ")
    file = work / "scene.toml"
    file.write_text(with_key(text, switch, None))
    plan = subprocess.run([raytrace, file, "--plan"], check=True, capture_output=True, text=True).stdout
    decides = re.search(rf"^  {row} +(\S+)", plan, re.MULTILINE)[1]
    figures = {False: [], True: []}
    for turn in range(TURNS):
        for on in False, True:
            file.write_text(with_key(text, switch, on))
            figures[on].append(measured(raytrace, file, [*options, "--seed", str(turn + 1)]))
    mse, seconds = ({on: sum(f(x) for x in figures[on]) for on in figures} for f in (lambda x: x[0] ** 2, lambda x: x[1]))
    variance, time = mse[True] / mse[False], seconds[True] / seconds[False]
    return [row, name, f"{variance:.2g}", f"{time:.2f}", f"{1 / (variance * time):.2g}", "on" if decides == "on" else "-"]


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("build", type=pathlib.Path, help="the build folder, with raytrace in it")
    words.add_argument("--write", action="store_true", help="write tests/bench/walks.md")
    words.add_argument("--only", default="", metavar="WORD", help="only scenes with this word in their names")
    words = words.parse_args()
    if words.write and words.only:
        sys.exit("--write takes all rows; expected no --only")
    rows = []
    with tempfile.TemporaryDirectory() as work:
        for mesh in "candle.obj", "wick.obj", "flame.obj":  # scenes name meshes beside them
            shutil.copy(root / "scenes/gallery" / mesh, work)
        for case in (c for c in cases() if words.only in c[0]):
            rows.append(judge(words.build / "raytrace", pathlib.Path(work), *case))
            print(*rows[-1], sep=" | ", flush=True)
    if words.write:
        head = f"""# Lamps at scatterings, and paths that end at random

Written by `tests/bench/walks.py BUILD --write` on {machine()}, which did other work as well. Each
row compares a scene with a switch on to the same one with it off: the squared error, the CPU time, and how many times as
efficient it is. The plan's rules were chosen on these scenes.

"""
        heads = ["switch", "scene", "squared error", "CPU time", "efficiency", "the plan"]
        (here / "walks.md").write_text(head + table(heads, rows) + "\n")


if __name__ == "__main__":
    main()
