"""Scenes of any size, made where they are needed: many lamps, many triangles."""

import math

LAMPS = """[render]
samples = 16
bounces = 0
[camera]
eye = [0, 4, 6.5]
target = [0, 0.6, 0.3]
vfov = 40
size = [128, 128]
[materials.grey]
albedo = [0.5, 0.5, 0.5]
[materials.lamp]
emission = [12, 12, 12]
[[shape]]
type = "sphere"
center = [0, 1, 0]
radius = 1
material = "grey"
[[shape]]
type = "quad"
center = [0, 0, 0]
u = [25, 0, 0]
v = [0, 0, -25]
material = "grey"
"""

MESH = """[render]
samples = 4
bounces = 0
[camera]
eye = [0, 2.5, 3.5]
target = [0, 0, 0]
vfov = 40
size = [256, 256]
[materials.grey]
albedo = [0.5, 0.5, 0.5]
[[light]]
type = "point"
position = [2, 5, 1]
intensity = [50, 50, 50]
[[shape]]
type = "mesh"
file = "FILE"
material = "grey"
"""

GLOSS = """# A million triangles, hills that float above a glossy floor.
environment = 0.2
[render]
samples = 64
bounces = 6
[camera]
eye = [0, 2.2, 6]
target = [0, 0.3, 0]
vfov = 42
size = [256, 256]
[materials.clay]
albedo = [0.7, 0.4, 0.25]
[materials.floor]
reflectance = [0.6, 0.6, 0.6]
exponent = 200
[materials.lamp]
emission = [14, 14, 14]
[[shape]]
type = "quad"
center = [0, -0.6, 0]
u = [25, 0, 0]
v = [0, 0, -25]
material = "floor"
[[shape]]
type = "quad"
center = [1.5, 4.5, 1]
u = [1, 0.2, 0]
v = [0, 0, 1]
material = "lamp"
[[shape]]
type = "mesh"
file = "FILE"
material = "clay"
"""


def bumps(n, file):
    """A field of hills with about n triangles, as an OBJ file. Returns how many it has."""
    side = round(math.sqrt(n / 2))
    with open(file, "w") as out:
        for j in range(side + 1):
            for i in range(side + 1):
                x, z = 4 * i / side - 2, 4 * j / side - 2
                y = 0.25 * math.sin(5 * x) * math.cos(4 * z) + 0.05 * math.sin(31 * x + 17 * z)
                out.write(f"v {x:.6f} {y:.6f} {z:.6f}\n")
        for j in range(side):
            for i in range(side):
                a = j * (side + 1) + i + 1
                out.write(f"f {a} {a + side + 1} {a + 1}\nf {a + 1} {a + side + 1} {a + side + 2}\n")
    return 2 * side * side


def lamps(n):
    """A grid of n lamps in the ceiling which shine as much as one together."""
    text, side = LAMPS.replace("12, 12, 12", f"{48 / n}, {48 / n}, {48 / n}"), math.ceil(math.sqrt(n))
    for k in range(n):
        x, z = (4 * ((k % side) + 0.5) / side - 2, 4 * ((k // side) + 0.5) / side - 2)
        text += f'[[shape]]\ntype = "quad"\ncenter = [{x}, 4.5, {z}]\nu = [0.1, 0, 0]\nv = [0, 0, 0.1]\nmaterial = "lamp"\n'
    return text


def million_triangles(folder):
    """The scene file: a mesh above a glossy floor."""
    bumps(1000000, folder / "million.obj")
    file = folder / "million_triangles.toml"
    file.write_text(GLOSS.replace("FILE", "million.obj"))
    return file
