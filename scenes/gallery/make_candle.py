#!/usr/bin/env python3
"""Writes candle.obj: a candle's wax, a profile turned about the y axis, its rim a little uneven."""
from math import cos, pi, sin

AROUND = 48
PROFILE = [(0.41, 0), (0.42, 0.015), (0.42, 0.56), (0.414, 0.59), (0.398, 0.612), (0.375, 0.62), (0.35, 0.61),
           (0.31, 0.58), (0.22, 0.55), (0.1, 0.54)]  # radius, height; from the edge below to the hollow
HOLLOW = 0.538
FLAT, RIM = 0.54, 0.62  # up to the one height all around the same; at the other it varies as uneven() says


def uneven(a):
    return 0.012 * sin(2 * a + 0.6) + 0.008 * sin(3 * a + 2) + 0.005 * sin(5 * a)


def main():
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


if __name__ == "__main__":
    main()
