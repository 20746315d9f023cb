package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Capsule;
import java.util.ArrayList;
import java.util.List;

/** Solids that POV-Ray has no word of its own for, put together of what it has; without the brace that ends them. */
final class PovRounds {
    private PovRounds() {}

    static String capsule(Capsule capsule) {
        return rounded(new Vec3(0, capsule.height() / 2, 0), new Vec3(0, capsule.height() / 2, 0), capsule.radius());
    }

    static String block(Block block) {
        double r = block.rounding();
        Vec3 half = block.max().minus(block.min()).times(0.5);
        return rounded(block.min().plus(block.max()).times(0.5), new Vec3(Math.max(0, half.x() - r), Math.max(0, half.y() - r), Math.max(0, half.z() - r)), r);
    }

    /** All that is not farther than a radius from a box: boxes thicker by it along one axis, cylinders along the edges, balls at the corners. */
    private static String rounded(Vec3 middle, Vec3 half, double r) {
        List<String> parts = new ArrayList<>();
        for (Vec3 thicker : List.of(new Vec3(r, 0, 0), new Vec3(0, r, 0), new Vec3(0, 0, r))) {
            Vec3 to = half.plus(thicker);
            if (to.x() > 0 && to.y() > 0 && to.z() > 0) {
                parts.add("box { " + vector(middle.minus(to)) + ", " + vector(middle.plus(to)) + " }");
            }
        }
        for (Vec3 corner : corners(half)) {
            parts.add("sphere { " + vector(middle.plus(corner)) + ", " + text(r) + " }");
            for (Vec3 along : List.of(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1))) {
                double at = along.dot(corner);
                if (at < 0) {
                    parts.add("cylinder { " + vector(middle.plus(corner)) + ", " + vector(middle.plus(corner).minus(along.times(2 * at))) + ", " + text(r) + " }");
                }
            }
        }
        return "merge { " + String.join(" ", parts);
    }

    private static List<Vec3> corners(Vec3 half) {
        List<Vec3> corners = new ArrayList<>();
        for (int x = half.x() > 0 ? -1 : 1; x <= 1; x += 2) {
            for (int y = half.y() > 0 ? -1 : 1; y <= 1; y += 2) {
                for (int z = half.z() > 0 ? -1 : 1; z <= 1; z += 2) {
                    corners.add(new Vec3(x * half.x(), y * half.y(), z * half.z()));
                }
            }
        }
        return corners;
    }

    /** What lies behind the planes of all sides, between the lids. */
    static String sided(int sides, double radius, double topRadius, double height) {
        double toMiddle = StrictMath.cos(Math.PI / sides);
        double slope = (topRadius - radius) * toMiddle / height;
        double length = Math.sqrt(1 + slope * slope);
        StringBuilder planes = new StringBuilder("intersection { plane { -y, 0 } plane { y, " + text(height) + " }");
        for (int i = 0; i < sides; i++) {
            double angle = 2 * Math.PI * (i + 0.5) / sides;
            planes.append(" plane { ").append(vector(StrictMath.cos(angle) / length, -slope / length, StrictMath.sin(angle) / length))
                    .append(", ").append(text(radius * toMiddle / length)).append(" }");
        }
        return planes.toString();
    }

    /** What the tube of a ring covers twice is hollow in POV-Ray. The ball hides that: it lies within the ring, and reaches to where the tube meets the axis. */
    static String spindle(double major, double minor, String unclosed) {
        double reach = Math.sqrt((minor - major) * (minor + major));
        return "merge { " + unclosed + " } sphere { <0, 0, 0>, " + text(reach) + " }";
    }
}
