package cz.paprsek.render.surface;

import cz.paprsek.ray.Hit;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;

/**
 * How far apart a ray and its neighbours are, those of the next pixel to the right and of the one below: where they start and where they go, and
 * where they meet the plane of a surface. Followed through mirrors and glass by asking surfaces for their normals there.
 *
 * @source Igehy, Tracing Ray Differentials, SIGGRAPH 1999
 */
public final class Footprint {
    /** For both neighbours, x, y and z of how far their origins are away, and by how much their directions differ. */
    private final double[] origin = new double[6];
    final double[] direction = new double[6];
    /** For both neighbours, how far away their points are. */
    final double[] point = new double[6];
    private final Hit probe = new Hit();

    /** Sets one neighbour, 0 or 1, from its ray. */
    public void start(int neighbour, Ray ray, Ray beside) {
        int i = 3 * neighbour;
        origin[i] = beside.ox - ray.ox;
        origin[i + 1] = beside.oy - ray.oy;
        origin[i + 2] = beside.oz - ray.oz;
        direction[i] = beside.dx - ray.dx;
        direction[i + 1] = beside.dy - ray.dy;
        direction[i + 2] = beside.dz - ray.dz;
    }

    /** Sets a neighbour that is the ray itself. */
    public void startAlike(int neighbour) {
        for (int i = 3 * neighbour; i < 3 * neighbour + 3; i++) {
            origin[i] = 0;
            direction[i] = 0;
        }
    }

    /** Where the neighbours meet the plane of the surface that the ray has hit. */
    public void meet(Ray ray, Hit hit) {
        double along = ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz;
        for (int i = 0; i < 6; i += 3) {
            double x = origin[i] + ray.max * direction[i];
            double y = origin[i + 1] + ray.max * direction[i + 1];
            double z = origin[i + 2] + ray.max * direction[i + 2];
            double k = (x * hit.nx + y * hit.ny + z * hit.nz) / along;
            // Of a surface that is only grazed, what lies across counts.
            boolean isMet = Math.abs(k) < 1e30;
            point[i] = isMet ? x - k * ray.dx : x;
            point[i + 1] = isMet ? y - k * ray.dy : y;
            point[i + 2] = isMet ? z - k * ray.dz : z;
        }
    }

    /** Becomes that of the mirrored ray. */
    public void mirrored(Footprint of, Ray ray, Hit hit, Part part) {
        double c = ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz;
        for (int i = 0; i < 6; i += 3) {
            of.normalBeside(i, ray, hit, part);
            double x = ray.dx + of.direction[i];
            double y = ray.dy + of.direction[i + 1];
            double z = ray.dz + of.direction[i + 2];
            double d = x * of.probe.nx + y * of.probe.ny + z * of.probe.nz;
            set(i, of, of.direction[i] - 2 * (d * of.probe.nx - c * hit.nx), of.direction[i + 1] - 2 * (d * of.probe.ny - c * hit.ny),
                    of.direction[i + 2] - 2 * (d * of.probe.nz - c * hit.nz));
        }
    }

    /**
     * Becomes that of the ray that goes on.
     *
     * @param e refractive index before the surface divided by that beyond it
     */
    public void refracted(Footprint of, Ray ray, Hit hit, Part part, double e) {
        double k = bend(ray.dx, ray.dy, ray.dz, hit, e);
        for (int i = 0; i < 6; i += 3) {
            of.normalBeside(i, ray, hit, part);
            double x = ray.dx + of.direction[i];
            double y = ray.dy + of.direction[i + 1];
            double z = ray.dz + of.direction[i + 2];
            double beside = bend(x, y, z, of.probe, e);
            set(i, of, e * of.direction[i] + beside * of.probe.nx - k * hit.nx, e * of.direction[i + 1] + beside * of.probe.ny - k * hit.ny,
                    e * of.direction[i + 2] + beside * of.probe.nz - k * hit.nz);
        }
    }

    /** By how much of the normal a direction is bent: e·c − √t; where all is mirrored, as if it grazed. */
    private static double bend(double x, double y, double z, Hit at, double e) {
        double c = -(x * at.nx + y * at.ny + z * at.nz);
        double t = 1 + e * e * (c * c - 1);
        return e * c - Math.sqrt(Math.max(0, t));
    }

    private void set(int i, Footprint of, double x, double y, double z) {
        for (int k = 0; k < 3; k++) {
            origin[i + k] = of.point[i + k];
        }
        direction[i] = x;
        direction[i + 1] = y;
        direction[i + 2] = z;
    }

    /** The normal where the neighbour meets the surface, on the side of that of the hit; the same if the surface has none there. */
    private void normalBeside(int i, Ray ray, Hit hit, Part part) {
        probe.px = hit.px + point[i];
        probe.py = hit.py + point[i + 1];
        probe.pz = hit.pz + point[i + 2];
        part.describe(ray.face < 0 ? ~ray.face : ray.face, probe);
        double side = probe.nx * hit.nx + probe.ny * hit.ny + probe.nz * hit.nz;
        if (side < 0) {
            probe.turn();
        } else if (!(side > 0)) {
            probe.unitNormal(hit.nx, hit.ny, hit.nz);
        }
    }
}
