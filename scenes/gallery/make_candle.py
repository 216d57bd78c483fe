#!/usr/bin/env python3
"""Writes candle.obj: a closed candle of wax, radius 0.5, height 1.6, with a rounded rim and a hollow around the wick."""
from math import cos, pi, sin

AROUND = 96


def profile():
    """Points (radius, height) from the middle of the foot to the middle of the top."""
    points = [(0.47, 0.0), (0.5, 0.03)] + [(0.5, 0.03 + 1.45 * i / 16) for i in range(1, 17)]
    points += [(0.42 + 0.08 * cos(a), 1.48 + 0.10 * sin(a)) for a in (pi * i / 16 for i in range(1, 9))]
    points += [(0.42 - 0.30 * i / 12, 1.58 - 0.10 * sin(pi / 2 * i / 12)) for i in range(1, 13)]
    return points


def main():
    rings = profile()
    foot, top = 1 + len(rings) * AROUND, 2 + len(rings) * AROUND
    with open("candle.obj", "w") as out:
        print("# a candle, written by make_candle.py", file=out)
        for r, y in rings:
            for k in range(AROUND):
                a = 2 * pi * k / AROUND
                print("v %.4f %.4f %.4f" % (r * cos(a), y, r * sin(a)), file=out)
        print("v 0 0 0\nv 0 %.4f 0" % rings[-1][1], file=out)
        for i in range(len(rings) - 1):
            for k in range(AROUND):
                l, low, high = (k + 1) % AROUND, 1 + i * AROUND, 1 + (i + 1) * AROUND
                print("f", low + l, low + k, high + k, high + l, file=out)
        last = 1 + (len(rings) - 1) * AROUND
        for k in range(AROUND):
            l = (k + 1) % AROUND
            print("f", foot, 1 + k, 1 + l, file=out)
            print("f", top, last + l, last + k, file=out)


if __name__ == "__main__":
    main()
