"""Mitsuba 3.9.1 (pip install mitsuba numpy), scalar_rgb: python3 mitsuba_scene.py VERTICAL_ANGLE OUT.ppm"""
import sys
import numpy as np
import mitsuba as mi

mi.set_variant("scalar_rgb")
T = mi.ScalarTransform4f
D = 7.0  # at this distance the lamp brings 1, as reference-distance says


def diffuse(r, g, b):
    return {"type": "twosided", "b": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [r, g, b]}}}


scene = mi.load_dict({
    "type": "scene", "integrator": {"type": "direct", "emitter_samples": 1, "bsdf_samples": 0},
    "sensor": {"type": "perspective", "fov_axis": "y", "fov": float(sys.argv[1]), "to_world": T().look_at(origin=[0, 1.6, 6], target=[0, 0.7, 0], up=[0, 1, 0]),
               "film": {"type": "hdrfilm", "width": 96, "height": 64, "rfilter": {"type": "box"}, "pixel_format": "rgb", "component_format": "float32"},
               "sampler": {"type": "independent", "sample_count": 256}},
    "lamp": {"type": "point", "position": [-3, 5, 4], "intensity": {"type": "rgb", "value": [np.pi * D * D] * 3}},
    "floor": {"type": "rectangle", "to_world": T().translate([0, 0, -20]).rotate([1, 0, 0], -90).scale(40), "bsdf": diffuse(0.55 * 0.9, 0.52 * 0.9, 0.45 * 0.9)},
    "a": {"type": "sphere", "center": [-0.9, 0.8, 0], "radius": 0.8, "bsdf": diffuse(0.75 * 0.8, 0.12 * 0.8, 0.08 * 0.8)},
    "b": {"type": "sphere", "center": [1, 0.6, 0.6], "radius": 0.6, "bsdf": diffuse(0.06, 0.15, 0.36)}})
light = np.clip(np.array(mi.render(scene)), 0, 1)
shown = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
with open(sys.argv[2], "wb") as file:
    file.write(b"P6\n96 64\n255\n" + np.rint(255 * shown).astype(np.uint8).tobytes())
