"""The denoiser beside Intel's Open Image Denoise: python3 oidn.py PAPRSEK LIBRARY SAMPLES SCENE.xml:WxH ...

PAPRSEK is our command, LIBRARY a libOpenImageDenoise.so of version 2 (such as that of pip's pyoidn; LD_LIBRARY_PATH has to name its folder), SAMPLES how many the truth is made of.
Prints for each scene how far the picture of 64 paths is from the truth, ours and theirs: root mean squares, of light and of steps of 255 as shown. Needs pip's mitsuba and numpy, to read OpenEXR."""
import ctypes as C
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as XML

import mitsuba as mi
import numpy as np

mi.set_variant('scalar_rgb')
command, library, samples = sys.argv[1].split(), C.CDLL(sys.argv[2]), sys.argv[3]
for name in ('oidnNewDevice', 'oidnNewFilter'):
    getattr(library, name).restype = C.c_void_p
pointer = C.c_void_p
device = pointer(library.oidnNewDevice(1))
library.oidnCommitDevice(device)


def planes(file, *names):
    bitmap = mi.Bitmap(file)
    at = [field.name for field in bitmap.struct_()]
    values = np.array(bitmap, dtype=np.float32)
    return np.ascontiguousarray(np.stack([values[..., at.index(name)] for name in names], axis=-1))


def theirs(color, albedo, normal):
    out = np.zeros_like(color)
    denoise = pointer(library.oidnNewFilter(device, b'RT'))
    for name, image in ((b'color', color), (b'albedo', albedo), (b'normal', normal), (b'output', out)):
        size = [C.c_size_t(n) for n in (image.shape[1], image.shape[0], 0, 0, 0)]
        library.oidnSetSharedFilterImage(denoise, name, pointer(image.ctypes.data), 3, *size)
    library.oidnSetFilterBool(denoise, b'hdr', C.c_bool(True))
    library.oidnCommitFilter(denoise)
    library.oidnExecuteFilter(denoise)
    return out


def shown(light, settings):
    v = light * 2 ** float(settings.get('exposure', 0))
    if settings.get('tone') == 'filmic':
        curve = lambda x: (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3
        v = curve(2 * np.maximum(v, 0)) / curve(11.2)
    v = np.clip(v, 0, 1)
    return 255 * np.where(v <= 0.0031308, v * 12.92, 1.055 * v ** (1 / 2.4) - 0.055)


print('scene | light: noisy ours theirs ratio | shown: noisy ours theirs ratio')
for scene, size in (word.rsplit(':', 1) for word in sys.argv[4:]):
    settings = XML.parse(scene).getroot().find('{urn:paprsek:scene:1}render').attrib
    with tempfile.TemporaryDirectory() as folder:
        def render(name, *options):
            file = os.path.join(folder, name)
            subprocess.run([*command, 'render', scene, '-o', file, '--size', size, '--integrator', 'path', '--exposure', '0', '--tone', 'none', '--bits', '32', '-q', *options], check=True)
            return file
        noisy = render('noisy.exr', '--samples', '64', '--aov', 'albedo,normal')
        color = planes(noisy, 'R', 'G', 'B')
        ours = planes(render('ours.exr', '--samples', '64', '--denoise'), 'R', 'G', 'B')
        truth = planes(render('truth.exr', '--samples', samples), 'R', 'G', 'B')
        pictures = color, ours, theirs(color, planes(noisy, 'albedo.R', 'albedo.G', 'albedo.B'), planes(noisy, 'normal.X', 'normal.Y', 'normal.Z'))
    row = os.path.basename(scene)
    for look in (lambda p: p), (lambda p: shown(p, settings)):
        off = [float(np.sqrt(np.mean((look(p).astype(float) - look(truth)) ** 2))) for p in pictures]
        row += ' | %.5g %.5g %.5g %.2f' % (*off, off[1] / off[2])
    print(row, flush=True)
