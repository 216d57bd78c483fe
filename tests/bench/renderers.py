"""The renderers that are compared. Each renders a scene with n samples a pixel in some way of its own:

    render(scene, way, n, seed)   the picture, the CPU seconds of rendering alone, and how many samples it took

on one thread. ways(scene) lists those that are worth trying; an empty list: it cannot express the scene.
references(scene): two independent pictures that are almost converged.
"""

import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import tomllib

import drjit as dr
import mitsuba as mi
import numpy as np

from povray_scene import to_povray

mi.set_variant("scalar_rgb")  # for reading images only
mi.set_log_level(mi.LogLevel.Error)
dr.set_thread_count(2)  # with those of one core alone no picture is ever read

HERE = pathlib.Path(__file__).resolve().parent
REFERENCE = 256  # samples of a pixel
SLICES = 16  # of the shutter's time, for who has no moving shapes


def read_image(file):
    return np.array(mi.Bitmap(str(file)))[..., :3].astype(np.float64)


def read_scene(file):
    return tomllib.loads(file.read_text())


class Penumbra:
    name, compiles = "Penumbra", False

    def __init__(self, raytrace, folder):
        self.raytrace, self.out = raytrace, folder / "penumbra.exr"

    def ways(self, scene):
        return ["orthogonal", "sobol"]

    def references(self, scene):
        return [self.render(scene, "sobol", REFERENCE, 7 + k)[0] for k in range(2)]

    def render(self, scene, way, n, seed):
        n = 2 ** round(math.log2(n))
        command = [self.raytrace, scene, "-o", self.out, "--threads", "1"]
        command += ["--sampler", way, "--samples", str(n), "--seed", str(seed)]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        return read_image(self.out), float(re.search(r"time\s+([\d.]+) s CPU", done.stdout).group(1)), n


def ask(renderer, order):
    """A child's answer to an order, each of them a line."""
    print(json.dumps(order), file=renderer.child.stdin)
    line = renderer.child.stdout.readline()
    if not line:
        raise RuntimeError(f"{renderer.name} has ended; expected an answer")
    return json.loads(line)


class Mitsuba:
    """One of Mitsuba's variants, in a process of its own."""

    def __init__(self, variant, raytrace, folder, environment):
        self.name, self.variant, self.compiles = f"Mitsuba {variant}", variant, variant.startswith("llvm")
        self.raytrace, self.folder = raytrace, folder
        self.child = subprocess.Popen(
            [sys.executable, HERE / "mitsuba_child.py", variant],
            text=True,
            bufsize=1,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={**os.environ, **environment},
        )

    def ways(self, scene):
        """Samplers, and the integrator: that for direct light alone where it suffices, with its samples of the lamp."""
        if "exponent" in scene.read_text() and self.variant.startswith("scalar"):
            return []  # the lobe is Python, which would be called for each sample
        if "medium" in scene.read_text():
            return [f"{s} volpath" for s in ("multijitter", "stratified")]
        if re.search(r"bounces = 0", scene.read_text()):
            return [f"{s} direct {k}" for k in (1, 4) for s in ("multijitter", "orthogonal", "stratified", "ldsampler")]
        return [f"{s} path" for s in ("multijitter", "orthogonal", "stratified", "ldsampler")]

    def references(self, scene):
        return [self.render(scene, self.ways(scene)[0], REFERENCE, 7 + k)[0] for k in range(2)]

    def plain_way(self, scene):
        """Independent samples."""
        return " ".join(["independent", *self.ways(scene)[0].split()[1:]])

    def xmls(self, scene, way):
        """The scene as Mitsuba reads it; moving shapes at the middles of time slices."""
        sampler, integrator, *lamp = way.split()
        files, moves = [], "velocity" in scene.read_text()
        for k in range(SLICES if moves else 1):
            name = self.folder / f"{scene.stem}-{way.replace(' ', '-')}-{k}.xml"
            files.append(str(name))
            if name.exists():
                continue
            source = scene
            if moves:
                at = (k + 0.5) / SLICES
                source = self.folder / f"{scene.stem}-{k}.toml"
                source.write_text(re.sub(r"open = .*\nclose = .*", f"open = {at}\nclose = {at}", scene.read_text()))
            subprocess.run([self.raytrace, source, "--export-mitsuba", name], check=True)
            text = name.read_text().replace('<sampler type="independent">', f'<sampler type="{sampler}">')
            if integrator == "direct":
                text = re.sub(
                    r"<integrator.*?</integrator>",
                    '<integrator type="direct"><integer name="emitter_samples" '
                    f'value="{lamp[0]}"/><integer name="bsdf_samples" value="0"/></integrator>',
                    text,
                )
            name.write_text(text)
        return files

    def render_xmls(self, xmls, n, seed):
        out = self.folder / f"{self.variant}.npy"
        answer = ask(self, {"xmls": xmls, "samples": n, "seed": seed, "out": str(out)})
        return np.load(out), answer["cpu"], answer["samples"] * len(xmls)

    def render(self, scene, way, n, seed):
        xmls = self.xmls(scene, way)
        n = max(n / len(xmls), 1)
        if way.startswith("orthogonal"):
            n = min((p for p in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31)), key=lambda p: abs(math.log(p * p / n))) ** 2
        elif way.startswith("ldsampler"):
            n = 4 ** round(math.log(n, 4))
        elif not way.startswith("independent"):
            n = max(round(math.sqrt(n)), 1) ** 2
        return self.render_xmls(xmls, round(n), seed)

    def close(self):
        self.child.stdin.close()
        self.child.wait()


class Cycles:
    """Blender's renderer, in a process of its own."""

    name, compiles = "Cycles", False

    def __init__(self, python, folder):
        self.out = folder / "cycles.exr"
        self.child = subprocess.Popen(
            [python, HERE / "cycles_child.py"], text=True, bufsize=1, stdin=subprocess.PIPE, stdout=subprocess.PIPE
        )

    def ways(self, scene):
        """Its default pattern; where there are several lamps, with and without its light tree."""
        said = read_scene(scene)
        materials, used = said["materials"], [shape["material"] for shape in said["shape"]]
        if any("medium" in m or "transmittance" in m for m in materials.values()):
            return []  # its exact balls hold no medium
        lamps = sum("emission" in materials[name] for name in used) + ("environment" in said)
        return ["tabulated_sobol", "tabulated_sobol tree"][: min(lamps, 2)]

    def references(self, scene):
        return [self.render(scene, "tabulated_sobol", REFERENCE // 2, 7 + k)[0] for k in range(2)]

    def render(self, scene, way, n, seed):
        order = {"scene": str(scene), "way": way.split(), "samples": round(n), "seed": seed, "out": str(self.out)}
        cpu = ask(self, order)["cpu"]
        return read_image(self.out), cpu, round(n)

    def close(self):
        self.child.stdin.close()
        self.child.wait()


class PovRay:
    name, compiles = "POV-Ray", False

    def __init__(self, folder):
        self.folder = folder

    def ways(self, scene):
        """Lamp samples of a ray along each side; rays through the lens, or on a grid over the pixel."""
        if scene.stem == "soft_shadow":
            return ["2 lens", "3 grid", "4 grid", "6 grid"]
        return ["2 lens", "3 lens"] if scene.stem == "dof" else []

    def references(self, scene):
        return [self.render(scene, "2 lens", 2 * REFERENCE, 0)[0], self.render(scene, "3 lens", 2.25 * REFERENCE, 0)[0]]

    def render(self, scene, way, n, seed):
        """n: rays of a pixel times samples of the lamp. POV-Ray has no seed: other numbers are other noise."""
        lamp, rays = int(way[0]), max(n / int(way[0]) ** 2, 1)
        side = max(round(math.sqrt(rays)), 2)
        blur = max(round(rays), 4) if way.endswith("lens") else 0
        text = self.folder / "povray.pov"
        text.write_text(to_povray(read_scene(scene), lamp, blur))
        out = self.folder / "povray.exr"
        width, height = read_scene(scene)["camera"]["size"]
        command = ["povray", f"+I{text}", f"+O{out}", "+FE", "File_Gamma=1.0", f"+W{width}", f"+H{height}", "+WT1", "-D", "-V"]
        if not blur:
            command += ["+A0.0", "+AM1", f"+R{side}", "+J"]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        cpu = re.search(r"Trace Time.*?with ([\d.]+) CPU", done.stderr, re.DOTALL)
        return read_image(out), float(cpu.group(1)), (blur or side * side) * lamp * lamp


def newest_llvm():
    """The newest libLLVM that Mitsuba can use; none: it aborts with those up to 16."""
    version = {}
    for file in pathlib.Path("/usr/lib").glob("*/libLLVM*.so*"):
        if number := re.search(r"LLVM[.-]?(?:so\.)?(\d+)", file.name):
            version[file] = int(number.group(1))
    best = max(version, key=version.get, default=None)
    return best if best and version[best] > 16 else None


def find_cycles():
    """The Python of build/cycles, made where it is missing; its wheel is for Python 3.11 alone. None: it cannot be had."""
    folder = HERE.parent.parent / "build" / "cycles"
    python = folder / "bin" / "python3"
    if not python.exists():
        candidates = [shutil.which("python3.11"), "/usr/bin/python3", shutil.which("python3")]
        version = "import sys; sys.exit(sys.version_info[:2] != (3, 11))"
        found = next((p for p in candidates if p and not subprocess.run([p, "-c", version]).returncode), None)
        if not found:
            return None
        print("Installing Cycles into build/cycles", flush=True)
        subprocess.run([found, "-m", "venv", folder], stdout=subprocess.DEVNULL)
        subprocess.run([python, "-m", "pip", "install", "-q", "bpy==4.2.*", "numpy"], stdout=subprocess.DEVNULL)
    works = subprocess.run([python, "-c", "import bpy, numpy"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return None if works.returncode else python


def peers(raytrace, folder):
    """Those that this machine has, and a line for each that it has not."""
    found, missing = [], []
    llvm = newest_llvm()
    if llvm:
        found.append(Mitsuba("llvm_ad_rgb", raytrace, folder, {"DRJIT_LIBLLVM_PATH": str(llvm)}))
    else:
        missing.append("Mitsuba llvm_ad_rgb: no libLLVM newer than 16; apt-get install libllvm19")
    found.append(Mitsuba("scalar_rgb", raytrace, folder, {}))
    if python := find_cycles():
        found.append(Cycles(python, folder))
    else:
        missing.append("Cycles: no Python 3.11 with bpy 4.2 and the X11 libraries that it loads")
    if shutil.which("povray"):
        found.append(PovRay(folder))
    else:
        missing.append("POV-Ray: apt-get install povray")
    return found, missing


def whole_process(command, environment=None):
    """Wall and CPU seconds of a command from its start to its end."""
    start = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, env={**os.environ, **(environment or {})})
    _, status, used = os.wait4(child.pid, 0)
    if status:
        raise RuntimeError(f"{command[0]}: status {status}; expected 0")
    return time.monotonic() - start, used.ru_utime + used.ru_stime
