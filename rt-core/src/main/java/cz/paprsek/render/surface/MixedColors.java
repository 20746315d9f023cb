package cz.paprsek.render.surface;

import cz.paprsek.material.Pattern;
import cz.paprsek.math.Affine;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.texture.ValueField;
import java.util.List;

/** A pattern with a value from 0 to 1 at each point of its space, and the colours that those have, mixed linearly. */
final class MixedColors extends Paint {
    private final Affine toPattern;
    private final ValueField field;
    private final double[] at;
    private final double[] channels;

    MixedColors(Pattern pattern, Affine toDeclared, boolean isLight) {
        super(pattern);
        field = ValueField.of(pattern);
        toPattern = toOwn(ValueField.lay(pattern), toDeclared);
        List<Pattern.Stop> stops = pattern.colors().stops();
        at = stops.stream().mapToDouble(Pattern.Stop::at).toArray();
        channels = channels(pattern.palette(), isLight);
    }

    @Override
    public void color(Level level) {
        double value = value(level.hit);
        int upper = upper(value);
        int lower = lower(value);
        double share = upper > lower ? (value - at[lower]) / (at[upper] - at[lower]) : 0;
        level.colorRed = mixed(3 * lower, 3 * upper, share);
        level.colorGreen = mixed(3 * lower + 1, 3 * upper + 1, share);
        level.colorBlue = mixed(3 * lower + 2, 3 * upper + 2, share);
    }

    private double value(Hit hit) {
        return field.value(toPattern.pointX(hit.px, hit.py, hit.pz), toPattern.pointY(hit.px, hit.py, hit.pz), toPattern.pointZ(hit.px, hit.py, hit.pz));
    }

    /** How many stops there are up to a value. */
    private int passed(double value) {
        int next = 0;
        while (next < at.length && at[next] <= value) {
            next++;
        }
        return next;
    }

    private int upper(double value) {
        return Math.min(passed(value), at.length - 1);
    }

    private int lower(double value) {
        return Math.max(passed(value) - 1, 0);
    }

    private double mixed(int lower, int upper, double share) {
        return channels[lower] + share * (channels[upper] - channels[lower]);
    }

    @Override
    void slope(Level level) {
        Hit hit = level.hit;
        double[] slope = level.slope;
        double value = value(hit);
        int upper = upper(value);
        int lower = lower(value);
        double rise = luminance(channels, 3 * upper) - luminance(channels, 3 * lower);
        double steep = upper > lower ? rise / (at[upper] - at[lower]) : 0;
        field.slope(toPattern.pointX(hit.px, hit.py, hit.pz), toPattern.pointY(hit.px, hit.py, hit.pz), toPattern.pointZ(hit.px, hit.py, hit.pz), slope);
        toWorld(toPattern, steep * slope[0], steep * slope[1], steep * slope[2], slope);
    }
}
