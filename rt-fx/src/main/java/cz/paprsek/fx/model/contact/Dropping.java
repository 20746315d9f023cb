package cz.paprsek.fx.model.contact;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Adding;
import cz.paprsek.fx.model.edit.Alignment;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Puts new things onto the side of a surface that they are dropped on: on a floor, at a wall, below a ceiling. As changes for the model's editState. */
public final class Dropping {
    /** The cosine from which a side is a floor, or a ceiling: it slants by 45 degrees at most. */
    private static final double LEVEL = Math.sqrt(0.5);
    private static final double FINEST = 1e6;
    /** What is flat comes so far out of a wall, in parts of its size: of two surfaces at one place either may be seen. */
    private static final double FLAT = 1e-3;
    /** As far apart boxes touch, in parts of their size. */
    private static final double SLACK = 1e-3;
    /** A room may be open to one side, for the camera. */
    private static final int WALLS = 3;
    /** How high and how wide what is added may be, in parts of its size. */
    private static final double TALLEST = 1.2;
    private static final double WIDEST = 1.5;
    /** As far a grid on a hollow may be beneath it, in parts of the size. */
    private static final double HOLLOW = 1.0 / 16;
    /** How many sizes are tried, each half of the one before or a little less. */
    private static final int SIZES = 7;

    private Dropping() {}

    /**
     * Adds a body. On a floor it falls onto what is below it; elsewhere it touches the surface.
     *
     * @param sight the point that it is dropped on, and how large it is there
     * @param side the surface's normal at the point, of length 1, towards the viewer; 0 if the point shall be the body's middle
     */
    public static EditorState body(EditorState state, Shape shape, String name, Sight sight, Vec3 side) {
        Bounds box = shape.bounds();
        if (!box.isFinite() || side.equals(Vec3.ZERO)) {
            return Adding.shape(state, shape, name, sight);
        }
        if (side.y() > LEVEL) {
            EditorState added = Adding.shape(state, shape, name, moved(sight, Vec3.Y.times((box.maxY() - box.minY()) / 2)));
            return Falling.onFloor(added, added.selection());
        }
        double reach = shape instanceof Sphere ball ? ball.radius()
                : (Math.abs(side.x()) * (box.maxX() - box.minX()) + Math.abs(side.y()) * (box.maxY() - box.minY()) + Math.abs(side.z()) * (box.maxZ() - box.minZ())) / 2;
        return Adding.shape(state, shape, name, moved(sight, side.times(Math.max(reach, FLAT * sight.size()))));
    }

    /**
     * Adds a light before a surface, at which it shines; below a ceiling one that shines down. A sun stands nowhere.
     *
     * @param sight the point that it is dropped on, and how far before it the light is
     * @param side the surface's normal at the point, of length 1, towards the viewer; 0 if the point shall be the light's own
     */
    public static EditorState light(EditorState state, Light kind, String name, Sight sight, Vec3 side) {
        if (kind instanceof SunLight) {
            return Adding.light(state, kind, name, sight);
        }
        List<Bounds> boxes = Alignment.with(state, List.of()).others();
        Vec3 place = moved(sight, side.times(before(boxes, sight, side))).point();
        boolean isUpheld = side.y() < -LEVEL || side.equals(Vec3.ZERO);
        Vec3 lit = isUpheld ? new Vec3(place.x(), below(boxes, place, sight.size()), place.z()) : sight.point();
        return Adding.lightAt(state, kind, name, place, new Sight(lit, sight.size()));
    }

    /** How far before a surface a light is: where there is little room, in the middle of it. */
    private static double before(List<Bounds> boxes, Sight sight, Vec3 side) {
        Vec3 at = sight.point();
        double slack = SLACK * sight.size();
        double room = side.y() < -LEVEL ? at.y() - below(boxes, at, 2 * sight.size())
                : side.y() > LEVEL ? over(boxes, at).map(Bounds::minY).filter(y -> y > at.y() + slack).min(Comparator.naturalOrder()).orElse(Double.POSITIVE_INFINITY) - at.y()
                : Double.POSITIVE_INFINITY;
        return Math.min(sight.size(), room / 2);
    }

    /** How high the first box below a point is, else so far below the point. */
    private static double below(List<Bounds> boxes, Vec3 at, double reach) {
        return over(boxes, at).map(Bounds::maxY).filter(y -> y < at.y() - SLACK * reach).max(Comparator.naturalOrder()).orElse(at.y() - reach);
    }

    /**
     * How high something is that is seen from above, by its box: the first thing there, but in a room not its roof. 0 where there is nothing.
     *
     * @param x world space
     * @param z world space
     */
    public static double top(EditorState state, double x, double z) {
        List<Bounds> all = Alignment.with(state, List.of()).others();
        Vec3 at = new Vec3(x, 0, z);
        List<Bounds> here = over(all, at).sorted(Comparator.comparingDouble(Bounds::maxY).reversed()).toList();
        int first = 0;
        while (first + 1 < here.size()
                && (here.get(first).contains(state.camera().position()) || isRoof(here.get(first), here.get(first + 1).maxY(), all, at))) {
            first++;
        }
        return here.isEmpty() ? 0 : here.get(first).maxY();
    }

    /**
     * As large as a thing can be that stands on a floor: it stays below what is above it, also when something beside it, on the same floor, lifts it. The smallest where there is no
     * room at all; unchanged at walls and below ceilings.
     *
     * @param sight the point that it is dropped on, and how large it would be
     * @param side the surface's normal at the point, of length 1, towards the viewer
     */
    public static Sight fitting(EditorState state, Sight sight, Vec3 side) {
        if (side.y() <= LEVEL) {
            return sight;
        }
        Headroom room = new Headroom(state);
        Vec3 ground = room.grounded(sight.point(), sight.size() * HOLLOW);
        Sight fit = sight;
        for (int step = 0; step < SIZES && !room.fits(ground, fit.size() * WIDEST, fit.size() * TALLEST, fit.size()); step++) {
            fit = fit.smaller();
        }
        return fit;
    }

    /** Whether there are walls below it, which do not go on above it. */
    private static boolean isRoof(Bounds roof, double floor, List<Bounds> all, Vec3 at) {
        double slack = SLACK * (roof.maxX() - roof.minX() + roof.maxZ() - roof.minZ());
        double middle = (roof.minY() + floor) / 2;
        if (roof.minY() - floor < slack) {
            return false;
        }
        List<Bounds> walls = all.stream().filter(box -> box.minY() < middle && box.maxY() > middle && box.maxY() < roof.maxY() + slack).toList();
        return IntStream.range(0, 4).filter(side -> walls.stream().anyMatch(box -> isWall(box, at, side, slack))).count() >= WALLS;
    }

    private static boolean isWall(Bounds box, Vec3 at, int side, double slack) {
        boolean isBefore = box.minX() <= at.x() && at.x() <= box.maxX();
        boolean isBeside = box.minZ() <= at.z() && at.z() <= box.maxZ();
        return switch (side) {
            case 0 -> isBeside && box.minX() >= at.x() - slack;
            case 1 -> isBeside && box.maxX() <= at.x() + slack;
            case 2 -> isBefore && box.minZ() >= at.z() - slack;
            default -> isBefore && box.maxZ() <= at.z() + slack;
        };
    }

    /** Boxes above or below a point, or around it. */
    private static Stream<Bounds> over(List<Bounds> boxes, Vec3 at) {
        return boxes.stream().filter(box -> box.minX() <= at.x() && at.x() <= box.maxX() && box.minZ() <= at.z() && at.z() <= box.maxZ());
    }

    private static Sight moved(Sight sight, Vec3 by) {
        Vec3 to = sight.point().plus(by);
        return new Sight(new Vec3(rounded(to.x()), rounded(to.y()), rounded(to.z())), sight.size());
    }

    private static double rounded(double value) {
        return Math.rint(value * FINEST) / FINEST + 0.0;
    }
}
