package cz.paprsek.shape.mesh;

import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Draws triangles by few of their sides: those of which one triangle looks here and the other away, those at which they are bent sharply, and those
 * that have not just two. Made once; what was drawn last is kept, for whoever drags a mesh asks again and again.
 */
final class Sketch {
    /** More lines than this are not seen apart: then every second is left out, or more. */
    private static final int MOST = 2000;
    /** The cosine of 40°. */
    private static final double SHARP = 0.766;
    private static final int KEPT = 12;

    private final Triangles mesh;
    /** Of each edge one side and the other, which is −1 if there are not just two. */
    private final int[] sides;
    /** For each triangle, of length 1; 0 0 0 if it has none. */
    private final float[] normals;
    private final Map<Vec3, List<List<Vec3>>> drawn = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Vec3, List<List<Vec3>>> eldest) {
            return size() > KEPT;
        }
    };

    Sketch(Triangles mesh) {
        this.mesh = mesh;
        int[] corners = mesh.corners();
        int[] found = new int[2 * corners.length];
        int[] count = {0};
        new Edges(Weld.firsts(mesh.places()), corners).each((side, other) -> {
            found[count[0]++] = side;
            found[count[0]++] = other;
        });
        sides = Arrays.copyOf(found, count[0]);
        normals = new float[corners.length];
        for (int t = 0; t < mesh.count(); t++) {
            Vec3 a = mesh.place(mesh.corner(t, 0));
            Vec3 n = mesh.place(mesh.corner(t, 1)).minus(a).cross(mesh.place(mesh.corner(t, 2)).minus(a));
            double length = n.length();
            if (length > 0) {
                normals[3 * t] = (float) (n.x() / length);
                normals[3 * t + 1] = (float) (n.y() / length);
                normals[3 * t + 2] = (float) (n.z() / length);
            }
        }
    }

    synchronized List<List<Vec3>> lines(Vec3 along) {
        return drawn.computeIfAbsent(along, this::draw);
    }

    private List<List<Vec3>> draw(Vec3 along) {
        int[] chosen = new int[256];
        int count = 0;
        for (int i = 0; i < sides.length; i += 2) {
            if (sides[i + 1] < 0 || isDrawn(sides[i] / 3, sides[i + 1] / 3, along)) {
                if (count == chosen.length) {
                    chosen = Arrays.copyOf(chosen, 2 * count);
                }
                chosen[count++] = sides[i];
            }
        }
        int step = 1 + count / MOST;
        List<List<Vec3>> lines = new ArrayList<>();
        for (int i = 0; i < count; i += step) {
            int side = chosen[i];
            lines.add(List.of(mesh.place(mesh.corner(side / 3, side % 3)), mesh.place(mesh.corner(side / 3, (side + 1) % 3))));
        }
        return List.copyOf(lines);
    }

    private boolean isDrawn(int t, int other, Vec3 along) {
        return (towards(t, along) > 0) != (towards(other, along) > 0)
                || normals[3 * t] * normals[3 * other] + normals[3 * t + 1] * normals[3 * other + 1] + normals[3 * t + 2] * normals[3 * other + 2] < SHARP;
    }

    private double towards(int t, Vec3 along) {
        return normals[3 * t] * along.x() + normals[3 * t + 1] * along.y() + normals[3 * t + 2] * along.z();
    }
}
