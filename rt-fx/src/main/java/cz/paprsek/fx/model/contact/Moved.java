package cz.paprsek.fx.model.contact;

import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Surface;
import java.util.Comparator;
import java.util.List;

/**
 * What is moved along an axis.
 *
 * @param byU how far it has been moved across the axis before
 * @param byV how far it has been moved aside before
 * @param upwards by where their boxes begin
 * @param downwards by where these end, the farthest first
 */
record Moved(Axis axis, double byU, double byV, List<Part> upwards, List<Part> downwards) {
    /** One of the bodies, and its box: along the axis and across it. */
    record Part(Surface surface, double least, double most, double leastU, double mostU, double leastV, double mostV) {
        boolean isOn(double u, double v) {
            return leastU <= u && u <= mostU && leastV <= v && v <= mostV;
        }
    }

    /** @param before how far it has been moved before; along the axis that does not count */
    static Moved along(Axis axis, List<Surface> own, Vec3 before) {
        Axis u = across(axis);
        Axis v = aside(axis);
        double byU = u.of(before);
        double byV = v.of(before);
        List<Part> parts = own.stream().map(surface -> {
            Bounds box = surface.bounds();
            return new Part(surface, axis.least(box), axis.most(box), u.least(box) + byU, u.most(box) + byU, v.least(box) + byV, v.most(box) + byV);
        }).toList();
        return new Moved(axis, byU, byV, parts.stream().sorted(Comparator.comparingDouble(Part::least)).toList(),
                parts.stream().sorted(Comparator.comparingDouble(Part::most).reversed()).toList());
    }

    /** Those that lines between these meet. */
    Moved within(double leastU, double mostU, double leastV, double mostV) {
        return new Moved(axis, byU, byV, within(upwards, leastU, mostU, leastV, mostV), within(downwards, leastU, mostU, leastV, mostV));
    }

    private static List<Part> within(List<Part> parts, double leastU, double mostU, double leastV, double mostV) {
        return parts.stream().filter(part -> part.leastU <= mostU && part.mostU >= leastU && part.leastV <= mostV && part.mostV >= leastV).toList();
    }

    boolean isEmpty() {
        return upwards.isEmpty();
    }

    /** Where the first begins; there must be one. */
    double least() {
        return upwards.get(0).least;
    }

    /** Where the last ends; there must be one. */
    double most() {
        return downwards.get(0).most;
    }

    Axis across() {
        return across(axis);
    }

    Axis aside() {
        return aside(axis);
    }

    private static Axis across(Axis axis) {
        return axis == Axis.X ? Axis.Y : Axis.X;
    }

    private static Axis aside(Axis axis) {
        return axis == Axis.Z ? Axis.Y : Axis.Z;
    }
}
