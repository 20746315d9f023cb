package cz.paprsek.render.surface;

import cz.paprsek.material.Pattern;
import cz.paprsek.math.Affine;
import cz.paprsek.ray.Hit;
import java.util.List;

/** A pattern with a value from 0 to 1 at each point of its space, and the colours that those have, mixed in linear light. */
final class MixedColors extends Paint {
    private final Affine toPattern;
    private final ValueField field;
    private final double[] at;
    private final double[] linear;

    MixedColors(Pattern pattern, Affine toDeclared) {
        super(pattern);
        field = ValueField.of(pattern);
        toPattern = toOwn(ValueField.lay(pattern), toDeclared);
        List<Pattern.Stop> stops = pattern.colors().stops();
        at = stops.stream().mapToDouble(Pattern.Stop::at).toArray();
        linear = new double[3 * at.length];
        for (int i = 0; i < at.length; i++) {
            linear[3 * i] = stops.get(i).color().linearRed();
            linear[3 * i + 1] = stops.get(i).color().linearGreen();
            linear[3 * i + 2] = stops.get(i).color().linearBlue();
        }
    }

    @Override
    public void color(Level level) {
        Hit hit = level.hit;
        double value = field.value(toPattern.pointX(hit.px, hit.py, hit.pz), toPattern.pointY(hit.px, hit.py, hit.pz), toPattern.pointZ(hit.px, hit.py, hit.pz));
        int next = 0;
        while (next < at.length && at[next] <= value) {
            next++;
        }
        int upper = Math.min(next, at.length - 1);
        int lower = Math.max(next - 1, 0);
        double share = upper > lower ? (value - at[lower]) / (at[upper] - at[lower]) : 0;
        level.colorRed = mixed(3 * lower, 3 * upper, share);
        level.colorGreen = mixed(3 * lower + 1, 3 * upper + 1, share);
        level.colorBlue = mixed(3 * lower + 2, 3 * upper + 2, share);
    }

    private double mixed(int lower, int upper, double share) {
        return linear[lower] + share * (linear[upper] - linear[lower]);
    }
}
