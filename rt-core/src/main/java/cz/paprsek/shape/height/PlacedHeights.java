package cz.paprsek.shape.height;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.InBox;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.Optional;

/**
 * A field of heights in the world: all that lies below its triangles and above y = 0. Its own space is that of the grid.
 *
 * <p>Over a triangle, y minus height changes along a ray by one and the same rate, so it is 0 once if its sign is not the same at both ends, and that
 * place is one division. What is the end over one triangle is the beginning over the next, with the sign that was found: no ray slips through between two
 * of them. Blocks that lie wholly below the ray, or wholly above it while it is inside, are passed in one step.
 *
 * @source Amanatides, Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, Eurographics 1987, for the steps from cell to cell
 */
final class PlacedHeights extends InBox {
    /** The first triangle's number: that of a cell's which touches its lower row; the other one has the next. */
    static final int FIRST = 7;
    /** How much higher the box is than all heights, so that its lid is never met. */
    private static final double ABOVE = 1.0000001;

    /** As a share of the greatest height. */
    private static final double SKIN = 1e-12;

    private final Heights heights;
    private final boolean smooth;
    /** What is less thick is nothing: where heights are 0, rounding makes no skin. In units of the grid. */
    private final double skin;

    PlacedHeights(int part, Affine toWorld, Heights heights, boolean isSmooth) {
        super(part, toWorld, new Bounds(0, 0, 0, heights.columns - 1, heights.greatest() / heights.unit * ABOVE, heights.rows - 1));
        this.heights = heights;
        this.smooth = isSmooth;
        skin = SKIN * box[4];
    }

    @Override
    public double cost() {
        return 20;
    }

    private static int cell(double at, int least, int most) {
        return at >= most ? most : at >= least ? (int) at : least;
    }

    @Override
    protected void look(Line line, Ray ray, double from, double enough, Spans out) {
        int cellsX = heights.columns - 1;
        int cellsZ = heights.rows - 1;
        double dx = line.dx;
        double dz = line.dz;
        double high = ray.leave;
        double t = from;
        int x = cell(line.ox + t * dx, 0, cellsX - 1);
        int z = cell(line.oz + t * dz, 0, cellsZ - 1);
        boolean isInside = isBelow(line, t, x, z);
        if (isInside) {
            out.add(ray.enter, part, ray.enterFace);
            if (ray.enter > enough) {
                return;
            }
        }
        int top = heights.least.length;
        int level = top;
        while (true) {
            int beginX = x >> level << level;
            int beginZ = z >> level << level;
            int endX = Math.min(cellsX, beginX + (1 << level));
            int endZ = Math.min(cellsZ, beginZ + (1 << level));
            double atX = dx > 0 ? (endX - line.ox) / dx : dx < 0 ? (beginX - line.ox) / dx : Double.POSITIVE_INFINITY;
            double atZ = dz > 0 ? (endZ - line.oz) / dz : dz < 0 ? (beginZ - line.oz) / dz : Double.POSITIVE_INFINITY;
            double end = Math.max(t, Math.min(high, Math.min(atX, atZ)));
            if (level > 0) {
                double y = line.oy + t * line.dy;
                double yThere = line.oy + end * line.dy;
                int block = (z >> level) * heights.across(level - 1) + (x >> level);
                if (isInside ? Math.max(y, yThere) >= heights.least[level - 1][block] : Math.min(y, yThere) <= heights.greatest[level - 1][block]) {
                    level--;
                    continue;
                }
            } else {
                // From one triangle to the other where the ray crosses the cut between them.
                double turn = dx - dz;
                double cut = ((x - z) - (line.ox - line.oz)) / turn;
                boolean isCut = cut > t && cut < end;
                double middle = isCut ? cut : end;
                boolean isLower = isCut ? turn < 0 : isLower(line, t + (end - t) / 2, x, z);
                double until = middle;
                for (int i = isCut ? 0 : 1; i < 2; i++) {
                    int corner = z * heights.columns + x;
                    double atCorner = heights.steps[corner];
                    double opposite = heights.steps[corner + heights.columns + 1];
                    double between = heights.steps[corner + (isLower ? 1 : heights.columns)];
                    double slopeX = isLower ? between - atCorner : opposite - between;
                    double slopeZ = isLower ? opposite - between : between - atCorner;
                    double above = line.oy - atCorner - slopeX * (line.ox - x) - slopeZ * (line.oz - z);
                    double rate = line.dy - slopeX * dx - slopeZ * dz;
                    boolean isInsideThere = above + until * rate < -skin;
                    if (isInsideThere != isInside) {
                        double zero = -above / rate;
                        double crossing = zero > t ? Math.min(zero, until) : t;
                        isInside = isInsideThere;
                        out.add(crossing, part, FIRST + 2 * (z * cellsX + x) + (isLower ? 0 : 1));
                        if (crossing > enough) {
                            return;
                        }
                    }
                    t = until;
                    until = end;
                    isLower = !isLower;
                }
            }
            if (end >= high) {
                break;
            }
            t = end;
            if (atX <= atZ) {
                x = dx > 0 ? endX : beginX - 1;
                z = cell(line.oz + t * dz, dz < 0 ? beginZ : z, dz > 0 ? endZ - 1 : z);
            } else {
                z = dz > 0 ? endZ : beginZ - 1;
                x = cell(line.ox + t * dx, dx < 0 ? beginX : x, dx > 0 ? endX - 1 : x);
            }
            if (x < 0 || x >= cellsX || z < 0 || z >= cellsZ) {
                break;
            }
            level = Math.min(top, level + 1);
        }
        if (isInside) {
            out.add(high, part, ray.leaveFace);
        }
    }

    private static boolean isLower(Line line, double t, int x, int z) {
        return line.ox + t * line.dx - x >= line.oz + t * line.dz - z;
    }

    private boolean isBelow(Line line, double t, int x, int z) {
        double px = line.ox + t * line.dx;
        double pz = line.oz + t * line.dz;
        return line.oy + t * line.dy < -skin + height(isLower(line, t, x, z), x, z, px, pz);
    }

    private double height(boolean isLower, int x, int z, double px, double pz) {
        return heights.steps[z * heights.columns + x] + slopeX(isLower, x, z) * (px - x) + slopeZ(isLower, x, z) * (pz - z);
    }

    private double step(int x, int z) {
        return heights.steps[z * heights.columns + x];
    }

    private double slopeX(boolean isLower, int x, int z) {
        return isLower ? step(x + 1, z) - step(x, z) : step(x + 1, z + 1) - step(x, z + 1);
    }

    private double slopeZ(boolean isLower, int x, int z) {
        return isLower ? step(x + 1, z + 1) - step(x + 1, z) : step(x, z + 1) - step(x, z);
    }

    /** How fast heights change at a point of the grid along x, or z: between its neighbours, or to the only one. */
    private double slope(int x, int z, boolean isAlongX) {
        int before = isAlongX ? Math.max(0, x - 1) : Math.max(0, z - 1);
        int behind = isAlongX ? Math.min(heights.columns - 1, x + 1) : Math.min(heights.rows - 1, z + 1);
        return isAlongX ? (step(behind, z) - step(before, z)) / (behind - before) : (step(x, behind) - step(x, before)) / (behind - before);
    }

    @Override
    public void describe(int face, Hit hit) {
        if (describesSide(face, hit)) {
            return;
        }
        int cell = (face - FIRST) / 2;
        int x = cell % (heights.columns - 1);
        int z = cell / (heights.columns - 1);
        boolean isLower = (face - FIRST) % 2 == 0;
        hit.normal(toLocal, -slopeX(isLower, x, z), 1, -slopeZ(isLower, x, z));
        if (smooth) {
            double fx = Math.max(0, Math.min(1, toLocal.pointX(hit.px, hit.py, hit.pz) - x));
            double fz = Math.max(0, Math.min(1, toLocal.pointZ(hit.px, hit.py, hit.pz) - z));
            bend(-mixed(isLower, x, z, fx, fz, true), -mixed(isLower, x, z, fx, fz, false), hit);
        }
    }

    /** Its corners are that of its cell with the least x and z, the one between, and the opposite one; numbers go cell by cell, row by row from −z on. */
    @Override
    public Optional<Corners> corners(int face, Hit hit) {
        if (face < FIRST) {
            return Optional.empty();
        }
        int cell = (face - FIRST) / 2;
        double fx = Math.max(0, Math.min(1, toLocal.pointX(hit.px, hit.py, hit.pz) - cell % (heights.columns - 1)));
        int row = cell / (heights.columns - 1);
        double fz = Math.max(0, Math.min(1, toLocal.pointZ(hit.px, hit.py, hit.pz) - row));
        // The lower one is where fx is the greater.
        double opposite = Math.min(fx, fz);
        double most = Math.max(fx, fz);
        return Optional.of(new Corners(face - FIRST, "", new Vec3(1 - most, most - opposite, opposite)));
    }

    /** The slope at a place of a triangle, between those of its corners. */
    private double mixed(boolean isLower, int x, int z, double fx, double fz, boolean isAlongX) {
        double corner = slope(x, z, isAlongX);
        double between = isLower ? slope(x + 1, z, isAlongX) : slope(x, z + 1, isAlongX);
        double opposite = slope(x + 1, z + 1, isAlongX);
        return isLower ? corner + (between - corner) * fx + (opposite - between) * fz : corner + (between - corner) * fz + (opposite - between) * fx;
    }

    /** Sets the normal for light from one whose y is 1, own space. */
    private void bend(double x, double z, Hit hit) {
        hit.bend(toLocal.xx() * x + toLocal.yx() + toLocal.zx() * z, toLocal.xy() * x + toLocal.yy() + toLocal.zy() * z, toLocal.xz() * x + toLocal.yz() + toLocal.zz() * z);
        hit.isRounded = true;
    }

    /** The relief has the picture as it lies on the ground for who looks to −z; the faces of the box have it each once. */
    @Override
    public void map(int face, Hit hit) {
        double x = toLocal.pointX(hit.px, hit.py, hit.pz);
        double z = toLocal.pointZ(hit.px, hit.py, hit.pz);
        if (face < FIRST) {
            mapSide(face, x, toLocal.pointY(hit.px, hit.py, hit.pz), z, hit);
        } else {
            int cell = (face - FIRST) / 2;
            double slope = slopeX((face - FIRST) % 2 == 0, cell % (heights.columns - 1), cell / (heights.columns - 1));
            hit.map(x / (heights.columns - 1), 1 - z / (heights.rows - 1), 1, slope, 0);
        }
        hit.tangentFrom(toLocal);
    }
}
