package cz.paprsek.render.surface;

import cz.paprsek.material.Pattern;
import cz.paprsek.material.Share.ColorChannel;
import cz.paprsek.math.Affine;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.texture.Texture;
import cz.paprsek.shape.placed.Part;
import java.util.Objects;

/** A picture on a surface. */
final class PicturePaint extends Paint {
    /** Slopes of u and v are found this share of the way to the neighbours. */
    private static final double STEP = 0x1p-10;
    /** So far u and v hardly grow on such a short way: there may be a seam between. */
    private static final double JUMP = 0.05;

    private final String file;
    private final Texture texture;
    private final Pattern.Filter filter;
    private final Mapping mapping;

    PicturePaint(Pattern.Picture picture, Affine toDeclared, Texture texture) {
        super(picture);
        this.file = picture.file();
        this.texture = texture;
        this.filter = picture.filter();
        this.mapping = Mapping.of(picture.mapping(), toOwn(picture.lay(), toDeclared), toOwn(picture.lay(), Affine.IDENTITY));
    }

    @Override
    public boolean isPicture() {
        return true;
    }

    @Override
    public void color(Level level) {
        Hit hit = level.hit;
        int face = level.ray.face < 0 ? ~level.ray.face : level.ray.face;
        Part part = Objects.requireNonNull(level.part);
        mapping.map(hit, part, face);
        switch (filter) {
            case NEAREST -> texture.nearest(hit.u, hit.v, hit);
            case BILINEAR -> texture.bilinear(hit.u, hit.v, hit);
            case SMOOTH -> smooth(level, part, face);
        }
        level.colorRed = hit.red;
        level.colorGreen = hit.green;
        level.colorBlue = hit.blue;
    }

    @Override
    Told tell(Level level, String of, String kind) {
        color(level);
        return told(level, of, kind, file, texture, level.colorRed, level.colorGreen, level.colorBlue);
    }

    static Told told(Level level, String of, String kind, String file, Texture texture, double red, double green, double blue) {
        double u = level.hit.u;
        double v = level.hit.v;
        Hit point = level.probe;
        texture.nearest(u, v, point);
        return new Told(of, kind, file, u, v, texture.column(u), texture.row(v), point.red, point.green, point.blue, red, green, blue);
    }

    /** By differences between neighbouring points of the picture, or over what a pixel covers if that is wider. */
    @Override
    void slope(Level level) {
        Chart chart = level.chart;
        chart.lay(level, mapping);
        double du = Math.max(0.5 / texture.width(), chart.wideU() / 2);
        double dv = Math.max(0.5 / texture.height(), chart.wideV() / 2);
        double alongU = (height(level, du, 0) - height(level, -du, 0)) / (2 * du);
        double alongV = (height(level, 0, dv) - height(level, 0, -dv)) / (2 * dv);
        chart.slope(alongU, alongV, level.slope);
    }

    private double height(Level level, double du, double dv) {
        Hit probe = level.probe;
        level.chart.look(texture, filter, level.hit.u + du, level.hit.v + dv, probe);
        return ColorChannel.LUMINANCE.of(probe.red, probe.green, probe.blue);
    }

    private void smooth(Level level, Part part, int face) {
        Hit hit = level.hit;
        Hit probe = level.probe;
        slope(level, 0, part, face);
        double uX = probe.u;
        double vX = probe.v;
        slope(level, 3, part, face);
        texture.smooth(hit.u, hit.v, uX, vX, probe.u, probe.v, hit);
    }

    /** Sets the probe's u and v to how much they grow on the way to a neighbour. */
    private void slope(Level level, int neighbour, Part part, int face) {
        Hit probe = level.probe;
        step(level, neighbour, STEP, part, face);
        double u = probe.u;
        double v = probe.v;
        if (Math.abs(u) + Math.abs(v) > JUMP) {
            step(level, neighbour, -STEP, part, face);
            if (Math.abs(probe.u) + Math.abs(probe.v) < Math.abs(u) + Math.abs(v)) {
                u = -probe.u;
                v = -probe.v;
            }
        }
        probe.u = u / STEP;
        probe.v = v / STEP;
    }

    private void step(Level level, int neighbour, double share, Part part, int face) {
        Hit hit = level.hit;
        Hit probe = level.probe;
        double[] point = level.footprint.point;
        probe.px = hit.px + share * point[neighbour];
        probe.py = hit.py + share * point[neighbour + 1];
        probe.pz = hit.pz + share * point[neighbour + 2];
        probe.unitNormal(hit.nx, hit.ny, hit.nz);
        mapping.map(probe, part, face);
        probe.u -= hit.u;
        probe.v -= hit.v;
    }
}
