package cz.paprsek.render.integrate;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.lanes.Lanes;
import cz.paprsek.render.lanes.Vec3s;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.render.light.PointLamp;
import cz.paprsek.render.surface.Level;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Adds what lights of no size bring to the hits of a block of rays from the eye, to all of them at once: where a light is and what it brings is told in plain loops over the hits, bit by bit as of each
 * hit by itself. Only what stands in the way is looked for hit by hit. Scratch of one worker.
 */
final class BlockLighting {
    /** For fewer lights and fewer hits than so many it takes longer to put the hits side by side than is won. */
    private static final int LEAST_LIGHTS = 2;
    private static final int LEAST_HITS = 8;

    private final Lighting lighting;
    private final PointLamp[] lamps;
    private int count;
    private Level[] levels = {};
    private final Vec3s points = new Vec3s();
    private final Vec3s normals = new Vec3s();
    private final Vec3s mirrored = new Vec3s();
    /** The directions to the light, of length 1. */
    private final Vec3s ways = new Vec3s();
    private double[] distances = {};
    /** R·L, and what has become of it on the way to the highlight. */
    private double[] alignments = {};
    /** kD. */
    private double[] diffusions = {};
    /** N·L, then kD · N·L. */
    private double[] diffuse = {};
    /** kS · max(0, R·L)ⁿ. */
    private double[] highlights = {};
    private double[] visibilities = {};
    private final Vec3s colors = new Vec3s();
    private final Vec3s sums = new Vec3s();
    /** Whether all hits have the same finish. */
    private boolean isOneFinish;

    private BlockLighting(Lighting lighting, PointLamp[] lamps) {
        this.lighting = lighting;
        this.lamps = lamps;
    }

    /** For lights that are all of a kind it knows; else empty. */
    static Optional<BlockLighting> of(Lighting lighting, Lamp[] lamps) {
        boolean areKnown = lamps.length >= LEAST_LIGHTS && Stream.of(lamps).allMatch(PointLamp.class::isInstance);
        return areKnown ? Optional.of(new BlockLighting(lighting, Arrays.copyOf(lamps, lamps.length, PointLamp[].class))) : Optional.empty();
    }

    /** Adds what the lights bring to those levels of a block that have met a surface of which it is known what it is like, and says of each whether it did. */
    void illuminate(Level[] block, int all) {
        start(all);
        for (int i = 0; i < all; i++) {
            Level level = block[i];
            level.isIlluminated = level.ray.part >= 0 && level.finish.isLit() && !level.isBent;
            if (level.isIlluminated) {
                add(level);
            }
        }
        if (count < LEAST_HITS) {
            for (int i = 0; i < count; i++) {
                levels[i].isIlluminated = false;
            }
            return;
        }
        for (int light = 0; light < lamps.length; light++) {
            look(light);
        }
        for (int i = 0; i < count; i++) {
            levels[i].light(sums.x[i], sums.y[i], sums.z[i]);
        }
    }

    private void start(int most) {
        count = 0;
        isOneFinish = true;
        if (levels.length < most) {
            levels = new Level[most];
            points.reserve(most);
            normals.reserve(most);
            mirrored.reserve(most);
            ways.reserve(most);
            distances = new double[most];
            alignments = new double[most];
            diffusions = new double[most];
            diffuse = new double[most];
            highlights = new double[most];
            visibilities = new double[most];
            colors.reserve(most);
            sums.reserve(most);
        }
    }

    private void add(Level level) {
        Hit hit = level.hit;
        int i = count++;
        if (levels[i] != level) {
            levels[i] = level;
        }
        isOneFinish &= level.finish == levels[0].finish;
        points.set(i, hit.px, hit.py, hit.pz);
        normals.set(i, hit.sx, hit.sy, hit.sz);
        mirrored.set(i, level.mirrorX, level.mirrorY, level.mirrorZ);
        colors.set(i, level.colorRed, level.colorGreen, level.colorBlue);
        sums.set(i, level.red, level.green, level.blue);
        diffusions[i] = level.finish.diffusion;
    }

    private void look(int light) {
        PointLamp lamp = lamps[light];
        lamp.look(points, ways, distances, count);
        normals.dot(ways, diffuse, count);
        mirrored.dot(ways, alignments, count);
        if (isOneFinish) {
            levels[0].finish.highlights(alignments, highlights, count);
        }
        boolean isClear = lighting.isClear(light);
        for (int i = 0; i < count; i++) {
            double visibility = 0;
            if (diffuse[i] > 0 && distances[i] > 0) {
                visibility = isClear ? clear() : visibility(light, i);
            }
            if (!(visibility > 0)) {
                // Adds nothing, not even to −0.
                visibility = -0.0;
                diffuse[i] = 0;
                highlights[i] = 0;
            } else if (!isOneFinish || !(highlights[i] >= 0)) {
                highlights[i] = levels[i].finish.highlight(alignments[i]);
            }
            visibilities[i] = visibility;
        }
        Lanes.multiply(diffuse, diffusions, count);
        add(lamp.red(), colors.x, sums.x);
        add(lamp.green(), colors.y, sums.y);
        add(lamp.blue(), colors.z, sums.z);
    }

    private double clear() {
        lighting.rays++;
        return 1;
    }

    private double visibility(int light, int i) {
        Arrival arrival = lighting.arrival;
        arrival.x = ways.x[i];
        arrival.y = ways.y[i];
        arrival.z = ways.z[i];
        arrival.distance = distances[i];
        return lighting.visibility(0, light, levels[i]);
    }

    /** Adds V·I·(kD · N·L · C + highlight), in one channel. */
    private void add(double light, double[] color, double[] sum) {
        double[] seen = visibilities;
        double[] part = diffuse;
        double[] more = highlights;
        int all = count;
        for (int i = 0; i < all; i++) {
            sum[i] += seen[i] * light * (part[i] * color[i] + more[i]);
        }
    }
}
