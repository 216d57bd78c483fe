"""A scene of diffuse spheres and quads under one quad lamp, in POV-Ray's words.

POV-Ray's space is left-handed: z changes its sign. A lamp of n x n jittered samples reaches half a cell beyond its
axes, so these are shorter by (n - 1)/n. Its samples share the attenuation at the lamp's middle: POV-Ray's penumbrae
are a little off, by what the benchmark says. So are its lenses: the rays' places are the points of a grid that does not
fill a disc, and the aperture which comes nearest to a lens of radius r is 4 r.
"""

import math

import numpy as np


def vector(v):
    return f"<{v[0]:.9g}, {v[1]:.9g}, {-v[2]:.9g}>"


def color(c):
    return f"rgb <{c[0]:.9g}, {c[1]:.9g}, {c[2]:.9g}>"


def texture(material):
    return f"texture {{ pigment {{ {color(material['albedo'])} }} finish {{ ambient 0 diffuse 1 emission 0 }} }}"


def corners(shape):
    """Once around a quad."""
    c, u, v = (np.array(shape[k], dtype=float) for k in ("center", "u", "v"))
    return [c - u - v, c + u - v, c + u + v, c - u + v, c - u - v]


def lamp(shape, emission, n):
    c, u, v = (np.array(shape[k], dtype=float) for k in ("center", "u", "v"))
    normal = np.cross(u, v)
    area = 4 * np.linalg.norm(normal)
    near = 1e-4  # attenuation 2 / (1 + (r / near)^2)
    intensity = np.array(emission, dtype=float) * area / math.pi / (2 * near * near)
    shrink = 2 * (n - 1) / n
    return (
        f"light_source {{ {vector(c)} {color(intensity)} fade_power 2 fade_distance {near}\n"
        f"  spotlight radius 90 falloff 90 tightness 1 point_at {vector(c + normal)}\n"
        f"  area_light {vector(shrink * u)}, {vector(shrink * v)}, {n}, {n} jitter area_illumination on }}\n"
    )


def to_povray(scene, lamp_samples, blur_samples):
    """The text of a scene; blur_samples: rays of a pixel, through the lens."""
    camera = scene["camera"]
    eye, target = np.array(camera["eye"], dtype=float), np.array(camera["target"], dtype=float)
    aspect = camera["size"][0] / camera["size"][1]
    angle = 2 * math.degrees(math.atan(aspect * math.tan(math.radians(camera["vfov"]) / 2)))
    text = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
    text += (
        f"camera {{ perspective location {vector(eye)} up <0, 1, 0> right <{aspect}, 0, 0>\n"
        f"  sky {vector(camera['up'])} angle {angle:.9g} look_at {vector(target)}\n"
    )
    if blur_samples:
        # Of no width where there is no lens: a pixel's rays are spread over it all the same.
        focus = eye + camera.get("focus", 1) * (target - eye) / np.linalg.norm(target - eye)
        text += (
            f"  focal_point {vector(focus)} aperture {4 * camera.get('lens_radius', 1e-9):.9g}\n"
            f"  blur_samples {blur_samples} variance 0 confidence 0.999999\n"
        )
    text += "}\n"
    for shape in scene["shape"]:
        material = scene["materials"][shape["material"]]
        if "emission" in material:
            text += lamp(shape, material["emission"], lamp_samples)
        elif shape["type"] == "sphere":
            text += f"sphere {{ {vector(shape['center'])}, {shape['radius']} {texture(material)} }}\n"
        else:
            text += f"polygon {{ 5, {', '.join(map(vector, corners(shape)))} {texture(material)} }}\n"
    return text
