package cz.paprsek.shape.mesh;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.placed.Part;
import java.util.Optional;

/** A part of a mesh in the world; its faces have the numbers of the triangles. */
final class MeshPart implements Part {
    final int number;
    private final Triangles mesh;
    private final Facets facets;
    private final Affine toLocal;

    MeshPart(int number, Triangles mesh, Facets facets, Affine toLocal) {
        this.number = number;
        this.mesh = mesh;
        this.facets = facets;
        this.toLocal = toLocal;
    }

    @Override
    public void describe(int face, Hit hit) {
        // Where it was just met it need not be fetched from memory, as what stands in the order of triangles and vertices must.
        Vec3 product = facets.isAt(hit.hint, face) ? facets.product(hit.hint) : product(face);
        // Two sides of 1e-45 have a product whose square would be none.
        double most = Math.max(Math.abs(product.x()), Math.max(Math.abs(product.y()), Math.abs(product.z())));
        double x = product.x() / most;
        double y = product.y() / most;
        double z = product.z() / most;
        hit.normal(toLocal, x, y, z);
        if (mesh.hasNormals()) {
            smooth(3 * mesh.corner(face, 0), 3 * mesh.corner(face, 1), 3 * mesh.corner(face, 2), x, y, z, hit);
        }
    }

    /** Sets the normal for light to what lies between those of the corners, if all have one. */
    private void smooth(int a, int b, int c, double x, double y, double z, Hit hit) {
        if (isUnknown(a) || isUnknown(b) || isUnknown(c)) {
            return;
        }
        Vec3 atA = unit(a);
        Vec3 atB = unit(b);
        Vec3 atC = unit(c);
        Vec3 share = shares(a, b, c, x, y, z, hit);
        double mx = share.x() * atA.x() + share.y() * atB.x() + share.z() * atC.x();
        double my = share.x() * atA.y() + share.y() * atB.y() + share.z() * atC.y();
        double mz = share.x() * atA.z() + share.y() * atB.z() + share.z() * atC.z();
        double side = mx * x + my * y + mz * z < 0 ? -1 : 1;
        double sx = toLocal.xx() * mx + toLocal.yx() * my + toLocal.zx() * mz;
        double sy = toLocal.xy() * mx + toLocal.yy() * my + toLocal.zy() * mz;
        double sz = toLocal.xz() * mx + toLocal.yz() * my + toLocal.zz() * mz;
        double k = side / Math.sqrt(sx * sx + sy * sy + sz * sz);
        if (Math.abs(k) <= Double.MAX_VALUE) {
            hit.sx = sx * k;
            hit.sy = sy * k;
            hit.sz = sz * k;
            hit.isRounded = true;
        }
    }

    private boolean isUnknown(int at) {
        float[] normals = mesh.normals();
        return normals[at] == 0 && normals[at + 1] == 0 && normals[at + 2] == 0;
    }

    /** The normal of the vertex whose coordinates begin at a place, of length 1. */
    private Vec3 unit(int at) {
        float[] normals = mesh.normals();
        double x = normals[at];
        double y = normals[at + 1];
        double z = normals[at + 2];
        double length = Math.sqrt(x * x + y * y + z * z);
        return new Vec3(x / length, y / length, z / length);
    }

    /**
     * How much of each corner is in a point of the triangle, as seen along the axis that its normal is nearest to: 0–1, together 1.
     *
     * @param a where the coordinates of the corners begin
     * @param x of the normal, of any length
     */
    private Vec3 shares(int a, int b, int c, double x, double y, double z, Hit hit) {
        double px = toLocal.pointX(hit.px, hit.py, hit.pz);
        double py = toLocal.pointY(hit.px, hit.py, hit.pz);
        double pz = toLocal.pointZ(hit.px, hit.py, hit.pz);
        double[] at = mesh.places();
        boolean alongX = Math.abs(x) >= Math.abs(y) && Math.abs(x) >= Math.abs(z);
        boolean alongY = !alongX && Math.abs(y) >= Math.abs(z);
        int i = alongX ? 1 : 0;
        int j = alongX || alongY ? 2 : 1;
        return shares(at[b + i] - at[a + i], at[b + j] - at[a + j], at[c + i] - at[a + i], at[c + j] - at[a + j],
                (alongX ? py : px) - at[a + i], (alongX || alongY ? pz : py) - at[a + j]);
    }

    /** By the ways from the first corner to the others and to the point: a method of its own, so that Java puts both into those that call them and makes no object. */
    private static Vec3 shares(double ux, double uy, double vx, double vy, double dx, double dy) {
        double whole = ux * vy - uy * vx;
        double ofB = Math.min(1, Math.max(0, (dx * vy - dy * vx) / whole));
        double ofC = Math.min(1 - ofB, Math.max(0, (ux * dy - uy * dx) / whole));
        return new Vec3(1 - ofB - ofC, ofB, ofC);
    }

    /** How much of each of its corners is in a point of a triangle. */
    private Vec3 shares(int triangle, Hit hit) {
        Vec3 n = product(triangle);
        return shares(3 * mesh.corner(triangle, 0), 3 * mesh.corner(triangle, 1), 3 * mesh.corner(triangle, 2), n.x(), n.y(), n.z(), hit);
    }

    private Vec3 product(int triangle) {
        return Measures.product(mesh.places(), 3 * mesh.corner(triangle, 0), 3 * mesh.corner(triangle, 1), 3 * mesh.corner(triangle, 2));
    }

    @Override
    public Optional<Corners> corners(int face, Hit hit) {
        return Optional.of(new Corners(face, mesh.parts().get(mesh.part(face)), shares(face, hit)));
    }

    @Override
    public void tint(int face, Hit hit) {
        Vec3 share = shares(face, hit);
        Vec3 color = mesh.color(mesh.corner(face, 0)).times(share.x()).plus(mesh.color(mesh.corner(face, 1)).times(share.y())).plus(mesh.color(mesh.corner(face, 2)).times(share.z()));
        hit.color(color.x(), color.y(), color.z());
    }

    @Override
    public void map(int face, Hit hit) {
        Vec3 a = mesh.place(mesh.corner(face, 0));
        Vec3 along = mesh.place(mesh.corner(face, 1)).minus(a);
        if (mesh.hasMap()) {
            mapAsGiven(face, along, mesh.place(mesh.corner(face, 2)).minus(a), hit);
        } else {
            mapGlobe(face, along, hit);
        }
        hit.tangentFrom(toLocal);
    }

    private void mapAsGiven(int face, Vec3 along, Vec3 across, Hit hit) {
        Vec3 share = shares(face, hit);
        int a = mesh.corner(face, 0);
        int b = mesh.corner(face, 1);
        int c = mesh.corner(face, 2);
        double u = share.x() * mesh.u(a) + share.y() * mesh.u(b) + share.z() * mesh.u(c);
        double v = share.x() * mesh.v(a) + share.y() * mesh.v(b) + share.z() * mesh.v(c);
        double up = (double) mesh.v(b) - mesh.v(a);
        double upAcross = (double) mesh.v(c) - mesh.v(a);
        double side = ((double) mesh.u(b) - mesh.u(a)) * upAcross - ((double) mesh.u(c) - mesh.u(a)) * up < 0 ? -1 : 1;
        // u grows and v does not.
        Vec3 tangent = along.times(side * upAcross).minus(across.times(side * up));
        set(hit, u, v, tangent, along);
    }

    /** As on a globe about the middle of the mesh. */
    private void mapGlobe(int face, Vec3 along, Hit hit) {
        Vec3 middle = middle();
        Vec3 p = new Vec3(toLocal.pointX(hit.px, hit.py, hit.pz), toLocal.pointY(hit.px, hit.py, hit.pz), toLocal.pointZ(hit.px, hit.py, hit.pz)).minus(middle);
        hit.mapGlobe(p.x(), p.y(), p.z());
        Vec3 n = product(face);
        Vec3 globe = new Vec3(hit.tx, hit.ty, hit.tz);
        double a = -globe.dot(n) / p.dot(n);
        set(hit, hit.u, hit.v, Math.abs(a) < Double.MAX_VALUE ? globe.plus(p.times(a)) : along, along);
    }

    private Vec3 middle() {
        return new Vec3((mesh.bounds().minX() + mesh.bounds().maxX()) / 2, (mesh.bounds().minY() + mesh.bounds().maxY()) / 2,
                (mesh.bounds().minZ() + mesh.bounds().maxZ()) / 2);
    }

    private static void set(Hit hit, double u, double v, Vec3 tangent, Vec3 otherwise) {
        double length = tangent.length();
        Vec3 chosen = length > 0 && length <= Double.MAX_VALUE ? tangent : otherwise;
        hit.map(u, v, chosen.x(), chosen.y(), chosen.z());
    }
}
