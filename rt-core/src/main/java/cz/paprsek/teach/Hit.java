package cz.paprsek.teach;

/**
 * What a ray meets first.
 *
 * @param media around the ray
 * @param size what the rounding errors of the point are relative to
 * @param normal of length 1, turned to the viewer
 * @param leaving whether the ray comes from inside
 */
record Hit(Ray ray, Media media, Met met, Vec point, double size, Vec normal, boolean leaving) {
    Paint paint() {
        return met.crossing().of().paint;
    }

    /** The media beyond the surface. A flat figure has no inside. */
    Media beyond(double index) {
        Media here = met.t() > ray.contact() || !ray.beyond() ? media.elsewhere() : media;
        return !met.body().isSolid ? here : leaving ? here.leaving(met.body()) : here.entering(met.body(), index);
    }

    /** A ray on the side from which the surface was seen: into the inside of the primitive if that is where it was seen from. */
    Ray back(Vec direction) {
        boolean isAlone = met.t() > ray.contact();
        return new Ray(point, direction, size, isAlone ? Ray.TOUCH * size : -Ray.TOUCH * size, met, leaving != met.crossing().flipped(), false);
    }

    /** A ray beyond the surface. */
    Ray on(Vec direction) {
        return new Ray(point, direction, size, -Ray.TOUCH * size, met, leaving == met.crossing().flipped(), true);
    }
}
