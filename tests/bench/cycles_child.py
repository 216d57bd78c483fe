"""Renders with Cycles as it is told, line by line: cycles_child.py, with a Python that has bpy.

Reads {"scene": "NAME.toml", "way": [...], "samples": n, "seed": s, "out": "NAME.exr"}, renders the scene with n samples a
pixel on one thread, writes the picture, and answers {"cpu": seconds of rendering alone}: of the whole call, less those of a
call that renders one sample of one pixel. A way is a sampling pattern, then "tree" where one of many lamps is chosen by Cycles' light tree.

What is set so that the pictures agree: pixels are boxes, nothing is clamped or filtered, lamps are Cycles' own, in watts,
balls are points with a radius, which Cycles meets as exact balls, the shutter is open evenly, and a glossy lobe is
OSL's phong_ramp in one colour.
"""

import json
import math
import os
import pathlib
import statistics
import sys
import time
import tomllib

answers = os.fdopen(os.dup(1), "w", buffering=1)
os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # nothing else gets between the answers

import bpy  # noqa: E402
import numpy as np  # noqa: E402
from mathutils import Matrix, Vector  # noqa: E402

LOBE = """shader lobe(color Color = 0, float Exponent = 1, output closure color BSDF = 0) {
    color same[8] = {Color, Color, Color, Color, Color, Color, Color, Color};
    BSDF = phong_ramp(N, Exponent, same);
}
"""


def color(value):
    """As a scene file says it, a number or three."""
    return [float(c) for c in (value if isinstance(value, list) else [value] * 3)]


def lobe_node(nodes, material):
    import cycles.osl

    text = bpy.data.texts.new("lobe")
    text.write(LOBE)
    node = nodes.new("ShaderNodeScript")
    node.script = text
    if not cycles.osl.update_script_node(node, lambda kind, what: None) and not node.inputs:
        raise RuntimeError("the lobe's OSL was not compiled")
    node.inputs["Color"].default_value = [*color(material["reflectance"]), 1][: len(node.inputs["Color"].default_value)]
    node.inputs["Exponent"].default_value = material["exponent"]
    return node


def make_material(name, said):
    """Diffuse, a lobe, or both."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    parts = []
    if "albedo" in said or "reflectance" not in said:
        parts.append(nodes.new("ShaderNodeBsdfDiffuse"))
        parts[-1].inputs["Color"].default_value = [*color(said.get("albedo", 0)), 1]
        parts[-1].inputs["Roughness"].default_value = 0
    if "reflectance" in said:
        parts.append(lobe_node(nodes, said))
    surface = parts[0].outputs[0]
    if len(parts) > 1:
        both = nodes.new("ShaderNodeAddShader")
        for part, place in zip(parts, both.inputs):
            links.new(part.outputs[0], place)
        surface = both.outputs[0]
    links.new(surface, nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return made


def add(scene, data, matrix=None):
    thing = bpy.data.objects.new("shape", data)
    if matrix is not None:
        thing.matrix_world = matrix
    scene.collection.objects.link(thing)
    return thing


def frame(x, y, z, origin):
    columns = [Vector(v).normalized() for v in (x, y, z)]
    rows = [[c[i] for c in columns] + [origin[i]] for i in range(3)]
    return Matrix([*rows, [0, 0, 0, 1]])


def add_lamp(scene, shape, emission):
    """A lamp of Cycles' own: a rectangle that shines forwards, or a ball."""
    if shape["type"] == "sphere":
        lamp = bpy.data.lights.new("lamp", "POINT")
        lamp.shadow_soft_size, lamp.use_soft_falloff = shape["radius"], False
        lamp.energy = 4 * math.pi**2 * shape["radius"] ** 2
        matrix = Matrix.Translation(shape["center"])
    else:
        lamp = bpy.data.lights.new("lamp", "AREA")
        u, v = Vector(shape["u"]), Vector(shape["v"])
        lamp.shape, lamp.size, lamp.size_y = "RECTANGLE", 2 * u.length, 2 * v.length
        lamp.energy = math.pi * lamp.size * lamp.size_y
        matrix = frame(u, -v, -u.cross(v), shape["center"])
    lamp.color = emission
    add(scene, lamp, matrix).visible_camera = True


def behind(shape):
    """What stands in light's way where a lamp is: Cycles' own lamps let it through."""
    if shape["type"] == "sphere":
        return {**shape, "radius": (1 - 1e-4) * shape["radius"]}
    u, v = Vector(shape["u"]), Vector(shape["v"])
    return {**shape, "center": list(Vector(shape["center"]) - 1e-4 * max(u.length, v.length) * u.cross(v).normalized())}


def ball(radius, material):
    """A point with a radius, through a node that makes points of a mesh's corners."""
    mesh = bpy.data.meshes.new("point")
    mesh.from_pydata([(0, 0, 0)], [], [])
    group = bpy.data.node_groups.new("ball", "GeometryNodeTree")
    group.interface.new_socket("in", in_out="INPUT", socket_type="NodeSocketGeometry")
    group.interface.new_socket("out", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    names = ("NodeGroupInput", "GeometryNodeMeshToPoints", "GeometryNodeSetMaterial", "NodeGroupOutput")
    nodes = [group.nodes.new(name) for name in names]
    for a, b in zip(nodes, nodes[1:]):
        group.links.new(a.outputs[0], b.inputs[0])
    nodes[1].inputs["Radius"].default_value = radius
    nodes[2].inputs["Material"].default_value = material
    return mesh, group


def mesh_of(shape, folder):
    """The corners and triangles of a quad, a triangle or an OBJ file."""
    if shape["type"] == "quad":
        c, u, v = (np.array(shape[k], dtype=float) for k in ("center", "u", "v"))
        return np.array([c - u - v, c + u - v, c + u + v, c - u + v]), np.array([[0, 1, 2], [0, 2, 3]])
    lines = (folder / shape["file"]).read_text().splitlines()
    corners = np.array([line.split()[1:4] for line in lines if line.startswith("v ")], dtype=np.float32)
    faces = np.array([line.split()[1:4] for line in lines if line.startswith("f ")], dtype=np.int32) - 1
    return corners, faces


def add_shape(scene, shape, material, shutter, folder):
    if shape["type"] != "sphere":
        mesh = bpy.data.meshes.new("mesh")
        corners, faces = mesh_of(shape, folder)
        mesh.vertices.add(len(corners))
        mesh.vertices.foreach_set("co", corners.astype(np.float32).ravel())
        mesh.loops.add(faces.size)
        mesh.loops.foreach_set("vertex_index", faces.astype(np.int32).ravel())
        mesh.polygons.add(len(faces))
        mesh.polygons.foreach_set("loop_start", np.arange(0, faces.size, 3, dtype=np.int32))
        mesh.update(calc_edges=True)
        mesh.materials.append(material)
        add(scene, mesh)
        return
    mesh, group = ball(shape["radius"], material)
    thing = add(scene, mesh, Matrix.Translation(shape["center"]))
    thing.modifiers.new("ball", "NODES").node_group = group
    velocity = shape.get("velocity", [0, 0, 0])
    if shutter and any(velocity):
        for number, at in enumerate((shutter["open"], shutter["close"]), 1):
            thing.location = Vector(shape["center"]) + at * Vector(velocity)
            thing.keyframe_insert("location", frame=number)
        for curve in thing.animation_data.action.fcurves:
            for point in curve.keyframe_points:
                point.interpolation = "LINEAR"


def add_camera(scene, said):
    data = bpy.data.cameras.new("camera")
    eye, target, up = (Vector(said.get(k, d)) for k, d in (("eye", 0), ("target", 0), ("up", [0, 1, 0])))
    back = (eye - target).normalized()
    right = up.cross(back).normalized()
    scene.camera = add(scene, data, frame(right, back.cross(right), back, eye))
    data.sensor_fit, data.angle = "VERTICAL", math.radians(said["vfov"])
    data.clip_start, data.clip_end = 1e-3, 1e5
    if said.get("lens_radius", 0) > 0:
        data.dof.use_dof, data.dof.focus_distance = True, said["focus"]
        data.dof.aperture_fstop = 1e-3 * data.lens / (2 * said["lens_radius"])
    scene.render.resolution_x, scene.render.resolution_y = said["size"]


def set_cycles(scene, said, lobes):
    render, cycles = scene.render, scene.cycles
    render.engine, render.threads_mode, render.threads = "CYCLES", "FIXED", 1
    render.resolution_percentage, render.use_persistent_data = 100, True
    render.use_compositing = render.use_sequencer = False
    render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
    render.image_settings.exr_codec = "NONE"
    cycles.device, cycles.pixel_filter_type, cycles.filter_width = "CPU", "BOX", 1
    cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_auto_tile = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = cycles.light_sampling_threshold = 0
    cycles.shading_system = lobes
    bounces, depth = said.get("bounces", 0), said.get("depth", 16) if lobes else 0
    cycles.max_bounces = bounces + depth
    cycles.diffuse_bounces, cycles.glossy_bounces = bounces, depth
    cycles.min_light_bounces = 0


def load(file):
    """The scene, ready to be rendered."""
    file = pathlib.Path(file)
    said = tomllib.loads(file.read_text())
    scene = bpy.data.scenes.new(file.stem)
    materials = said["materials"]
    set_cycles(scene, said["render"], any("exponent" in m for m in materials.values()))
    add_camera(scene, said["camera"])
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = [*color(said.get("environment", 0)), 1]
    scene.render.use_motion_blur = "shutter" in said
    scene.render.motion_blur_position, scene.render.motion_blur_shutter = "START", 1
    for point in scene.render.motion_blur_shutter_curve.curves[0].points:
        point.location.y = 1
    scene.render.motion_blur_shutter_curve.update()
    scene.frame_set(1)
    made = {name: make_material(name, m) for name, m in materials.items() if "emission" not in m}
    shining = [shape for shape in said["shape"] if "emission" in materials[shape["material"]]]
    black = make_material("black", {})
    # Behind a lamp for direct light alone there is none that could be stopped.
    alone = len(shining) == 1 and scene.cycles.max_bounces == 0 and "environment" not in said
    for shape in said["shape"]:
        if shape in shining:
            add_lamp(scene, shape, color(materials[shape["material"]]["emission"]))
            if not alone:
                add_shape(scene, behind(shape), black, None, file.parent)
        else:
            add_shape(scene, shape, made[shape["material"]], said.get("shutter"), file.parent)
    return scene


def render(scene, order):
    """CPU seconds of the whole call."""
    pattern, *more = order["way"]
    scene.cycles.sampling_pattern = pattern.upper()
    scene.cycles.use_light_tree = "tree" in more
    scene.cycles.samples, scene.cycles.seed = order["samples"], order["seed"]
    scene.render.filepath = order["out"]
    start = time.process_time()
    bpy.ops.render.render(write_still=True, scene=scene.name)
    return time.process_time() - start


def render_pixel(scene, order):
    """CPU seconds of all that is not rendering: the middle of three."""
    scene.render.use_border = True
    scene.render.border_max_x, scene.render.border_max_y = 1 / scene.render.resolution_x, 1 / scene.render.resolution_y
    used = statistics.median(render(scene, {**order, "samples": 1}) for _ in range(3))
    scene.render.use_border = False
    return used


def main():
    loaded, rests = {}, {}
    for line in sys.stdin:
        order = json.loads(line)
        if order["scene"] not in loaded:
            loaded[order["scene"]] = load(order["scene"])
        scene = loaded[order["scene"]]
        key = order["scene"], *order["way"]
        if key not in rests:
            rests[key] = render_pixel(scene, order)
        print(json.dumps({"cpu": render(scene, order) - rests[key], "rest": rests[key]}), file=answers)


if __name__ == "__main__":
    main()
