"""A ray tracer as courses have it: spheres, a floor, one lamp, Phong, shadows, a mirror. Made for three.xml by the formulas alone; it knows nothing of this project.

    python3 course.py right|full-fovy|no-shadow|corner OUT.ppm     (course-upside-down.png has the rows of the right one the other way round)
"""
import sys
from math import tan, radians, sqrt

WIDTH, HEIGHT, FOVY, DEPTH = 96, 64, 45.0, 4
EYE, TARGET = (0.0, 1.6, 6.0), (0.0, 0.7, 0.0)
LAMP = (-3.0, 5.0, 4.0)
BACK, AMBIENT = (0.05, 0.07, 0.12), (0.06, 0.06, 0.06)
#          centre               radius  colour            kD    kS    n   kR
SPHERES = [((-0.9, 0.8, 0.0), 0.8, (0.75, 0.12, 0.08), 0.8, 0.3, 30, 0.0),
           ((1.0, 0.6, 0.6), 0.6, (0.1, 0.25, 0.6), 0.6, 0.5, 60, 0.25)]
FLOOR = (0.55, 0.52, 0.45)

mode, out = sys.argv[1:]
dot = lambda a, b: sum(x * y for x, y in zip(a, b))
add = lambda a, b: tuple(x + y for x, y in zip(a, b))
sub = lambda a, b: tuple(x - y for x, y in zip(a, b))
mul = lambda a, k: tuple(x * k for x in a)
unit = lambda a: mul(a, 1 / sqrt(dot(a, a)))
cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def nearest(o, d):
    best = None
    for s in SPHERES:
        oc = sub(o, s[0])
        b = dot(oc, d)
        disc = b * b - dot(oc, oc) + s[1] ** 2
        if disc > 0:
            for t in (-b - sqrt(disc), -b + sqrt(disc)):
                if t > 1e-6 and (best is None or t < best[0]):
                    best = (t, s, None)
    if abs(d[1]) > 1e-12:
        t = -o[1] / d[1]
        if t > 1e-6 and (best is None or t < best[0]):
            best = (t, None, (0.0, 1.0, 0.0))
    return best


def trace(o, d, level):
    hit = nearest(o, d)
    if hit is None:
        return BACK
    t, s, n = hit
    p = add(o, mul(d, t))
    colour, kd, ks, shine, kr = s[2:] if s else (FLOOR, 0.9, 0.0, 1, 0.0)
    n = n or mul(sub(p, s[0]), 1 / s[1])
    if dot(n, d) > 0:
        n = mul(n, -1)
    light = tuple(a * c for a, c in zip(AMBIENT, colour))
    way = sub(LAMP, p)
    far = sqrt(dot(way, way))
    l = mul(way, 1 / far)
    r = sub(d, mul(n, 2 * dot(d, n)))
    blocked = nearest(add(p, mul(n, 1e-6)), l) if mode != "no-shadow" else None
    if dot(n, l) > 0 and not (blocked and blocked[0] < far):
        light = add(light, add(mul(colour, kd * dot(n, l)), (ks * max(0.0, dot(r, l)) ** shine,) * 3))
    if kr > 0 and level < DEPTH:
        light = add(light, mul(trace(add(p, mul(n, 1e-6)), r, level + 1), kr))
    return light


def srgb(v):
    v = min(1.0, max(0.0, v))
    return round(255 * (12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055))


h = 2 * tan(radians(FOVY if mode == "full-fovy" else FOVY / 2))
forward = unit(sub(TARGET, EYE))
right = unit(cross(forward, (0.0, 1.0, 0.0)))
up = cross(right, forward)
half = 0.0 if mode == "corner" else 0.5
with open(out, "wb") as f:
    f.write(f"P6\n{WIDTH} {HEIGHT}\n255\n".encode())
    for row in range(HEIGHT):
        for column in range(WIDTH):
            x = (column + half - WIDTH / 2) * h / HEIGHT
            y = (HEIGHT / 2 - row - half) * h / HEIGHT
            f.write(bytes(srgb(v) for v in trace(EYE, unit(add(forward, add(mul(right, x), mul(up, y)))), 1)))
