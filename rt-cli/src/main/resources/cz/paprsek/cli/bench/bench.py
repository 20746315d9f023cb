"""Mitsuba 3, for bench --against mitsuba: renders scenes that MitsubaScene has written. Every line of input is a folder with a scene to
load, or empty, to render that once; the answer is a line, of an empty one the seconds of all processors that it took.

Paths are followed by scalar_rgb, as deep as ours and without roulette. Where there are none, llvm_ad_rgb, which has Embree, finds what rays from the
eye hit, and whether anything stands between that and the light; the rays are made before, which takes no part of the time."""
import json
import os
import sys
import time

import mitsuba as mi

threads = int(sys.argv[1])


def load(folder):
    with open(os.path.join(folder, 'scene.json')) as file:
        words = json.load(file)
    mi.set_variant('scalar_rgb' if words['paths'] else 'llvm_ad_rgb')
    import drjit
    drjit.set_thread_count(threads)
    place = mi.ScalarTransform4f

    def placed(body):
        return place([body['matrix'][:4], body['matrix'][4:8], body['matrix'][8:], [0, 0, 0, 1]])

    scene = {
        'type': 'scene',
        'integrator': {'type': 'path', 'max_depth': words['depth'] + 1, 'rr_depth': 1000},
        'sensor': {
            'type': 'perspective', 'fov': words['fovy'], 'fov_axis': 'y', 'to_world': place().look_at(origin=words['eye'], target=words['target'], up=words['up']),
            'film': {'type': 'hdrfilm', 'width': words['width'], 'height': words['height'], 'rfilter': {'type': 'box'}},
            'sampler': {'type': 'independent', 'sample_count': words['samples']},
        },
    }
    light = words['light']
    if 'radiance' in light:
        scene['light'] = {'type': 'rectangle', 'to_world': placed(light), 'emitter': {'type': 'area', 'radiance': {'type': 'rgb', 'value': light['radiance']}}}
    for i, body in enumerate(words['bodies']):
        shape = {'type': body['type'], 'to_world': placed(body),
                 'bsdf': {'type': 'twosided', 'matt': {'type': 'diffuse', 'reflectance': {'type': 'rgb', 'value': body['albedo']}}}}
        if body['type'] == 'ply':
            shape.update(filename=os.path.join(folder, 'mesh.ply'), face_normals=True)
        scene['body%d' % i] = shape
    scene = mi.load_dict(scene)
    return PathsOf(scene, words) if words['paths'] else RaysOf(scene, words, drjit)


class PathsOf:
    def __init__(self, scene, words):
        self.scene, self.samples, self.seed = scene, words['samples'], 0

    def seconds(self):
        self.seed += 1
        begin = time.process_time()
        image = mi.render(self.scene, spp=self.samples, seed=self.seed)
        end = time.process_time()
        values = image.array
        return '%.6f %.6f' % (end - begin, sum(values) / len(values))


class RaysOf:
    def __init__(self, scene, words, dr):
        self.scene, self.dr = scene, dr
        width, height = words['width'], words['height']
        index = dr.arange(mi.UInt32, width * height)
        place = mi.Point2f((mi.Float(index % width) + 0.5) / width, (mi.Float(index // width) + 0.5) / height)
        self.rays, _ = scene.sensors()[0].sample_ray(0, 0.5, place, mi.Point2f(0.5))
        hits = scene.ray_intersect(self.rays)
        self.hit = hits.is_valid()
        self.shadows = hits.spawn_ray_to(mi.Point3f(words['light']['position']))
        dr.eval(self.rays, self.hit, self.shadows)
        dr.sync_thread()

    def seconds(self):
        begin = time.process_time()
        found = self.scene.ray_intersect_preliminary(self.rays)
        self.dr.eval(found.t, found.prim_index)
        occluded = self.scene.ray_test(self.shadows, self.hit)
        self.dr.eval(occluded)
        self.dr.sync_thread()
        end = time.process_time()
        return '%.6f %d' % (end - begin, self.dr.count(found.is_valid())[0])


loaded = None
print(mi.__version__, flush=True)
for line in sys.stdin:
    if line.strip():
        loaded = load(line.rstrip('\n'))
        print('loaded', flush=True)
    else:
        print(loaded.seconds(), flush=True)
