package cz.paprsek.fx.model.contact;

import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Bounds;
import cz.paprsek.shape.placed.Surface;
import java.util.Comparator;
import java.util.List;

/**
 * What is moved along an axis.
 *
 * @param upwards by where their boxes begin
 * @param downwards by where these end, the farthest first
 */
record Moved(Axis axis, List<Part> upwards, List<Part> downwards) {
    /** One of the bodies, and its box: along the axis and across it. */
    record Part(Surface surface, double least, double most, double leastU, double mostU, double leastV, double mostV) {
        boolean isOn(double u, double v) {
            return leastU <= u && u <= mostU && leastV <= v && v <= mostV;
        }
    }

    static Moved along(Axis axis, List<Surface> own) {
        Axis u = across(axis);
        Axis v = aside(axis);
        List<Part> parts = own.stream().map(surface -> {
            Bounds box = surface.bounds();
            return new Part(surface, axis.least(box), axis.most(box), u.least(box), u.most(box), v.least(box), v.most(box));
        }).toList();
        return new Moved(axis, parts.stream().sorted(Comparator.comparingDouble(Part::least)).toList(),
                parts.stream().sorted(Comparator.comparingDouble(Part::most).reversed()).toList());
    }

    /** Those that lines between these meet. */
    Moved within(double leastU, double mostU, double leastV, double mostV) {
        return new Moved(axis, within(upwards, leastU, mostU, leastV, mostV), within(downwards, leastU, mostU, leastV, mostV));
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
