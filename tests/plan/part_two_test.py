#!/usr/bin/env python3
"""Part 2 alone makes complete Whitted pictures: part_two_test.py BUILD

1. The scenes of part 2, at their own size and samples, drawn by a program whose parts 3 and 4 are blank: the same bits as
   with the whole solution, and no blank is called.
2. While fragments are filled in one after the other, in the order of the handout, each scene is complete as soon as the
   table says: with that fragment its picture has the bits of the whole solution's, without it it has not.
"""

import concurrent.futures
import os
import pathlib
import sys
import tempfile
import tomllib

from programs import Programs, draw
from helpers import ROOT, end, expect, fragments_in_order

# With which fragment each scene is complete. A scene is complete with the fragment that it is for; but one with mirrors or
# glass waits for whitted, which sends on the rays.
COMPLETE_WITH = {
    # part 2
    "camera_ray": "camera",
    "hit_sphere": "hit_sphere",
    "hit_triangle": "hit_triangle",
    "hit_quad": "hit_quad",
    "point_irradiance": "point_light",
    "phong": "phong hit_disc",
    "shadow_ray": "shadow directional_light many_shapes mesh",
    "whitted": "mirror refraction fresnel whitted glass_furnace",
    # parts 3 and 4
    "pixel_mean": "antialiasing pixel_mean environment furnace white_ball checkerboard whitted_1980",
    "direct_light": "penumbra direct_light disc_light sphere_light many_lights bench/soft_shadow bench/untuned/forty_lamps",
    "glossy_reflection": "glossy glossy_balls gallery/gloss",
    "translucency": "translucency",
    "lens_ray": "depth_of_field bench/dof gallery/bokeh",
    "moved": "motion_blur bench/motion_blur",
    "color_bleeding": "color_bleeding bench/color_bleeding bench/untuned/tilted_room gallery/cornell gallery/motion gallery/room gallery/soft_shadows",
    "emission_counts": "caustic emission_counts bench/glossy bench/untuned/lobes_lens bench/untuned/lens_motion_lobes gallery/caustic gallery/frosted_glass gallery/knot gallery/still_life",
    "free_flight": "absorption",
    "scatter_direction": "scattering medium_furnace bench/untuned/candle gallery/candle gallery/everything",
}

def file_of(scene):
    return ROOT / "scenes" / f"{scene}.toml"


def small(scene):
    """A small picture, of a few samples where the scene has many."""
    samples = tomllib.loads(file_of(scene).read_text()).get("render", {}).get("samples", 16)
    return ["--size", "48x48", "--samples", str(min(samples, 4))]


def main():
    build = pathlib.Path(sys.argv[1]).absolute()
    programs = Programs(build)
    parts = fragments_in_order()
    order = [fragment for part in parts.values() for fragment in part]
    listed = {scene for scenes in COMPLETE_WITH.values() for scene in scenes.split()}
    there = {str(f.relative_to(ROOT / "scenes").with_suffix("")) for f in (ROOT / "scenes").rglob("*.toml")}
    expect(listed == there, f"the table and the scenes differ: {sorted(listed ^ there)}")

    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        work = pathlib.Path(folder)

        def picture(program, scene, options=()):
            out = work / f"{program.name}-{scene.replace('/', '-')}.exr"
            return draw(program, file_of(scene), out, options)

        def complete_alone(scene):
            usual, _ = picture(build / "raytrace_linked", scene)
            alone, blanks = picture(part_two, scene)
            expect(alone == usual, f"{scene}: parts 1 and 2 alone draw another picture than the whole solution")
            expect(not blanks, f"{scene}: calls {sorted(blanks)} of parts 3 and 4")

        def complete_with(fragment):
            count = order.index(fragment)
            before = programs.link(order[:count], work / f"before-{fragment}")
            after = programs.link(order[: count + 1], work / f"after-{fragment}")
            for scene in COMPLETE_WITH[fragment].split():
                options = small(scene)
                usual, _ = picture(build / "raytrace_linked", scene, options)
                expect(picture(after, scene, options)[0] == usual, f"{scene}: not complete with {fragment}")
                expect(picture(before, scene, options)[0] != usual, f"{scene}: complete before {fragment}")

        part_two = programs.link(parts["integrals"] + parts["whitted"], work / "part-two")
        of_part_two = [scene for f in parts["whitted"] for scene in COMPLETE_WITH.get(f, "").split()]
        list(pool.map(complete_alone, of_part_two))
        list(pool.map(complete_with, COMPLETE_WITH))
    end(f"{len(of_part_two)} scenes are complete with parts 1 and 2; the table is right for all {len(listed)}")


if __name__ == "__main__":
    main()
