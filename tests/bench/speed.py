#!/usr/bin/env python3
"""How fast the renderer and the grader are on this machine: medians of some runs.

    tests/bench/speed.py BUILD [--runs N] [--builds]

Samples per CPU second of each benchmark scene on one thread, rendering alone; then the wall seconds from one edited
fragment to its verdict, and of the solution from its sources to all verdicts. Nothing is kept between gradings.
With --builds, once: the wall seconds of clean builds, on all cores and without a compiler cache.
"""

import argparse
import os
import pathlib
import re
import statistics
import subprocess
import tempfile
import time

root = pathlib.Path(__file__).resolve().parent.parent.parent
edited = ["hit_sphere", "light_sample", "scatter_direction"]


def samples_per_second(raytrace, scene, out):
    """Millions of samples per CPU second, as raytrace reports them."""
    done = subprocess.run(
        [raytrace, scene, "-o", out, "--threads", "1", "--samples", "64"], capture_output=True, text=True, check=True
    )
    return float(re.search(r"([0-9.]+) M samples per CPU second", done.stdout + done.stderr).group(1))


def seconds(command):
    start = time.monotonic()
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
    return time.monotonic() - start


def clean_build(source, folder, *options):
    environment = os.environ | {"CCACHE_DISABLE": "1"}
    configure = ["cmake", "-S", source, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *options]
    subprocess.run(configure, stdout=subprocess.DEVNULL, check=True, env=environment)
    start = time.monotonic()
    subprocess.run(["cmake", "--build", folder], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True, env=environment)
    return time.monotonic() - start


def report(what, values, unit):
    print(f"{what:40} {statistics.median(values):8.2f} {unit}  ({min(values):.2f} to {max(values):.2f})", flush=True)


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("build", type=pathlib.Path, help="the build folder")
    words.add_argument("--runs", type=int, default=5)
    words.add_argument("--builds", action="store_true", help="clean builds too: some minutes")
    words = words.parse_args()
    processor = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    print(f"{processor.group(1) if processor else 'unknown processor'}, {words.runs} runs: median (least to greatest)")
    with tempfile.TemporaryDirectory() as work:
        for scene in sorted((root / "scenes/bench").glob("*.toml")):
            runs = [
                samples_per_second(words.build / "raytrace", scene, f"{work}/image.exr") for _ in range(words.runs)
            ]
            report(scene.stem, runs, "M samples per CPU second")
    grade = [words.build / "grader/grade", root / "solution", "--seed", "1"]
    for name in edited:
        report(f"{name} edited, to its verdict", [seconds([*grade, name]) for _ in range(words.runs)], "s")
    report("the whole solution, all verdicts", [seconds(grade) for _ in range(words.runs)], "s")
    if words.builds:
        with tempfile.TemporaryDirectory() as work:
            report("clean build, the student's part", [clean_build(root / "starter", f"{work}/starter")], "s")
            report("clean build, what ./grade builds", [clean_build(root, f"{work}/grade")], "s")
            report("clean build, with all tests", [clean_build(root, f"{work}/check", "-DBUILD_TESTING=ON")], "s")


if __name__ == "__main__":
    main()
