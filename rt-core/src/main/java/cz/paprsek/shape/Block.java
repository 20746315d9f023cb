package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.outline.Drawn;
import cz.paprsek.shape.placed.Convex;
import cz.paprsek.shape.placed.LocalConvex;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Rounded;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.text.Numbers;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A box with faces perpendicular to the axes, from its minimum to its maximum corner.
 *
 * @param rounding the radius of its edges and corners, within the box; 0 if they are sharp
 */
@Element("A box from its minimum to its maximum corner.")
public record Block(
        @Attribute(value = Kind.VECTOR, means = "Below max along every axis", example = "-0.5 -0.5 -0.5") Vec3 min,
        @Attribute(value = Kind.VECTOR, means = "Above min along every axis", example = "0.5 0.5 0.5") Vec3 max,
        @Attribute(value = Kind.NOT_NEGATIVE, means = "The radius of its edges and corners; at most half its smallest side", otherwise = "0") double rounding) implements Solid {
    /** A side is a difference of two numbers, and half of it is what somebody would write. */
    private static final double SLACK = 1e-9;
    private static final List<Face> FACES = List.of(Face.MINUS_X, Face.PLUS_X, Face.MINUS_Y, Face.PLUS_Y, Face.MINUS_Z, Face.PLUS_Z);

    public Block {
        Require.place("block min", min);
        Require.place("block max", max);
        Require.that(min.x() < max.x() && min.y() < max.y() && min.z() < max.z(),
                "block min must be below max along every axis, but min is " + Numbers.text(min) + " and max is "
                        + Numbers.text(max));
        Require.size("block width", max.x() - min.x());
        Require.size("block height", max.y() - min.y());
        Require.size("block depth", max.z() - min.z());
        Require.sizeOrZero("block rounding", rounding);
        double smallest = Math.min(max.x() - min.x(), Math.min(max.y() - min.y(), max.z() - min.z()));
        Require.that(rounding == 0 || rounding * 2 <= smallest * (1 + SLACK),
                "block rounding must be at most half its smallest side of " + Numbers.text(smallest) + ", but is " + Numbers.text(rounding));
    }

    /** One with sharp edges. */
    public Block(Vec3 min, Vec3 max) {
        this(min, max, 0);
    }

    @Override
    public Face face(int number) {
        return FACES.get(number);
    }

    @Override
    public Bounds bounds() {
        return Bounds.of(min, max);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        return rounding == 0 ? Drawn.box(min, max) : Drawn.roundedBox(middle(), inner(), rounding, along, steps);
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return rounding > 0 ? parts.add(part -> new Soft(part, toWorld, this)) : toWorld.keepsAxes()
                ? parts.add(part -> new Upright(part, Bounds.of(toWorld.point(min), toWorld.point(max)),
                        toWorld.turns() ? new Turned(part, toWorld, min, max) : null))
                : parts.add(part -> new Turned(part, toWorld, min, max));
    }

    private Vec3 middle() {
        return min.plus(max).times(0.5);
    }

    /** Half the box that is all around within the rounding. */
    private Vec3 inner() {
        return new Vec3(Math.max(0, (max.x() - min.x()) / 2 - rounding), Math.max(0, (max.y() - min.y()) / 2 - rounding), Math.max(0, (max.z() - min.z()) / 2 - rounding));
    }

    /**
     * Each face is a picture of its own, as seen from outside with y up; top and bottom as seen by somebody who stands at +z.
     *
     * @param x along the block, 0–1 from its minimum to its maximum
     */
    private static void map(int face, double x, double y, double z, Hit hit) {
        switch (face) {
            case 0 -> hit.map(z, y, 0, 0, 1);
            case 1 -> hit.map(1 - z, y, 0, 0, -1);
            case 2 -> hit.map(x, z, 1, 0, 0);
            case 3 -> hit.map(x, 1 - z, 1, 0, 0);
            case 4 -> hit.map(1 - x, y, -1, 0, 0);
            default -> hit.map(x, y, 1, 0, 0);
        }
    }

    /** A block whose faces are still perpendicular to the axes. Face 2a is at the minimum of axis a, 2a + 1 at its maximum. */
    private static final class Upright extends Convex {
        private final double minX;
        private final double minY;
        private final double minZ;
        private final double maxX;
        private final double maxY;
        private final double maxZ;
        /** What knows its own axes, if these are not those of the world. */
        private final @Nullable Turned own;

        Upright(int part, Bounds box, @Nullable Turned own) {
            super(part);
            this.own = own;
            minX = box.minX();
            minY = box.minY();
            minZ = box.minZ();
            maxX = box.maxX();
            maxY = box.maxY();
            maxZ = box.maxZ();
        }

        @Override
        public Bounds bounds() {
            return new Bounds(minX, minY, minZ, maxX, maxY, maxZ);
        }

        @Override
        protected boolean clip(Ray ray) {
            ray.needReciprocals();
            boolean forwardX = ray.rx > 0;
            ray.enter = ((forwardX ? minX : maxX) - ray.ox) * ray.rx;
            ray.leave = ((forwardX ? maxX : minX) - ray.ox) * ray.rx;
            ray.enterFace = forwardX ? 0 : 1;
            ray.leaveFace = forwardX ? 1 : 0;
            boolean forwardY = ray.ry > 0;
            boolean forwardZ = ray.rz > 0;
            return narrow(ray, ((forwardY ? minY : maxY) - ray.oy) * ray.ry, forwardY ? 2 : 3,
                            ((forwardY ? maxY : minY) - ray.oy) * ray.ry, forwardY ? 3 : 2)
                    && narrow(ray, ((forwardZ ? minZ : maxZ) - ray.oz) * ray.rz, forwardZ ? 4 : 5,
                            ((forwardZ ? maxZ : minZ) - ray.oz) * ray.rz, forwardZ ? 5 : 4);
        }

        @Override
        public void describe(int face, Hit hit) {
            double side = face % 2 == 0 ? -1 : 1;
            hit.unitNormal(face / 2 == 0 ? side : 0, face / 2 == 1 ? side : 0, face / 2 == 2 ? side : 0);
        }

        @Override
        public int ownFace(int face) {
            return own != null ? own.alongWorld(face) : face;
        }

        @Override
        public void map(int face, Hit hit) {
            if (own != null) {
                own.map(own.alongWorld(face), hit);
            } else {
                Block.map(face, (hit.px - minX) / (maxX - minX), (hit.py - minY) / (maxY - minY), (hit.pz - minZ) / (maxZ - minZ), hit);
            }
        }
    }

    /** A block turned or sheared, met in its own space. Faces as above. */
    private static final class Turned extends LocalConvex {
        /** By so much of itself is the square of its ball's radius made larger where nothing is known of the ray: rays come from as far as a thousand million radii. */
        private static final double LARGER = 2e-6;

        private final Vec3 min;
        private final Vec3 max;
        /** The map to its own space and its corners once more: all that a ray asks stands in one place. */
        private final double xx;
        private final double xy;
        private final double xz;
        private final double xt;
        private final double yx;
        private final double yy;
        private final double yz;
        private final double yt;
        private final double zx;
        private final double zy;
        private final double zz;
        private final double zt;
        /** Where its faces are along its axes. */
        private final double[] planes;
        /** A ball around it, world space. */
        private final double middleX;
        private final double middleY;
        private final double middleZ;
        private final double radius;

        Turned(int part, Affine toWorld, Vec3 min, Vec3 max) {
            super(part, toWorld, Bounds.of(min, max).transformed(toWorld));
            this.min = min;
            this.max = max;
            xx = toLocal.xx();
            xy = toLocal.xy();
            xz = toLocal.xz();
            xt = toLocal.xt();
            yx = toLocal.yx();
            yy = toLocal.yy();
            yz = toLocal.yz();
            yt = toLocal.yt();
            zx = toLocal.zx();
            zy = toLocal.zy();
            zz = toLocal.zz();
            zt = toLocal.zt();
            planes = new double[] {min.x(), max.x(), min.y(), max.y(), min.z(), max.z()};
            Vec3 middle = toWorld.point(min.plus(max).times(0.5));
            double farthest = 0;
            for (int corner = 0; corner < 8; corner++) {
                Vec3 at = toWorld.point(new Vec3((corner & 1) == 0 ? min.x() : max.x(), (corner & 2) == 0 ? min.y() : max.y(), (corner & 4) == 0 ? min.z() : max.z()));
                farthest = Math.max(farthest, at.minus(middle).length());
            }
            middleX = middle.x();
            middleY = middle.y();
            middleZ = middle.z();
            double size = farthest + Math.abs(middleX) + Math.abs(middleY) + Math.abs(middleZ);
            // On the way into the block's space and back errors of rounding grow as the map is sheared: by its condition.
            radius = farthest * (1 + 1e-9) + size * Math.max(1e-11, 1e-14 * toWorld.norm() * toLocal.norm());
        }

        /** Whether the ray passes by at a distance, or leads away: most do, and are told by a tenth of the reckoning. */
        private boolean isFarFrom(Ray ray) {
            double x = middleX - ray.ox;
            double y = middleY - ray.oy;
            double z = middleZ - ray.oz;
            double square = x * x + y * y + z * z;
            double along = x * ray.dx + y * ray.dy + z * ray.dz;
            double touching = radius + Ray.TOUCH * ray.scale;
            // ½·a·(a + |a|) is a² of what lies ahead, else 0.
            return square * (1 - 1e-12) - 0.5 * along * (along + Math.abs(along)) > touching * touching;
        }

        @Override
        protected void putAround(double[] into, int at) {
            into[at] = middleX;
            into[at + 1] = middleY;
            into[at + 2] = middleZ;
            into[at + 3] = radius * radius * (1 + LARGER);
        }

        @Override
        public void nearest(Ray ray) {
            if (!isFarFrom(ray)) {
                super.nearest(ray);
            }
        }

        @Override
        public boolean occludes(Ray ray) {
            return !isFarFrom(ray) && super.occludes(ray);
        }

        /** The face that looks along an axis of the world, to which one of its own is parallel. */
        int alongWorld(int face) {
            int axis = face / 2;
            double x = axis == 0 ? toLocal.xx() : axis == 1 ? toLocal.xy() : toLocal.xz();
            double y = axis == 0 ? toLocal.yx() : axis == 1 ? toLocal.yy() : toLocal.yz();
            double z = axis == 0 ? toLocal.zx() : axis == 1 ? toLocal.zy() : toLocal.zz();
            int ownAxis = x != 0 ? 0 : y != 0 ? 1 : 2;
            return 2 * ownAxis + (face % 2 == 1 == x + y + z > 0 ? 1 : 0);
        }

        /** As the other, by the same numbers, but without a branch before it is known whether anything is left: which way a ray goes cannot be foretold. */
        @Override
        protected boolean clip(Ray ray) {
            double alongX = alongX(ray);
            double alongY = alongY(ray);
            double alongZ = alongZ(ray);
            double overX = 1 / alongX;
            double overY = 1 / alongY;
            double overZ = 1 / alongZ;
            if (!areFinite(overX, overY, overZ)) {
                return super.clip(ray);
            }
            int backX = isNegative(alongX);
            int backY = isNegative(alongY);
            int backZ = isNegative(alongZ);
            double x = x(ray);
            double y = y(ray);
            double z = z(ray);
            double[] ends = planes;
            double enterX = (ends[backX] - x) * overX;
            double leaveX = (ends[1 - backX] - x) * overX;
            double enterY = (ends[2 + backY] - y) * overY;
            double leaveY = (ends[3 - backY] - y) * overY;
            double enterZ = (ends[4 + backZ] - z) * overZ;
            double leaveZ = (ends[5 - backZ] - z) * overZ;
            double enterXY = Math.max(enterX, enterY);
            double leaveXY = Math.min(leaveX, leaveY);
            double enter = Math.max(enterXY, enterZ);
            double leave = Math.min(leaveXY, leaveZ);
            if (!(enter < leave)) {
                return false;
            }
            int enterFace = enterY > enterX ? 2 + backY : backX;
            int leaveFace = leaveY < leaveX ? 3 - backY : 1 - backX;
            put(ray, enter, enterZ > enterXY ? 4 + backZ : enterFace, leave, leaveZ < leaveXY ? 5 - backZ : leaveFace);
            return true;
        }

        private static boolean areFinite(double x, double y, double z) {
            return Math.abs(x) + Math.abs(y) + Math.abs(z) <= Double.MAX_VALUE;
        }

        private static void put(Ray ray, double enter, int enterFace, double leave, int leaveFace) {
            ray.enter = enter;
            ray.enterFace = enterFace;
            ray.leave = leave;
            ray.leaveFace = leaveFace;
        }

        private double alongX(Ray ray) {
            return xx * ray.dx + xy * ray.dy + xz * ray.dz;
        }

        private double alongY(Ray ray) {
            return yx * ray.dx + yy * ray.dy + yz * ray.dz;
        }

        private double alongZ(Ray ray) {
            return zx * ray.dx + zy * ray.dy + zz * ray.dz;
        }

        private double x(Ray ray) {
            return xx * ray.ox + xy * ray.oy + xz * ray.oz + xt;
        }

        private double y(Ray ray) {
            return yx * ray.ox + yy * ray.oy + yz * ray.oz + yt;
        }

        private double z(Ray ray) {
            return zx * ray.ox + zy * ray.oy + zz * ray.oz + zt;
        }

        private static int isNegative(double x) {
            return (int) (Double.doubleToRawLongBits(x) >>> 63);
        }

        @Override
        protected boolean clip(Line line, Ray ray) {
            open(ray);
            return narrow(ray, line.ox, line.dx, min.x(), max.x(), 0)
                    && narrow(ray, line.oy, line.dy, min.y(), max.y(), 2)
                    && narrow(ray, line.oz, line.dz, min.z(), max.z(), 4);
        }

        @Override
        protected void describe(int face, double x, double y, double z, Affine toLocal, Hit hit) {
            double side = face % 2 == 0 ? -1 : 1;
            hit.normal(toLocal, face / 2 == 0 ? side : 0, face / 2 == 1 ? side : 0, face / 2 == 2 ? side : 0);
        }

        @Override
        protected void map(int face, double x, double y, double z, Hit hit) {
            Block.map(face, (x - min.x()) / (max.x() - min.x()), (y - min.y()) / (max.y() - min.y()), (z - min.z()) / (max.z() - min.z()), hit);
        }
    }

    /** A block with rounded edges: half of each belongs to either face, and pictures are laid on straight from before. */
    private static final class Soft extends Rounded {
        private final Vec3 min;
        private final Vec3 max;

        Soft(int part, Affine toWorld, Block shape) {
            super(part, toWorld, shape.middle(), shape.inner(), shape.rounding);
            min = shape.min;
            max = shape.max;
        }

        @Override
        protected int faceAt(double x, double y, double z) {
            Vec3 n = outwards(x, y, z);
            double ax = Math.abs(n.x());
            double ay = Math.abs(n.y());
            double az = Math.abs(n.z());
            return ax >= ay && ax >= az ? n.x() < 0 ? 0 : 1 : ay >= az ? n.y() < 0 ? 2 : 3 : n.z() < 0 ? 4 : 5;
        }

        /** Along the surface u grows towards t − (n·t/n·w)·w, t along the face and w out of it. */
        @Override
        protected void map(int face, double x, double y, double z, Hit hit) {
            Block.map(face, (x - min.x()) / (max.x() - min.x()), (y - min.y()) / (max.y() - min.y()), (z - min.z()) / (max.z() - min.z()), hit);
            Vec3 n = outwards(x, y, z);
            double out = face / 2 == 0 ? n.x() : face / 2 == 1 ? n.y() : n.z();
            double down = (n.x() * hit.tx + n.y() * hit.ty + n.z() * hit.tz) / out;
            hit.map(hit.u, hit.v, face / 2 == 0 ? -down : hit.tx, face / 2 == 1 ? -down : hit.ty, face / 2 == 2 ? -down : hit.tz);
        }
    }
}
