#!/usr/bin/env python3
"""Penumbra side by side with other renderers: CPU seconds to the same error. Writes the table peers.md.

    tests/bench/peers.py BUILD [--rounds N] [--peers WORD] [--out FILE] [SCENE.toml ...]

The peers are Mitsuba 3 in its variants llvm_ad_rgb and scalar_rgb, and Cycles and POV-Ray where they can express the scene;
those that the machine lacks are skipped, with a word. Each renders on one thread; what counts is its CPU time of rendering alone.
The scenes are those of scenes/bench, those of scenes/bench/untuned, which nobody worked on, and one whose million triangles
are made for it.

1. Two independent, almost converged pictures from each. Errors are measured against a renderer's own: the
   product of the differences from both, which their noise adds nothing to. How far the renderers' pictures are apart,
   measured likewise, is the first table.
2. Target errors: those of 64 and 1024 independent samples a pixel, as Mitsuba takes them.
3. Each renderer's ways (sampling patterns, integrators) are tried with more and more samples; the fastest to a target
   is what the renderer takes part with.
4. Rounds: all render in turn near the target. The time of each is brought to the target itself along the slope
   found in 3; ratios are taken within a round, and their geometric mean has an interval from the rounds.

Runs with the Python that has Mitsuba, which also reads the pictures: the one it is started with, else that of
build/mitsuba, which it makes. Exit status: 0 done, 77 there is none, and none can be installed.
"""

import argparse
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def start_again_with_mitsuba():
    """In the environment build/mitsuba, made where it is missing."""
    folder = ROOT / "build" / "mitsuba"
    python = folder / "bin" / "python3"
    if pathlib.Path(sys.prefix) == folder:
        sys.exit("build/mitsuba has no mitsuba or no numpy; remove it and start again")
    if not python.exists():
        print("Installing Mitsuba into build/mitsuba", flush=True)
        for step in (
            [sys.executable, "-m", "venv", folder],
            [python, "-m", "pip", "install", "-q", "mitsuba", "numpy"],
        ):
            if subprocess.run(step, stdout=subprocess.DEVNULL).returncode:
                print("skipped: no Mitsuba here, and it could not be installed (above)")
                sys.exit(77)
    os.execv(python, [str(python), *sys.argv])


try:
    import mitsuba  # noqa: F401
    import numpy  # noqa: F401
except ImportError:
    start_again_with_mitsuba()

from figures import squared_error  # noqa: E402
from made_scenes import million_triangles  # noqa: E402
from peers_tables import write_tables  # noqa: E402
from renderers import Penumbra, newest_llvm, peers, whole_process  # noqa: E402

MOST = 40  # CPU seconds of one render; what needs more to reach a target is given up
LONG = 5  # CPU seconds of one render, beyond which no larger one is tried in advance
SLOW = 4  # CPU seconds: renders that take longer take part in three rounds, four times longer in two


class Curve:
    """Error and time of one way to render, at some numbers of samples."""

    def __init__(self, way):
        self.way, self.points = way, []  # (samples, CPU seconds, mean squared error)

    def at(self, target):
        """Samples and CPU seconds at which the error is the target, and the slope d log seconds / d log error there."""
        points = self.points
        if len(points) == 1:
            return (points[0][0], points[0][1], 0.0) if points[0][2] <= target else None
        below = next((k for k, p in enumerate(points) if p[2] <= target), None)
        k = len(points) - 1 if below is None else max(below, 1)
        a, b = points[k - 1], points[k]
        step = math.log(b[2] / a[2])
        share = math.log(target / a[2]) / step
        share = max(share, 0)  # the fewest samples are good enough
        samples, seconds = (math.exp(math.log(a[i]) + share * math.log(b[i] / a[i])) for i in (0, 1))
        return (samples, seconds, math.log(b[1] / a[1]) / step) if step < 0 and seconds < MOST else None


def climb(renderer, scene, way, halves, targets, most):
    """Renders with more and more samples until the error is below the smallest target, or it takes too long."""
    curve = Curve(way)
    for power in range(0, 8):
        if renderer.compiles:
            renderer.render(scene, way, 4**power, 1)
        image, cpu, n = renderer.render(scene, way, 4**power, 1)
        if curve.points and n <= curve.points[-1][0]:
            continue
        # What is left of an error much smaller than the reference's may be below zero.
        curve.points.append((n, max(cpu, 1e-4), max(squared_error(image, halves), 1e-3 * min(targets))))
        if curve.points[-1][2] <= min(targets) or cpu > min(most / 2, LONG):
            break
    return curve


def best_ways(renderer, scene, halves, targets, ways):
    """For each target the curve of the fastest way to it; None where none reaches it."""
    best, most = [None] * len(targets), MOST
    for way in ways:
        curve = climb(renderer, scene, way, halves, targets, most)
        for k, target in enumerate(targets):
            at = curve.at(target)
            if at and (not best[k] or at[1] < best[k].at(target)[1]):
                best[k] = curve
        if best[-1]:
            most = min(most, 1.5 * best[-1].at(targets[-1])[1])
    return best


def time_to(renderer, scene, curve, target, seed):
    """CPU seconds to the target, of one render near it; renders too short to be timed well are repeated."""
    n, expected, slope = curve.at(target)
    times = []
    for k in range(1 if expected > 0.1 else 5):
        image, cpu, _ = renderer.render(scene, curve.way, n, seed + 1000 * k)
        error = max(squared_error(image, renderer.halves), 1e-3 * target)
        shift = 0 if error < target and curve.points[0][2] < target else slope * math.log(target / error)
        times.append(max(cpu, 1e-4) * math.exp(shift))
    return statistics.median(times)


def add_biases(scene, ours, shared, targets, rows):
    """Whether all draw the same picture, to the table."""
    ours_mean = (ours.halves[0] + ours.halves[1]) / 2
    for family, halves in shared.items():
        if family == "Penumbra":
            continue
        apart = float(((halves[0] - ours.halves[0]) * (halves[1] - ours.halves[1])).mean())
        mean = (halves[0] + halves[1]).mean() / 2
        rows["bias"].append(
            (
                scene.stem,
                family,
                mean / ours_mean.mean() - 1,
                math.sqrt(max(apart, 0)) / ours_mean.mean(),
                apart / targets[0],
                apart / targets[1],
            )
        )


def curves_of(scene, everybody, targets):
    """By renderer, the best way to each target error, or None."""
    curves = {}
    for r in everybody:
        ways = r.ways(scene)
        llvm = next((p for p in everybody if p.name == "Mitsuba llvm_ad_rgb"), None)
        if r.name == "Mitsuba scalar_rgb" and llvm:  # the same code: the same ways
            ways = list(dict.fromkeys(c.way for c in curves[llvm.name] if c))
        curves[r.name] = best_ways(r, scene, r.halves, targets, ways)
        print(
            f"  {scene.stem}, {r.name}: "
            + "; ".join(
                f"{c.way}, {c.at(t)[0]:.3g} samples, {c.at(t)[1]:.3g} s" if c else "not reached"
                for c, t in zip(curves[r.name], targets)
            ),
            flush=True,
        )
    return curves


def add_times(scene, ours, everybody, curves, targets, at_64, rounds, rows):
    """All in turn, to the table."""
    for k, target in enumerate(targets):
        for r in everybody:
            if r.compiles and curves[r.name][k]:
                r.render(scene, curves[r.name][k].way, curves[r.name][k].at(target)[0], 1)
        times = {r.name: [] for r in everybody if curves[r.name][k]}
        for number in range(rounds):
            for r in everybody:
                curve = curves[r.name][k]
                if curve and number < (
                    rounds if curve.at(target)[1] < SLOW else 3 if curve.at(target)[1] < 4 * SLOW else 2
                ):
                    times[r.name].append(time_to(r, scene, curve, target, 11 + number))
        for r in everybody:
            curve = curves[r.name][k]
            pairs = list(zip(times.get(r.name, []), times[ours.name]))
            rows["time"].append(
                (scene.stem, (64, 1024)[k], target, r.name, curve, times.get(r.name), pairs, at_64.get(r.name))
            )


def compare(scene, ours, peers, rounds, rows):
    """Adds a scene to the tables."""
    start = time.monotonic()
    everybody = [ours] + [p for p in peers if p.ways(scene)]
    shared = {}  # Mitsuba's variants have one picture
    for r in everybody:
        family = r.name.split()[0]
        if family not in shared:
            shared[family] = r.references(scene)
        r.halves = shared[family]
    their_mitsuba = next(r for r in everybody if r.name.startswith("Mitsuba"))
    plain = their_mitsuba.plain_way(scene)
    of_64 = statistics.fmean(squared_error(their_mitsuba.render(scene, plain, 64, s)[0], their_mitsuba.halves) for s in (3, 4))
    targets = [of_64, of_64 / 16]
    add_biases(scene, ours, shared, targets, rows)
    curves = curves_of(scene, everybody, targets)
    at_64 = {}
    for r in everybody:
        if curves[r.name][0]:
            image, _, n = r.render(scene, curves[r.name][0].way, 64, 5)
            at_64[r.name] = (n, squared_error(image, r.halves))
    add_times(scene, ours, everybody, curves, targets, at_64, rounds, rows)
    print(f"  {scene.stem}: {time.monotonic() - start:.0f} s", flush=True)


def processes(raytrace, folder, peers, rounds):
    """The whole process on soft_shadow with 16 samples: wall and CPU seconds, in turn."""
    os.sched_setaffinity(0, range(os.cpu_count()))  # Mitsuba writes no picture on one processor alone
    scene = ROOT / "scenes/bench/soft_shadow.toml"
    commands = {"Penumbra": ([raytrace, scene, "-o", folder / "x.exr", "--samples", "16", "--quiet"], {})}
    for p in peers:
        if not p.name.startswith("Mitsuba"):
            continue
        xml = p.xmls(scene, "multijitter direct 1")[0]
        llvm = newest_llvm()
        program = f"import mitsuba as mi; mi.set_variant('{p.variant}'); mi.util.write_bitmap('{folder}/x.exr', mi.render(mi.load_file('{xml}'), spp=16))"
        commands[p.name] = ([sys.executable, "-c", program], {"DRJIT_LIBLLVM_PATH": str(llvm)} if llvm else {})
    used = {name: [] for name in commands}
    for _ in range(rounds + 1):
        for name, (command, environment) in commands.items():
            used[name].append(whole_process(command, environment))
    return {name: [statistics.median(u[k] for u in runs[1:]) for k in (0, 1)] for name, runs in used.items()}


def bench_scene(scene, folder):
    """glossy with as many bounces as paths have, which Mitsuba can express; others as they are."""
    text = scene.read_text()
    if "exponent" not in text or "bounces = 6\n" in text:
        return scene
    copy = folder / scene.name
    copy.write_text(re.sub(r"bounces = \d+", "bounces = 6", text))
    return copy


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("build", type=pathlib.Path, help="the build folder")
    words.add_argument("scenes", nargs="*", type=pathlib.Path, help="default: all that are named above")
    words.add_argument("--rounds", type=int, default=3, help="more rounds, narrower intervals")
    words.add_argument("--peers", default="", help="those alone whose names hold this word")
    words.add_argument("--out", type=pathlib.Path, default=HERE / "peers.md")
    words = words.parse_intermixed_args()
    start = time.monotonic()
    raytrace = words.build.absolute() / "raytrace"
    rows = {"bias": [], "time": []}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        ours = Penumbra(raytrace, folder)
        others, missing = peers(raytrace, folder)
        others = [p for p in others if words.peers in p.name]
        for line in missing:
            print(f"skipped: {line}", flush=True)
        scenes = words.scenes or [
            *sorted((ROOT / "scenes/bench").glob("*.toml")),
            *sorted((ROOT / "scenes/bench/untuned").glob("*.toml")),
            million_triangles(folder),
        ]
        for scene in scenes:
            compare(bench_scene(scene, folder), ours, others, words.rounds, rows)
        whole = processes(raytrace, folder, others, words.rounds)
        command = f"tests/bench/peers.py {words.build} --rounds {words.rounds}" + (f" --peers {words.peers}" if words.peers else "")
        write_tables(rows, missing, whole, command, words.out, time.monotonic() - start)
        for p in others:
            if hasattr(p, "close"):
                p.close()
    print(words.out.read_text())


if __name__ == "__main__":
    main()
