package cz.paprsek.fx.model.contact;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * How much room there is above a floor. What is beside or above a point counts by its box; what is around it, such as a room of one piece, an arch, or what has no end, is
 * asked where lines upwards and to the sides meet it.
 */
final class Headroom {
    /** As far apart things touch, in parts of the size that is asked for. */
    private static final double SLACK = 1e-3;
    /** Lines upwards on each side of a square, and to the sides all round. */
    private static final int LINES = 7;
    private static final int WAYS = 16;
    /** In which parts of the height it is looked to the sides. */
    private static final double[] HEIGHTS = {0.1, 0.5, 0.95};

    private final List<Surface> surfaces;
    private final Ray ray = new Ray(new Spans());

    /** What is asked, and what has been found: how high the first thing above is, and how far up something beside lifts what stands here. */
    private final class Asked {
        private final double half;
        private final double height;
        private final double slack;
        private final Vec3 floor;
        private double roof = Double.POSITIVE_INFINITY;
        private double lifted;

        Asked(Vec3 at, double width, double height, double slack) {
            this.half = width / 2;
            this.height = height;
            this.slack = slack;
            this.floor = at.plus(Vec3.Y.times(slack));
            this.lifted = at.y();
        }

        void box(Bounds box) {
            if (box.minY() > floor.y()) {
                roof = Math.min(roof, box.minY());
            } else {
                lifted = Math.max(lifted, box.maxY());
            }
        }

        void around(Surface surface) {
            double own = above(surface, floor, false);
            roof = Math.min(roof, own);
            for (int i = 0; i < LINES * LINES; i++) {
                int row = i / LINES;
                above(surface, floor.plus(new Vec3(half * (2.0 * (i % LINES) / (LINES - 1) - 1), 0, half * (2.0 * row / (LINES - 1) - 1))), Double.isFinite(own));
            }
            for (int i = 0; i < WAYS * HEIGHTS.length; i++) {
                double angle = 2 * Math.PI * (i % WAYS) / WAYS;
                aside(surface, floor.plus(Vec3.Y.times(height * HEIGHTS[i / WAYS])), new Vec3(Math.cos(angle), 0, Math.sin(angle)), own);
            }
        }

        /**
         * Notes what a line upwards meets.
         *
         * @param isCovered whether there is something of the surface above the point itself: a floor that has no inside and rises beside it is none
         * @return what is above the start, if that is not within
         */
        private double above(Surface surface, Vec3 start, boolean isCovered) {
            double[] met = met(surface, start, Vec3.Y);
            boolean isWithin = surface.contains(start);
            int first = isWithin ? 1 : 0;
            if (isWithin) {
                lifted = Math.max(lifted, met.length > 0 ? start.y() + met[0] : Double.POSITIVE_INFINITY);
            }
            double over = met.length > first ? start.y() + met[first] : Double.POSITIVE_INFINITY;
            if (isWithin || isCovered || (Double.isFinite(over) && surface.contains(new Vec3(start.x(), over + slack, start.z())))) {
                roof = Math.min(roof, over);
            }
            return over;
        }

        /** What stands beside lifts what is here by its top; a wall without an inside, by no end. */
        private void aside(Surface surface, Vec3 start, Vec3 way, double own) {
            double[] met = met(surface, start, way);
            if (met.length == 0 || met[0] > half || surface.contains(start)) {
                return;
            }
            Vec3 beyond = start.plus(way.times(met[0] + slack));
            double[] over = met(surface, beyond, Vec3.Y);
            boolean isTop = over.length > 0 && (surface.contains(beyond) || beyond.y() + over[0] < own - slack);
            lifted = Math.max(lifted, isTop ? beyond.y() + over[0] : Double.POSITIVE_INFINITY);
        }
    }

    Headroom(EditorState state) {
        Scene scene = state.scene();
        surfaces = IntStream.range(0, scene.objects().size()).filter(i -> !state.isHidden(ScenePath.body(i)) && !scene.objects().get(i).hidden())
                .mapToObj(i -> ScenePath.body(i).placed(scene)).toList();
    }

    /**
     * The point on the surface that is nearest to a point above or below it: what keeps to a grid on a hollow is beneath it. The point itself if there is none near.
     *
     * @param reach how far above or below, scene units
     */
    Vec3 grounded(Vec3 at, double reach) {
        double nearest = reach;
        Vec3 found = at;
        Vec3 start = at.minus(Vec3.Y.times(reach));
        for (Surface surface : surfaces) {
            Bounds box = surface.bounds();
            if (box.minX() <= at.x() && box.maxX() >= at.x() && box.minZ() <= at.z() && box.maxZ() >= at.z() && box.minY() <= at.y() + reach && box.maxY() >= at.y() - reach) {
                for (double far : met(surface, start, Vec3.Y)) {
                    if (Math.abs(far - reach) < nearest) {
                        nearest = Math.abs(far - reach);
                        found = start.plus(Vec3.Y.times(far));
                    }
                }
            }
        }
        return found;
    }

    /**
     * Whether something can stand on a point, below what is above it, also when something beside it on the same floor lifts it.
     *
     * @param width how wide and how deep it is about the point, scene units
     * @param height how high it is
     * @param size what slack is relative to
     */
    boolean fits(Vec3 at, double width, double height, double size) {
        Asked asked = new Asked(at, width, height, SLACK * size);
        for (Surface surface : surfaces) {
            Bounds box = surface.bounds();
            boolean isNear = box.minX() < at.x() + asked.half && box.maxX() > at.x() - asked.half && box.minZ() < at.z() + asked.half && box.maxZ() > at.z() - asked.half;
            if (isNear && box.maxY() > asked.floor.y()) {
                if (box.contains(asked.floor)) {
                    asked.around(surface);
                } else {
                    asked.box(box);
                }
            }
        }
        return asked.lifted + height <= asked.roof + asked.slack;
    }

    /** How far from its start a line meets a surface, the nearest first. */
    private double[] met(Surface surface, Vec3 start, Vec3 way) {
        Spans spans = ray.spans;
        ray.start(start.x(), start.y(), start.z(), way.x(), way.y(), way.z());
        int mark = spans.size();
        surface.crossings(ray, spans);
        double[] found = IntStream.range(mark, spans.size()).mapToDouble(spans::t).filter(Double::isFinite).toArray();
        spans.release(mark);
        Arrays.sort(found);
        return found;
    }
}
