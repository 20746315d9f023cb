package cz.paprsek.cli.describe;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Part;
import cz.paprsek.shape.Parts;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Ray;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Spans;
import cz.paprsek.shape.Surface;
import cz.paprsek.shape.Volume;
import java.util.function.IntFunction;

/** Asks placed shapes where they are, by the same code that renders them. */
final class Solids {
    private Solids() {}

    static boolean contains(Solid solid, Placement placement, Vec3 point) {
        return holds(place(solid, placement), point);
    }

    /** Whether a point is in a placed shape; never in one without an inside. */
    static boolean holds(Surface placed, Vec3 point) {
        if (!(placed instanceof Volume volume) || !volume.bounds().contains(point)) {
            return false;
        }
        Ray ray = new Ray(new Spans());
        ray.start(point.x(), point.y(), point.z(), 1, 0, 0);
        return volume.holdsOrigin(ray);
    }

    static Surface place(Shape shape, Placement placement) {
        return shape.place(placement.toParent(), new Uncounted());
    }

    /** Nobody asks here which part was hit, so all have one number. */
    private static final class Uncounted implements Parts {
        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            return maker.apply(0);
        }

        @Override
        public Parts within(Operand operand, Affine toWorld) {
            return this;
        }
    }
}
