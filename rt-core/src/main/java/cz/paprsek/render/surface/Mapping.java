package cz.paprsek.render.surface;

import cz.paprsek.material.Pattern;
import cz.paprsek.math.Affine;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.placed.Part;

/** How a picture lies on a surface: finds u and v of a point on it or beside it. */
abstract class Mapping {
    /**
     * Sets u and v.
     *
     * @param at takes them; its point is set, and its normals unless the mapping is by the shape
     * @param part the part that the point is on
     * @param face of the part, not complemented
     */
    abstract void map(Hit at, Part part, int face);

    /** @param toPattern from the world to the picture's own space */
    static Mapping of(Pattern.Mapping mapping, Affine toPattern, Affine within) {
        return switch (mapping) {
            case UV -> new ByShape(within);
            case PLANAR -> new InSpace(toPattern, (at, x, y, z, space) -> flat(at, x, y));
            case SPHERICAL -> new InSpace(toPattern, (at, x, y, z, space) -> at.mapGlobe(x, y, z));
            case CYLINDER -> new InSpace(toPattern, (at, x, y, z, space) -> at.mapAround(x, z, y));
            case BOX -> new InSpace(toPattern, Mapping::box);
        };
    }

    /** As the shape says, moved, turned and scaled within the plane of u and v. */
    private static final class ByShape extends Mapping {
        private final Affine toPicture;

        ByShape(Affine toPicture) {
            this.toPicture = toPicture;
        }

        @Override
        void map(Hit at, Part part, int face) {
            part.map(face, at);
            double u = at.u;
            double v = at.v;
            at.u = toPicture.pointX(u, v, 0);
            at.v = toPicture.pointY(u, v, 0);
        }
    }

    /** By the point in the picture's own space. */
    private interface Onto {
        /** Sets u and v. */
        void map(Hit at, double x, double y, double z, Affine space);
    }

    private static final class InSpace extends Mapping {
        private final Affine toPattern;
        private final Onto onto;

        InSpace(Affine toPattern, Onto onto) {
            this.toPattern = toPattern;
            this.onto = onto;
        }

        @Override
        void map(Hit at, Part part, int face) {
            onto.map(at, toPattern.pointX(at.px, at.py, at.pz), toPattern.pointY(at.px, at.py, at.pz), toPattern.pointZ(at.px, at.py, at.pz), toPattern);
        }
    }

    /** Onto the plane z = 0. */
    private static void flat(Hit at, double x, double y) {
        at.u = x;
        at.v = y;
    }

    /** From the side of a cube that the surface faces most, upright and not mirrored; from above as seen by somebody who stands at +z. */
    private static void box(Hit at, double x, double y, double z, Affine space) {
        // The normal in the picture's space: its dot products with that space's axes, as they are in the world, would do as well.
        double nx = space.directionX(at.nx, at.ny, at.nz);
        double ny = space.directionY(at.nx, at.ny, at.nz);
        double nz = space.directionZ(at.nx, at.ny, at.nz);
        double sizeX = Math.abs(nx);
        double sizeY = Math.abs(ny);
        double sizeZ = Math.abs(nz);
        if (sizeY >= sizeX && sizeY >= sizeZ) {
            at.u = x;
            at.v = ny > 0 ? -z : z;
        } else if (sizeX >= sizeZ) {
            at.u = nx > 0 ? -z : z;
            at.v = y;
        } else {
            at.u = nz > 0 ? x : -x;
            at.v = y;
        }
    }
}
