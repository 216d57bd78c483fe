#!/usr/bin/env python3
"""Holds the solution's pictures against Mitsuba 3: compare.py --raytrace PROGRAM [SCENE.toml ...]

Each scene is rendered by both, 16 times with other seeds. The means of the picture, of its 16 parts, of its 64 parts,
and of each colour are compared by Welch's t, turned into standard errors of a normal distribution. A scene agrees if
none of them is so far off that it happens in one of 100 runs over all scenes by chance (Bonferroni), which is some four
standard errors; how many are beyond three is printed beside how many chance puts there. "finds" is how much brighter
the 16 parts would have to be to fail, in the median; a scene too noisy to find 3 % fails as well.

Exit status: 0 all agree, 1 some do not, 77 no Mitsuba here.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

PARTS = (1, 4, 8)  # along each side of the picture
MIDDLE = slice(1, 17)  # the 16 parts, of which relative differences are told
REPLICATES = 16
FALSE_ALARMS = 0.01  # chance that one of all comparisons of all scenes fails though both are right
SHARPNESS = 0.03  # a relative difference everywhere that must be found
NEGLIGIBLE = 1e-4  # of the whole picture's mean: single precision, and light so rare that no sample may have met it
OUR_SAMPLES = 4  # times Mitsuba's

HERE = pathlib.Path(__file__).resolve().parent
NORMAL = statistics.NormalDist()


def parts_of(image):
    """The means of the picture's parts, colour by colour."""
    height, width = image.shape[:2]
    means = [image.reshape(n, height // n, n, width // n, 3).mean(axis=(1, 3), dtype=np.float64) for n in PARTS]
    return np.concatenate([m.reshape(-1, 3) for m in means])


def name_of(part):
    """Where a part is, in words."""
    for n in PARTS:
        if part < n * n:
            return f"part {part % n + 1} of row {part // n + 1} of {n}" if n > 1 else "the whole picture"
        part -= n * n


def render_ours(raytrace, scene, samples, seeds, folder):
    images = []
    for seed in seeds:
        out = folder / "ours.exr"
        subprocess.run([raytrace, scene, "-o", out, "--samples", str(samples), "--seed", str(seed), "--quiet"], check=True)
        images.append(np.array(mi.Bitmap(str(out)))[..., :3])
    return images


def render_theirs(xml, seeds):
    scene = mi.load_file(str(xml))
    images = [np.array(mi.render(scene, seed=seed))[..., :3] for seed in seeds]
    return images, scene.sensors()[0].sampler().sample_count()


def standard_errors(a, b):
    """The difference of two means as standard errors of a normal distribution, and one standard error.

    Welch's t; the normal quantile of the same probability by Wallace, "Bounds on normal approximations to Student's and
    the chi-square distributions", Ann. Math. Statist. 30, 1959.
    """
    va, vb = a.var(axis=0, ddof=1) / len(a), b.var(axis=0, ddof=1) / len(b)
    mean_a, mean_b = a.mean(axis=0), b.mean(axis=0)
    variance = va + vb + (NEGLIGIBLE * mean_b[0].mean()) ** 2
    degrees = 1 / np.maximum((va**2 + vb**2) / (len(a) - 1) / variance**2, 1e-4)
    t = (mean_a - mean_b) / np.sqrt(variance)
    z = np.sign(t) * (8 * degrees + 1) / (8 * degrees + 3) * np.sqrt(degrees * np.log1p(t * t / degrees))
    return z, np.sqrt(variance)


def compare(scene, options, folder, scenes):
    """One line of the table: whether the scene agrees, how many comparisons, and how many are beyond three."""
    start, raytrace, keep = time.time(), options.raytrace, options.keep
    seeds = range(options.seed * REPLICATES, (options.seed + 1) * REPLICATES)
    xml = folder / (scene.stem + ".xml")
    subprocess.run([raytrace, scene, "--export-mitsuba", xml], check=True)
    theirs, samples = render_theirs(xml, seeds)
    ours = render_ours(raytrace, scene, OUR_SAMPLES * samples, seeds, folder)
    if keep:
        for name, images in (("ours", ours), ("mitsuba", theirs)):
            mi.Bitmap(np.mean(images, axis=0).astype(np.float32)).write(str(keep / f"{scene.stem}-{name}.exr"))

    a, b = np.array([parts_of(i) for i in ours]), np.array([parts_of(i) for i in theirs])
    if np.ptp(a, axis=2).max() == 0 and np.ptp(b, axis=2).max() == 0:
        a, b = a[..., :1], b[..., :1]  # grey: three times the same comparison
    z, error = standard_errors(a, b)
    mean = b.mean(axis=0)
    bound = -NORMAL.inv_cdf(FALSE_ALARMS / scenes / z.size / 2)
    furthest, beyond = np.abs(z).max(), int((np.abs(z) > 3).sum())

    # Relative differences of the 16 parts, but for those that are all but black.
    middle = mean[MIDDLE]
    bright = middle > 0.01 * mean[0].mean()
    deviation = np.abs(a.mean(axis=0)[MIDDLE][bright] / middle[bright] - 1).max()
    noise = (error[MIDDLE] / np.maximum(middle, 1e-300))[bright & (error[MIDDLE] > 2 * NEGLIGIBLE * mean[0].mean())]
    finds = np.median(bound * noise) if noise.size else 0
    verdict = "DIFFERS" if not furthest < bound else "TOO NOISY" if finds > SHARPNESS else "agrees"
    print(f"{scene.stem:24} {z.size:5} {furthest:7.2f} {bound:6.2f} {beyond:7} {100 * deviation:9.3f} % {100 * finds:7.3f} % "
          f"{time.time() - start:6.1f} s  {verdict}", flush=True)
    if verdict == "DIFFERS":
        part, channel = np.unravel_index(np.abs(z).argmax(), z.shape)
        print(f"    {name_of(part)}, {'red green blue'.split()[channel]}: {a.mean(axis=0)[part, channel]:.6g} here, "
              f"{mean[part, channel]:.6g} in Mitsuba, standard error {error[part, channel]:.2g}")
    return verdict == "agrees", z.size, beyond


def main():
    words = argparse.ArgumentParser(description="Holds the solution's pictures against Mitsuba 3.")
    words.add_argument("--raytrace", required=True, help="the renderer with the solution's fragments")
    words.add_argument("--seed", type=int, default=0, help="another one, other noise")
    words.add_argument("--keep", type=pathlib.Path, help="a folder for the mean pictures of both")
    words.add_argument("scenes", nargs="*", type=pathlib.Path, help="default: all of scenes/ beside this file")
    options = words.parse_args()
    everything = sorted((HERE / "scenes").glob("*.toml"))
    scenes = options.scenes or everything
    if options.keep:
        options.keep.mkdir(parents=True, exist_ok=True)

    print(f"Mitsuba {mi.__version__}, {mi.variant()}; {REPLICATES} seeds each")
    print(f"{'scene':24} {'means':>5} {'max |z|':>7} {'bound':>6} {'|z| > 3':>7} {'deviation':>11} {'finds':>9} {'time':>8}")
    agree, means, beyond, start = True, 0, 0, time.time()
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            ok, n, far = compare(scene, options, pathlib.Path(folder), max(len(scenes), len(everything)))
            agree, means, beyond = agree and ok, means + n, beyond + far
    print(f"{beyond} of {means} means are beyond three standard errors; chance puts {means * 2 * NORMAL.cdf(-3):.1f} there. "
          f"{time.time() - start:.0f} s. {'All scenes agree.' if agree else 'Not all scenes agree.'}")
    return 0 if agree else 1


def without_mitsuba(why):
    """Starts again with the Python that has it, if there is one."""
    python = HERE.parent.parent / "build" / "mitsuba" / "bin" / "python3"
    if python.exists() and pathlib.Path(sys.prefix) != python.parent.parent:
        os.execv(python, [str(python)] + sys.argv)
    print(f"skipped: {why}. To install it: python3 -m venv build/mitsuba && build/mitsuba/bin/pip install mitsuba numpy")
    sys.exit(77)


try:
    import mitsuba as mi
    import numpy as np
except ImportError as missing:
    without_mitsuba(missing)

mi.set_variant("scalar_rgb")  # needs no LLVM
mi.set_log_level(mi.LogLevel.Error)

if __name__ == "__main__":
    import lobe

    lobe.register()
    sys.exit(main())
