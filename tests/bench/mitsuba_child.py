"""Renders with Mitsuba as it is told, line by line: mitsuba_child.py VARIANT

Reads {"xmls": [...], "samples": n, "seed": s, "out": "NAME.npy"}, renders each scene with n samples a pixel on one
thread, writes the mean of the pictures, and answers {"cpu": seconds of rendering alone, "samples": as the sampler
rounds them}. Scenes are loaded once.
"""

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
scenes = {}

for line in sys.stdin:
    order = json.loads(line)
    for xml in order["xmls"]:
        if xml not in scenes:
            scenes[xml] = mi.load_file(xml)
    chosen = [scenes[xml] for xml in order["xmls"]]
    start = time.process_time()
    images = []
    for k, scene in enumerate(chosen):
        image = mi.render(scene, spp=order["samples"], seed=order["seed"] * len(chosen) + k)
        dr.eval(image)
        images.append(image)
    dr.sync_thread()
    cpu = time.process_time() - start
    np.save(order["out"], np.mean([np.array(image, dtype=np.float64)[..., :3] for image in images], axis=0))
    print(json.dumps({"cpu": cpu, "samples": chosen[0].sensors()[0].sampler().sample_count()}), file=answers)
