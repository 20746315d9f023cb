package cz.paprsek.shape;

import cz.paprsek.math.Affine;

/** Scratch of one worker: a line o + t·d in the space of a shape. Directions keep the length the map gives them, so t keeps its meaning. */
final class Line {
    double ox;
    double oy;
    double oz;
    double dx;
    double dy;
    double dz;

    /** Takes the ray into the space that the map leads to. */
    void set(Ray ray, Affine map) {
        ox = map.pointX(ray.ox, ray.oy, ray.oz);
        oy = map.pointY(ray.ox, ray.oy, ray.oz);
        oz = map.pointZ(ray.ox, ray.oy, ray.oz);
        dx = map.directionX(ray.dx, ray.dy, ray.dz);
        dy = map.directionY(ray.dx, ray.dy, ray.dz);
        dz = map.directionZ(ray.dx, ray.dy, ray.dz);
    }
}
