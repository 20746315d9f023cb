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
            case PLANAR -> new Planar(toPattern);
            case SPHERICAL -> new Spherical(toPattern);
            case CYLINDER -> new Around(toPattern);
            case BOX -> new Box(toPattern);
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

    private abstract static class InSpace extends Mapping {
        private final Affine toPattern;

        InSpace(Affine toPattern) {
            this.toPattern = toPattern;
        }

        @Override
        final void map(Hit at, Part part, int face) {
            map(at, toPattern.pointX(at.px, at.py, at.pz), toPattern.pointY(at.px, at.py, at.pz), toPattern.pointZ(at.px, at.py, at.pz), toPattern);
        }

        /** Sets u and v by the point in the picture's own space. */
        abstract void map(Hit at, double x, double y, double z, Affine space);
    }

    /** Onto the plane z = 0. */
    private static final class Planar extends InSpace {
        Planar(Affine toPattern) {
            super(toPattern);
        }

        @Override
        void map(Hit at, double x, double y, double z, Affine space) {
            at.u = x;
            at.v = y;
        }
    }

    /** As a globe about the origin, the middle of the picture towards +z. */
    private static final class Spherical extends InSpace {
        Spherical(Affine toPattern) {
            super(toPattern);
        }

        @Override
        void map(Hit at, double x, double y, double z, Affine space) {
            at.mapGlobe(x, y, z);
        }
    }

    /** As a label around the y axis, as high as 1. */
    private static final class Around extends InSpace {
        Around(Affine toPattern) {
            super(toPattern);
        }

        @Override
        void map(Hit at, double x, double y, double z, Affine space) {
            at.mapAround(x, z, y);
        }
    }

    /** From the side of a cube that the surface faces most, upright and not mirrored; from above as seen by somebody who stands at +z. */
    private static final class Box extends InSpace {
        Box(Affine toPattern) {
            super(toPattern);
        }

        @Override
        void map(Hit at, double x, double y, double z, Affine space) {
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
}
