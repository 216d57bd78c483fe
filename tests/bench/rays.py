#!/usr/bin/env python3
"""Rays per CPU second through meshes of 1e3 to 1e6 triangles, beside Embree's single rays.

    tests/bench/rays.py BUILD [--rounds N] [--write]

Builds tests/bench/rays.cpp in the build folder and runs it; with --write, tests/bench/rays.md is written. Without
Embree (apt-get install libembree-dev, then configure again) only our own figures are shown. Each round times our
stages, Embree with a medium tree and Embree with its best tree, one after the other, on one thread; the ratio is the
median over rounds of ours to the faster of the two, with the least and the greatest round. Then a picture of a mesh of
a million triangles is rendered, for its memory and seconds.
"""

import argparse
import json
import math
import os
import pathlib
import statistics
import subprocess
import tempfile

from figures import machine, table

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent
sizes = [1000, 10_000, 100_000, 1_000_000]
middle = 100_000
kinds = {
    "camera, closest": "coherent",
    "shadow, any": "to a lamp 2 m wide",
    "bounce, closest": "incoherent",
    "bounce, any": "incoherent",
}


def median(values):
    return statistics.median(values)


def ratio(kind):
    if "embree" not in kind:
        return "no Embree"
    rounds = [min(b, c) / a for a, b, c in zip(kind["ours"], kind["embree"], kind["embree_high"])]
    return f"{median(rounds):.2f} ({min(rounds):.2f} to {max(rounds):.2f})"


def speed(kind, who):
    return f"{kind['rays'] / median(kind[who]) / 1e6:.2f}" if who in kind else "–"


def write_mesh(path, triangles):
    """A bumpy ball as a Wavefront file."""
    down = int(math.sqrt(triangles / 4))
    around = triangles // (2 * down)
    with open(path, "w") as out:
        for i in range(down + 1):
            for k in range(around):
                t, p = math.pi * (i + 0.5) / (down + 1), 2 * math.pi * k / around
                r = 1 + 0.05 * math.sin(9 * t) * math.sin(14 * p)
                x, y, z = r * math.sin(t) * math.cos(p), r * math.cos(t), r * math.sin(t) * math.sin(p)
                out.write(f"v {x:.6f} {y:.6f} {z:.6f}\n")
        for i in range(down):
            for k in range(around):
                a, b = i * around + k + 1, i * around + (k + 1) % around + 1
                out.write(f"f {a} {b} {b + around} {a + around}\n")


scene = """
environment = [0.5, 0.5, 0.5]
[render]
samples = 16
[camera]
eye = [0, 1, 4]
target = [0, 0, 0]
vfov = 36
size = [256, 256]
[materials.clay]
albedo = [0.5, 0.4, 0.3]
[[shape]]
type = "mesh"
file = "mesh.obj"
smooth = true
material = "clay"
"""


def render_million(raytrace):
    """Peak memory [MiB] and CPU seconds of a whole process that renders 1e6 triangles with smooth normals."""
    with tempfile.TemporaryDirectory() as work:
        write_mesh(f"{work}/mesh.obj", 1_000_000)
        pathlib.Path(f"{work}/scene.toml").write_text(scene)
        child = subprocess.Popen([raytrace, f"{work}/scene.toml", "-o", f"{work}/image.exr", "--quiet"])
        _, status, used = os.wait4(child.pid, 0)
        assert status == 0
        return used.ru_maxrss / 1024, used.ru_utime + used.ru_stime


def report(results, linked, memory, cpu, rounds):
    sides = ("ours", "embree", "embree_high")
    slower = ", ".join(f"{name} {speed(linked[name], 'ours')}" for name in kinds)
    first, last = results[sizes[0]], results[sizes[-1]]

    def growth(who):
        if who not in first["camera, closest"]:
            return "not known here"
        seconds = [{name: median(r[name][who]) / r[name]["rays"] for name in kinds} for r in (first, last)]
        return ", ".join(f"{name} {seconds[1][name] / seconds[0][name]:.2f}" for name in kinds)

    rays = [
        [f"{n:,}", name, what, *(speed(result[name], who) for who in sides), ratio(result[name])]
        for n, result in results.items()
        for name, what in kinds.items()
    ]
    trees = [
        [f"{n:,}", f"{r['nodes']:,}", f"{r['bytes'] / 1e6:.1f}", f"{median(r['build']):.3f}"]
        + [f"{r[k]:.3f}" if k in r else "–" for k in ("embree_build", "embree_high_build")]
        for n, r in results.items()
    ]
    return f"""# Rays through a mesh

Written by `tests/bench/rays.py BUILD --rounds {rounds} --write` on one thread of {machine()}, which did other work as well.
Millions of rays per CPU second, the medians of the rounds. The mesh is a knot with bumps on a floor; both
sides get the same rays, ours in batches of 64 and in double precision, Embree's one by one and in single.
Embree's two columns are its tree of medium quality and its best.

{table(["triangles", "rays", "", "ours", "Embree", "Embree, best tree", "ratio (least to greatest round)"], rays)}
{table(["triangles", "nodes", "nodes [MB]", "building it [CPU s]", "Embree's", "Embree's best"], trees)}
With fragments that are linked, not included, through {middle:,} triangles: {slower}.

From {sizes[0]:,} to {sizes[-1]:,} triangles the logarithm doubles, and the time of a ray grows by
factors of {growth('ours')}; Embree's of {growth('embree')}.
The nodes that a ray looks at grow with the logarithm (`tests/bvh_test.cpp`); the rest is memory, once the
mesh is larger than the caches.

A whole process that reads 1,000,000 triangles with smooth normals, builds the tree and draws 256 × 256
pixels with 16 samples: {memory:.0f} MiB at most, {cpu:.1f} CPU seconds.

A ratio below 1 falls short of the goal; for camera and shadow rays, one below 1.5. Rays that run side by side share
the way down the tree. Those that surely pass a triangle by are left out in single precision, sixteen rays of a beam
at once, or eight triangles of a leaf (tree/shears.h), most of those whose boxes a ray meets. The fragment
`hit_triangle`, watertight, in double precision, with six divisions, is asked about these. Where triangles are as
small as pixels, rays part early and each goes its own way. Rays that bounce do so from the start: each looks at eight
boxes at a time, a step of about as many instructions as Embree's. In a tree of more nodes than `most_nodes`
(tree/beam.h) no rays go together: they part so early that it took longer; nor are corners kept for its leaves. Nodes
and triangles are in pages of 2 MiB where the system has them (tree/large_pages.h).
"""


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("build", type=pathlib.Path, help="the build folder, configured with -DBUILD_TESTING=ON")
    words.add_argument("--rounds", type=int, default=7)
    words.add_argument("--write", action="store_true", help="write tests/bench/rays.md")
    words = words.parse_args()
    build = ["cmake", "--build", words.build, "--target", "rays", "rays_linked", "raytrace"]
    subprocess.run(build, check=True, stdout=subprocess.DEVNULL)

    def run(program, n):
        command = [words.build / "tests/bench" / program, str(n), "--rounds", str(words.rounds)]
        return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)

    results = {n: run("rays", n) for n in sizes}
    text = report(results, run("rays_linked", middle), *render_million(words.build / "raytrace"), words.rounds)
    print(text)
    if words.write:
        (here / "rays.md").write_text(text)


if __name__ == "__main__":
    main()
