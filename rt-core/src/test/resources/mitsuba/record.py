"""Records what MitsubaTest compares with: python3 record.py SCENE.xml OUT.txt RENDERS PATHS [FIRST SEED]. Needs pip's mitsuba (3.9.1) and numpy.

Builds the scene of our file (the few elements that the four scenes have) in Mitsuba, renders it RENDERS times with PATHS paths a pixel, each time with a seed of its own, and writes the mean of each block
of 8 x 8 pixels and the variance of that mean. OUT.txt is written anew after every render, so it may be stopped when the line on standard error, the deviation of the whole in per cent, is small enough."""
import os
import sys
import xml.etree.ElementTree as XML

import mitsuba as mi
import numpy as np

mi.set_variant('scalar_rgb')
T = mi.ScalarTransform4f
root = XML.parse(sys.argv[1]).getroot()
name, renders, paths = os.path.basename(sys.argv[1])[:-4], int(sys.argv[3]), int(sys.argv[4])
seed = int(sys.argv[5]) if len(sys.argv) > 5 else 0
SIDE = 64


def numbers(element, key, default):
    return [float(word) for word in element.get(key, default).split()]


def number(element, key, default):
    return float(element.get(key, default))


def color(element, key, times=1.0):
    light = [v / 255 for v in numbers(element, key, '255 255 255')]
    return {'type': 'rgb', 'value': [times * (v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4) for v in light]}


def grey(value):
    return {'type': 'rgb', 'value': [value] * 3}


def placed(element):
    x, y, z = numbers(element, 'rotation', '0 0 0')
    return T().translate(numbers(element, 'position', '0 0 0')) @ T().rotate([0, 0, 1], z) @ T().rotate([0, 1, 0], y) @ T().rotate([1, 0, 0], x)


def between(low, high):
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    half = [(b - a) / 2 for a, b in zip(low, high)]
    return T().translate((middle + [0])[:3]) @ T().scale((half + [1])[:3])


def surface(material):
    alpha = number(material, 'roughness', 0) ** 2
    if number(material, 'transparency', 0):
        return {'type': 'roughdielectric', 'distribution': 'ggx', 'alpha': alpha, 'int_ior': number(material, 'refractive-index', 1), 'ext_ior': 1.0}
    if number(material, 'reflection', 0):
        inner = {'type': 'roughconductor', 'material': 'none', 'distribution': 'ggx', 'alpha': alpha, 'specular_reflectance': grey(number(material, 'reflection', 0))}
    else:
        inner = {'type': 'diffuse', 'reflectance': color(material, 'color', number(material, 'diffusion', 1))}
    return {'type': 'twosided', 'inner': inner}


settings, camera, scene = {}, {}, {'type': 'scene'}
materials = {m.get('name'): m for m in root.findall('{*}material')}
for i, element in enumerate(root):
    tag = element.tag.split('}')[1]
    black = {'type': 'twosided', 'inner': {'type': 'diffuse', 'reflectance': grey(0)}}
    thing = {}
    if tag == 'render':
        scene['integrator'] = {'type': 'path', 'max_depth': int(element.get('max-depth')) + 1, 'rr_depth': 1000}
    elif tag == 'camera':
        scene['sensor'] = {'type': 'perspective', 'fov': number(element, 'fovy', 45), 'fov_axis': 'y',
            'to_world': T().look_at(origin=numbers(element, 'position', ''), target=numbers(element, 'target', ''), up=[0, 1, 0]),
            'film': {'type': 'hdrfilm', 'width': SIDE, 'height': SIDE, 'rfilter': {'type': 'box'}, 'pixel_format': 'rgb', 'component_format': 'float32'},
            'sampler': {'type': 'independent', 'sample_count': paths}}
    elif tag == 'background':
        thing = {'type': 'constant', 'radiance': color(element, 'color')}
    elif tag.endswith('-light'):
        intensity = number(element, 'intensity', 1) * number(element, 'reference-distance', 1) ** 2
        if tag == 'point-light':
            thing = {'type': 'point', 'position': numbers(element, 'position', ''), 'intensity': color(element, 'color', np.pi * intensity)}
        elif tag == 'sphere-light':
            radius = number(element, 'radius', 0)
            thing = {'type': 'sphere', 'center': numbers(element, 'position', ''), 'radius': radius, 'bsdf': black, 'emitter': {'type': 'area', 'radiance': color(element, 'color', intensity / radius ** 2)}}
        else:
            width, height = numbers(element, 'size', '')
            thing = {'type': 'rectangle', 'to_world': placed(element) @ T().scale([width / 2, height / 2, 1]), 'bsdf': black,
                'emitter': {'type': 'area', 'radiance': color(element, 'color', np.pi * intensity / (width * height))}}
    elif tag in ('rectangle', 'block', 'sphere'):
        material = element.find('{*}material')
        material = materials[element.get('material')] if material is None else material
        if tag == 'sphere':
            thing = {'type': 'sphere', 'center': numbers(element, 'position', '0 0 0'), 'radius': number(element, 'radius', 1)}
        else:
            thing = {'type': 'rectangle' if tag == 'rectangle' else 'cube', 'to_world': placed(element) @ between(numbers(element, 'min', ''), numbers(element, 'max', ''))}
        thing['bsdf'] = surface(material)
        if material.get('emission'):
            thing['emitter'] = {'type': 'area', 'radiance': color(material, 'emission', number(material, 'emission-strength', 1))}
    elif tag not in ('description', 'material'):
        sys.exit('element %s is not known here' % tag)
    if thing:
        scene['thing%d' % i] = thing

built = mi.load_dict(scene)
blocks = []
for n in range(renders):
    picture = np.array(mi.render(built, seed=seed + n, spp=paths), dtype=float)
    blocks.append(picture.reshape(SIDE // 8, 8, SIDE // 8, 8, 3).mean(axis=(1, 3)).reshape(-1, 3))
    if n:
        all = np.array(blocks)
        mean, variance = all.mean(axis=0), all.var(axis=0, ddof=1) / (n + 1)
        with open(sys.argv[2] + '.new', 'w') as file:
            file.write('# %s: Mitsuba %s scalar_rgb, 64 x 64 pixels, %d renders of %d paths; means of 8 x 8 blocks from the top left: red green blue, and their variances\n' % (name, mi.__version__, n + 1, paths))
            for row in np.concatenate([mean, variance], axis=1):
                file.write(' '.join('%.6g' % value for value in row) + '\n')
        os.replace(sys.argv[2] + '.new', sys.argv[2])
        print(n + 1, 100 * np.sqrt(variance.sum(axis=0)) / mean.sum(axis=0), file=sys.stderr, flush=True)
