"""The tables that peers.py writes of what it has measured."""

import statistics

import mitsuba
from figures import machine, ratio_interval, table, three_digits


def time_cells(name, curve, target, times, pairs):
    """Way, samples, seconds, ratio and interval of one renderer."""
    if not curve:
        return ["none", "–", "not reached", "–", "–"]
    cells = [curve.way, f"{curve.at(target)[0]:.0f}", three_digits(statistics.median(times))]
    if name == "Penumbra":
        return [*cells, 1, "–"]
    ratio, low, high = map(three_digits, ratio_interval(pairs))
    return [*cells, f"**{ratio}**", f"{low} to {high}"]


def pictures_table(rows, words, seconds):
    text = f"""# Side by side with other renderers

Made by `{words}` in {seconds / 60:.0f} minutes, on {machine()}, shared with other work;
Mitsuba {mitsuba.__version__}. One thread each, CPU seconds of rendering alone, all in turn in one run. What is measured, and how, is said
at the top of [peers.py](peers.py).

## Do they draw the same picture?

The difference between the two converged pictures: of their means, and root mean square over the pixels without
the noise, both relative to the mean; then its square as a share of the two target errors. Errors are measured against each
renderer's own picture, so no renderer pays for a difference.

"""
    text += table(
        ["scene", "peer", "means", "pixels, RMS", "of the error of 64", "of 1024"],
        [
            [scene, family, f"{100 * means:+.3f} %", f"{100 * rms:.2f} %", three_digits(max(a, 0)), three_digits(max(b, 0))]
            for scene, family, means, rms, a, b in rows["bias"]
        ],
    )
    return text


def times_table(rows):
    text = """
Mitsuba has no moving shapes: its motion_blur and lens_motion_lobes are means of 16 time slices. What was set in Cycles to draw
the same is said in [cycles_child.py](cycles_child.py); it takes no part in candle, since its exact balls hold no medium.
POV-Ray's lamps and lenses differ as [povray_scene.py](povray_scene.py) says. Where there are lobes, all follow up to 6
diffuse bounces and 16 lobes, since Mitsuba cannot limit them apart; its Phong lobe runs in the LLVM variant alone.

## CPU seconds to the same error

Each with the fastest of its ways. The ratio is a peer's time over Penumbra's, with its 95 % interval from the rounds.

"""
    heads = ["scene", "error of", "MSE", "renderer", "its way", "samples", "CPU s", "ratio", "interval"]
    text += table(heads, [[scene, level, f"{target:.2e}", name, *time_cells(name, curve, target, times, pairs)]
                          for scene, level, target, name, curve, times, pairs, _ in rows["time"]])
    return text


def patterns_table(rows):
    text = """
## The pattern alone

Mean squared error with 64 samples a pixel, or the nearest number that the pattern has.

"""
    text += table(
        ["scene", "renderer", "way", "samples", "MSE"],
        [
            [scene, name, curve.way, at_64[0], f"{at_64[1]:.2e}"]
            for scene, level, _, name, curve, _, _, at_64 in rows["time"]
            if level == 64 and at_64
        ],
    )
    return text


def write_tables(rows, missing, whole, words, out, seconds):
    d = three_digits
    text = pictures_table(rows, words, seconds) + times_table(rows) + patterns_table(rows)
    text += """
## The whole process

soft_shadow, 256 × 256, 16 samples a pixel, as many threads as each takes by itself, from the program's start to its end with the picture
written; Mitsuba's kernels compiled before.

"""
    text += table(["renderer", "wall s", "CPU s"], [[name, d(wall), d(cpu)] for name, (wall, cpu) in whole.items()])
    if missing:
        text += "\nSkipped: " + "; ".join(missing) + ".\n"
    out.write_text(text)
