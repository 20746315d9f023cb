package cz.paprsek.shape.mesh;

/** Meshes to try things on, in closed forms. */
public final class Meshes {
    private Meshes() {}

    /** The box from −a to a, two triangles a side, with its eight corners once. */
    public static Triangles cube(double a) {
        double[] places = new double[24];
        for (int i = 0; i < 24; i++) {
            places[i] = (((i / 3) >> (i % 3)) & 1) == 0 ? -a : a;
        }
        return Triangles.of(places, new int[] {
            0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6});
    }

    /** A ball about the origin of rings × 2·rings fields, its poles on the y axis; corners lie on the sphere. */
    public static Triangles ball(double radius, int rings) {
        Triangles.Builder out = Triangles.builder();
        int around = 2 * rings;
        int top = out.vertex(0, radius, 0);
        int bottom = out.vertex(0, -radius, 0);
        for (int i = 1; i < rings; i++) {
            double latitude = Math.PI * i / rings;
            for (int j = 0; j < around; j++) {
                double longitude = 2 * Math.PI * j / around;
                out.vertex(radius * StrictMath.sin(latitude) * StrictMath.sin(longitude), radius * StrictMath.cos(latitude),
                        radius * StrictMath.sin(latitude) * StrictMath.cos(longitude));
            }
        }
        for (int j = 0; j < around; j++) {
            int next = (j + 1) % around;
            out.triangle(top, 2 + j, 2 + next);
            for (int i = 0; i + 2 < rings; i++) {
                int a = 2 + i * around;
                out.triangle(a + j, a + around + j, a + around + next);
                out.triangle(a + j, a + around + next, a + next);
            }
            int last = 2 + (rings - 2) * around;
            out.triangle(bottom, last + next, last + j);
        }
        return out.build();
    }

    /** A torus about the y axis of around × tube fields; corners lie on the surface. */
    public static Triangles torus(double major, double minor, int around, int tube) {
        Triangles.Builder out = Triangles.builder().expect(around * tube, 2 * around * tube);
        for (int i = 0; i < around; i++) {
            double a = 2 * Math.PI * i / around;
            for (int j = 0; j < tube; j++) {
                double b = 2 * Math.PI * j / tube;
                double rho = major + minor * StrictMath.cos(b);
                out.vertex(rho * StrictMath.cos(a), minor * StrictMath.sin(b), rho * StrictMath.sin(a));
            }
        }
        for (int i = 0; i < around; i++) {
            int here = i * tube;
            int there = (i + 1) % around * tube;
            for (int j = 0; j < tube; j++) {
                int next = (j + 1) % tube;
                out.triangle(here + j, here + next, there + next);
                out.triangle(here + j, there + next, there + j);
            }
        }
        return out.build();
    }

    /** The same triangles, each with three corners of its own, as STL has them. */
    public static Triangles apart(Triangles mesh) {
        Triangles.Builder out = Triangles.builder();
        for (int t = 0; t < mesh.count(); t++) {
            int[] v = new int[3];
            for (int k = 0; k < 3; k++) {
                int at = mesh.corner(t, k);
                v[k] = out.vertex(mesh.x(at), mesh.y(at), mesh.z(at));
            }
            out.triangle(v[0], v[1], v[2]);
        }
        return out.build();
    }

    /** All but one of the triangles. */
    public static Triangles without(Triangles mesh, int triangle) {
        Triangles.Builder out = Triangles.builder();
        for (int v = 0; v < mesh.vertexCount(); v++) {
            out.vertex(mesh.x(v), mesh.y(v), mesh.z(v));
        }
        for (int t = 0; t < mesh.count(); t++) {
            if (t != triangle) {
                out.triangle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
            }
        }
        return out.build();
    }

    /** Both together; the second moved, and turned inside out if asked. */
    public static Triangles both(Triangles one, Triangles other, double moveX, boolean insideOut) {
        Triangles.Builder out = Triangles.builder();
        for (int v = 0; v < one.vertexCount(); v++) {
            out.vertex(one.x(v), one.y(v), one.z(v));
        }
        for (int v = 0; v < other.vertexCount(); v++) {
            out.vertex(other.x(v) + moveX, other.y(v), other.z(v));
        }
        for (int t = 0; t < one.count(); t++) {
            out.triangle(one.corner(t, 0), one.corner(t, 1), one.corner(t, 2));
        }
        int n = one.vertexCount();
        for (int t = 0; t < other.count(); t++) {
            out.triangle(n + other.corner(t, 0), n + other.corner(t, insideOut ? 2 : 1), n + other.corner(t, insideOut ? 1 : 2));
        }
        return out.build();
    }
}
