"""Renders with Mitsuba as it is told, line by line: mitsuba_child.py VARIANT

Reads {"xmls": [...], "samples": n, "seed": s, "out": "NAME.npy"}, renders each scene with n samples a pixel on one
thread, writes the mean of the pictures, and answers {"cpu": seconds of rendering alone, "samples": as the sampler
rounds them}. One scene is loaded at a time: the kernels of the LLVM variants dispatch over the shapes and materials of all
scenes that there are, and would pay for them.
"""

import gc
import json
import os
import pathlib
import sys
import time

import mitsuba as mi
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "mitsuba"))
answers = os.fdopen(os.dup(1), "w", buffering=1)
os.dup2(2, 1)  # nothing else gets between the answers
mi.set_variant(sys.argv[1])
mi.set_log_level(mi.LogLevel.Error)

import drjit as dr  # noqa: E402
import lobe  # noqa: E402

dr.set_thread_count(1)
lobe.register()
loaded, scene = None, None


def load(xml):
    """The scene, which is kept until another one is asked for."""
    global loaded, scene
    if xml != loaded:
        scene = None
        gc.collect()
        loaded, scene = xml, mi.load_file(xml)
    return scene


for line in sys.stdin:
    order = json.loads(line)
    count, cpu, images = len(order["xmls"]), 0, []
    for k, xml in enumerate(order["xmls"]):
        chosen = load(xml)
        start = time.process_time()
        image = mi.render(chosen, spp=order["samples"], seed=order["seed"] * count + k)
        dr.eval(image)
        dr.sync_thread()
        cpu += time.process_time() - start
        images.append(np.array(image, dtype=np.float64)[..., :3])
    np.save(order["out"], np.mean(images, axis=0))
    print(json.dumps({"cpu": cpu, "samples": chosen.sensors()[0].sampler().sample_count()}), file=answers)
    del chosen
