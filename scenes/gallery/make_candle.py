#!/usr/bin/env python3
"""Writes candle.obj, a candle's wax: a profile turned about the y axis, its rim a little uneven; wick.obj; flame.obj."""
from math import cos, pi, sin

AROUND = 48
PROFILE = [(0.41, 0), (0.42, 0.015), (0.42, 0.56), (0.414, 0.59), (0.398, 0.612), (0.375, 0.62), (0.35, 0.61),
           (0.31, 0.58), (0.22, 0.55), (0.1, 0.54)]  # radius, height; from the edge below to the hollow
HOLLOW = 0.538
FLAT, RIM = 0.54, 0.62  # up to the one height all around the same; at the other it varies as uneven() says
WICK_AROUND, WICK_RISE, WICK_RADIUS, WICK_BEND = 12, 10, 0.011, 0.016  # corners around and upwards; its tip is off by the last
WICK_LOW, WICK_HIGH = 0.5, 0.715
LAYERS, SMALLEST, STEPS = 16, 0.7, 24  # of the flame; its last over its first; of each side of a layer
MIDDLE = 0.3  # height of the point towards which layers shrink


def uneven(a):
    return 0.012 * sin(2 * a + 0.6) + 0.008 * sin(3 * a + 2) + 0.005 * sin(5 * a)


def write_wax():
    with open("candle.obj", "w") as out:
        print("# a candle's wax, written by make_candle.py", file=out)
        print("v 0 0 0", f"v 0 {HOLLOW} 0", sep="\n", file=out)
        for radius, height in PROFILE:
            for k in range(AROUND):
                a = 2 * pi * k / AROUND
                y = height + max(0, (height - FLAT) / (RIM - FLAT)) * uneven(a)
                print(f"v {radius * cos(a):.4f} {y:.4f} {-radius * sin(a):.4f}", file=out)
        last = len(PROFILE) - 1
        corner = lambda i, k: 3 + i * AROUND + k % AROUND
        for k in range(AROUND):
            print("f", 1, corner(0, k + 1), corner(0, k), file=out)
            for i in range(last):
                print("f", corner(i, k), corner(i, k + 1), corner(i + 1, k + 1), corner(i + 1, k), file=out)
            print("f", 2, corner(last, k), corner(last, k + 1), file=out)


def write_wick():
    """A round cord that leans over, thinner towards its tip."""
    with open("wick.obj", "w") as out:
        print("# a candle's wick, written by make_candle.py", file=out)
        print("v 0 %.4f 0" % WICK_LOW, "v %.4f %.4f 0" % (WICK_BEND, WICK_HIGH), sep="\n", file=out)
        for i in range(WICK_RISE):
            up = i / (WICK_RISE - 1)
            radius, y = WICK_RADIUS * (1 - 0.45 * up**3), WICK_LOW + (WICK_HIGH - 0.004 - WICK_LOW) * up
            for k in range(WICK_AROUND):
                a = 2 * pi * k / WICK_AROUND
                print(f"v {WICK_BEND * up**2 + radius * cos(a):.4f} {y:.4f} {-radius * sin(a):.4f}", file=out)
        corner = lambda i, k: 3 + i * WICK_AROUND + k % WICK_AROUND
        for k in range(WICK_AROUND):
            print("f", 1, corner(0, k + 1), corner(0, k), file=out)
            for i in range(WICK_RISE - 1):
                print("f", corner(i, k), corner(i, k + 1), corner(i + 1, k + 1), corner(i + 1, k), file=out)
            print("f", 2, corner(WICK_RISE - 1, k), corner(WICK_RISE - 1, k + 1), file=out)


def write_flame():
    """Drops of height and half width 1 that face z, one behind another, each smaller than the one before it."""
    angles = [pi * k / STEPS for k in range(1, STEPS)]
    widest = 4 / 27**0.5  # is the most that sin(a) cos(a/2) comes to
    side = [(sin(a) * cos(a / 2) / widest, (1 - cos(a)) / 2) for a in angles]  # from below to the tip
    outline = [(0, 0), *side, (0, 1), *((-x, y) for x, y in reversed(side))]
    with open("flame.obj", "w") as out:
        print("# layers of a flame, written by make_candle.py", file=out)
        for layer in range(LAYERS):
            size = 1 - (1 - SMALLEST) * layer / LAYERS
            for x, y in outline:
                print(f"v {size * x:.4f} {MIDDLE + size * (y - MIDDLE):.4f} {-layer}", file=out)
            corner = lambda i: 1 + len(outline) * layer + i % len(outline)
            for i in range(STEPS):
                strip = [corner(i), corner(i + 1), corner(-i - 1), corner(-i)]
                print("f", *dict.fromkeys(strip), file=out)  # a triangle below and at the tip


def main():
    write_wax()
    write_wick()
    write_flame()


if __name__ == "__main__":
    main()
