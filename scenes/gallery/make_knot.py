#!/usr/bin/env python3
"""Writes knot.obj: a tube along a torus knot, 102,400 triangles as 51,200 quads."""
from math import cos, pi, sin, sqrt

ALONG, AROUND, RADIUS = 640, 80, 0.30
TURNS, LOOPS = 2, 3  # a trefoil


def curve(t):
    r = 1 + 0.45 * cos(LOOPS * t)
    return r * cos(TURNS * t), 0.45 * sin(LOOPS * t), r * sin(TURNS * t)


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = sqrt(sum(x * x for x in a))
    return [x / length for x in a]


def main():
    with open("knot.obj", "w") as out:
        print("# a trefoil knot, written by make_knot.py", file=out)
        for i in range(ALONG):
            t = 2 * pi * i / ALONG
            centre = curve(t)
            along = unit(minus(curve(t + 1e-4), curve(t - 1e-4)))
            # Away from the torus' circle: a direction that comes back to itself after one turn.
            outward = [centre[0] - cos(TURNS * t), centre[1], centre[2] - sin(TURNS * t)]
            x = unit(cross(along, outward))
            y = cross(x, along)
            for k in range(AROUND):
                a = 2 * pi * k / AROUND
                print("v %.4f %.4f %.4f" % tuple(c + RADIUS * (cos(a) * p + sin(a) * q) for c, p, q in zip(centre, x, y)), file=out)
        for i in range(ALONG):
            for k in range(AROUND):
                j, l = (i + 1) % ALONG, (k + 1) % AROUND
                print("f", *(1 + a * AROUND + b for a, b in ((i, k), (j, k), (j, l), (i, l))), file=out)


if __name__ == "__main__":
    main()
