#!/usr/bin/env python3
"""How well the plan chooses how lamps are sampled: choices.py BUILD [--scenes N] [--write]

Builds tests/bench/choices.cpp in the build folder and runs it on the scenes of scenes/bench and scenes/gallery, without
what they say themselves, and on N that are drawn at random: rooms and floors with balls, lobes, lenses and 1 to 40 lamps
of all sizes. For each way to sample lamps, the time to the error of 64 independent samples a pixel, by area and of all
lamps; and how much longer the plan's way takes than the best. With --write, tests/bench/choices.md is written.
"""

import argparse
import concurrent.futures
import json
import math
import pathlib
import random
import re
import subprocess
import tempfile

from figures import machine, table

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent


def shape(kind, material, **keys):
    lines = [f"{k} = {[round(x, 4) for x in v] if isinstance(v, list) else round(v, 4)}" for k, v in keys.items()]
    return "\n".join(["[[shape]]", f'type = "{kind}"', *lines, f'material = "{material}"', ""])


def lamp(draw, room):
    """A quad, disc or ball that shines down or to the middle, of any size."""
    size = math.exp(draw.uniform(math.log(0.05), math.log(1.5)))
    at = [draw.uniform(-2.5, 2.5), draw.uniform(1.2, 2.9 if room else 6), draw.uniform(-2.5, 2.5)]
    kind = draw.choice(["quad", "quad", "disc", "sphere"])
    tilt = draw.uniform(-0.6, 0.6)
    if kind == "sphere":
        return shape(kind, "lamp", center=at, radius=0.5 * size)
    if kind == "disc":
        return shape(kind, "lamp", center=at, normal=[math.sin(tilt), -math.cos(tilt), 0], radius=size)
    return shape(kind, "lamp", center=at, u=[size * math.cos(tilt), size * math.sin(tilt), 0], v=[0, 0, size])


def scene(seed):
    draw = random.Random(seed)
    room, lobes, lamps = draw.random() < 0.5, draw.random() < 0.6, draw.choice([1, 1, 2, 3, 5, 10, 20, 40])
    text = f"[render]\nsamples = 64\nbounces = {draw.choice([0, 0, 1, 3])}\n"
    text += f"[camera]\neye = [0, 2, {2.9 if room else 7}]\ntarget = [0, 1, 0]\nvfov = {70 if room else 45}\n"
    if draw.random() < 0.3:
        text += f"lens_radius = 0.08\nfocus = {draw.uniform(2, 8):.3}\n"
    text += f"[materials.lamp]\nemission = {20 / lamps:.4}\n"
    kinds = ["grey", "red"]
    text += "[materials.grey]\nalbedo = 0.6\n[materials.red]\nalbedo = [0.7, 0.2, 0.1]\nspecular = 0.2\nshininess = 40\n"
    for k in range(3 if lobes else 0):
        exponent = math.exp(draw.uniform(math.log(4), math.log(2000)))
        text += f"[materials.lobe{k}]\nreflectance = 0.8\nexponent = {exponent:.4}\nalbedo = {draw.choice([0, 0.15])}\n"
        kinds.append(f"lobe{k}")
    half = 3 if room else 12
    text += shape("quad", draw.choice(kinds), center=[0, 0, 0], u=[half, 0, 0], v=[0, 0, -half])
    if room:
        text += shape("quad", "grey", center=[0, 3, 0], u=[3, 0, 0], v=[0, 0, 3])
        text += shape("quad", "grey", center=[0, 1.5, -3], u=[3, 0, 0], v=[0, 1.5, 0])
        text += shape("quad", "red", center=[-3, 1.5, 0], u=[0, 1.5, 0], v=[0, 0, 3])
        text += shape("quad", "grey", center=[3, 1.5, 0], u=[0, 0, 3], v=[0, 1.5, 0])
    for _ in range(draw.randint(2, 6)):
        r = draw.uniform(0.2, 0.7)
        text += shape("sphere", draw.choice(kinds), center=[draw.uniform(-2, 2), r, draw.uniform(-2, 1)], radius=r)
    return text + "".join(lamp(draw, room) for _ in range(lamps))


def seconds_to(error, errors, seconds):
    """On the line through the two levels about the error, in logarithms; beyond the levels, on the nearest line."""
    points = [(math.log(max(e, 1e-30)), math.log(s)) for e, s in zip(errors, seconds)]
    k = 0 if math.log(error) > points[1][0] else 1
    (e0, s0), (e1, s1) = points[k], points[k + 1]
    slope = (s1 - s0) / min(e1 - e0, -0.3)
    return math.exp(s0 + slope * (math.log(error) - e0))


def over_best(found, kind):
    """Of each way, how many times as long as the best it takes to the error of independent samples."""
    times = {name: seconds_to(found["plain"][kind], way[kind], way["seconds"]) for name, way in found["ways"].items()}
    return {name: time / min(times.values()) for name, time in times.items()}


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("build", type=pathlib.Path, help="the build folder, configured with -DBUILD_TESTING=ON")
    words.add_argument("--scenes", type=int, default=20, help="drawn at random")
    words.add_argument("--first", type=int, default=0, help="the first one's seed")
    words.add_argument("--jobs", type=int, default=1, help="scenes at a time")
    words.add_argument("--side", type=int, default=64, help="of the pictures [pixel]")
    words.add_argument("--write", action="store_true", help="write tests/bench/choices.md")
    words.add_argument("--only", default="", help="scenes with this in their names")
    words = words.parse_args()
    subprocess.run(["cmake", "--build", words.build, "--target", "choices"], check=True, stdout=subprocess.DEVNULL)
    said = re.compile(r"^(multiple_importance|solid_angle|one_lamp) = .*\n", re.MULTILINE)
    with tempfile.TemporaryDirectory() as work:
        files = sorted(root.glob("scenes/bench/*.toml")) + sorted(root.glob("scenes/gallery/*.toml"))
        for file in files:
            for mesh in file.parent.glob("*.obj"):
                (pathlib.Path(work) / mesh.name).exists() or (pathlib.Path(work) / mesh.name).symlink_to(mesh)
            (pathlib.Path(work) / file.name).write_text(said.sub("", file.read_text()))
        names = [file.name for file in files]
        for seed in range(words.first, words.first + words.scenes):
            names.append(f"random {seed}.toml")
            (pathlib.Path(work) / names[-1]).write_text(scene(seed))
        def judge(name):
            command = [words.build / "tests/bench/choices", f"{work}/{name}", str(words.side)]
            found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
            times, in_full = over_best(found, "as_seen"), over_best(found, "errors")
            rest = ", ".join(f"{way} {t:.2f}" for way, t in sorted(times.items(), key=lambda x: x[1]))
            plan = found["plan"]
            row = [name.removesuffix(".toml"), plan, f"{times[plan]:.2f}", f"{in_full[plan]:.2f}", rest]
            print(*row, sep=" | ", flush=True)
            return row

        with concurrent.futures.ThreadPoolExecutor(words.jobs) as pool:
            rows = list(pool.map(judge, [name for name in names if words.only in name]))
    worst = ""
    for column, kind in (2, "As seen"), (3, "With all of the bright pixels' errors"):
        ratios = [float(row[column]) for row in rows]
        worst += f"{kind}: at most {max(ratios):.2f} times as long as the best way; in {sum(r <= 1.2 for r in ratios)} "
        worst += f"of {len(ratios)} scenes at most 1.2 times, in {sum(r <= 1.5 for r in ratios)} at most 1.5.\n"
    print(worst)
    if words.write:
        head = f"""# The plan's way to sample lamps beside the best

Written by `tests/bench/choices.py BUILD --scenes {words.scenes} --first {words.first} --side {words.side} --jobs {words.jobs} --write` on
{machine()}, which did other work as well. Scenes from seeds 0 to 99 were looked at when the rule was made.
Time to the error of 64 independent samples a pixel, as a multiple of the best way's. Errors are as seen: pixels count as at
most as bright as the brightest lamp, since where lamps touch surfaces the variance is infinite, and single pixels that no
lamp could be as bright as would decide; the fourth column has those in full. Where no way but one makes a difference to a
scene, it is alone in its row.

"""
        text = table(["scene", "the plan's way", "over the best", "in full", "all ways, over the best"], rows)
        (here / "choices.md").write_text(head + text + "\n" + worst)


if __name__ == "__main__":
    main()
