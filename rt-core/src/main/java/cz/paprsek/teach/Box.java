package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.NORMAL_BY_MATRIX;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.shape.Block;
import cz.paprsek.teach.Primitive.Stretch;
import cz.paprsek.teach.mistake.Mistakes;

/** A block: what lies between three pairs of planes. Face 2a is at the minimum of axis a, 2a + 1 at its maximum. */
final class Box extends Primitive.Convex {
    private final Affine toWorld;
    private final Affine toOwn;
    private final Vec min;
    private final Vec max;
    private final Mistakes made;

    Box(int number, Paint paint, Affine toWorld, Block block, Mistakes made) {
        super(number, paint);
        this.made = made;
        // One whose faces are still perpendicular to the axes needs no space of its own.
        boolean isUpright = toWorld.keepsAxes();
        Bounds box = isUpright ? Bounds.of(toWorld.point(block.min()), toWorld.point(block.max())) : Bounds.of(block.min(), block.max());
        this.toWorld = isUpright ? Affine.IDENTITY : toWorld;
        this.toOwn = isUpright ? Affine.IDENTITY : toWorld.inverse();
        this.min = new Vec(box.minX(), box.minY(), box.minZ());
        this.max = new Vec(box.maxX(), box.maxY(), box.maxZ());
    }

    @Override
    Stretch inside(Ray ray) {
        Vec o = ray.start().through(toOwn);
        Vec d = ray.direction().along(toOwn);
        return Stretch.ALL.between(o.x(), d.x(), min.x(), max.x(), 0).between(o.y(), d.y(), min.y(), max.y(), 2).between(o.z(), d.z(), min.z(), max.z(), 4);
    }

    @Override
    Vec normal(Vec point, int face) {
        double side = face % 2 == 0 ? -1 : 1;
        Vec own = new Vec(face / 2 == 0 ? side : 0, face / 2 == 1 ? side : 0, face / 2 == 2 ? side : 0);
        return made.has(NORMAL_BY_MATRIX) ? own.along(toWorld).unit() : own.normalFrom(toOwn);
    }
}
