package cz.paprsek.render.surface;

import cz.paprsek.material.Pattern;

/** The value, from 0 to 1, that a pattern has at each point of its own space. */
interface ValueField {
    double value(double x, double y, double z);

    static ValueField of(Pattern pattern) {
        if (pattern instanceof Pattern.Gradient) {
            return (x, y, z) -> Math.min(1, Math.max(0, y));
        } else if (pattern instanceof Pattern.Marble marble) {
            LatticeNoise noise = new LatticeNoise(marble.octaves(), marble.seed());
            return (x, y, z) -> triangle(marble.frequency() * x + marble.turbulence() * noise.sum(x, y, z));
        } else if (pattern instanceof Pattern.Wood wood) {
            LatticeNoise noise = new LatticeNoise(wood.octaves(), wood.seed());
            return (x, y, z) -> fraction(wood.frequency() * Math.sqrt(x * x + z * z) + wood.turbulence() * noise.sum(x, y, z));
        } else if (pattern instanceof Pattern.Granite granite) {
            LatticeNoise noise = new LatticeNoise(granite.octaves(), granite.seed());
            return (x, y, z) -> Math.min(1, noise.sumOfSizes(x, y, z));
        } else if (pattern instanceof Pattern.Noise clouds) {
            LatticeNoise noise = new LatticeNoise(clouds.octaves(), clouds.seed());
            return (x, y, z) -> Math.min(1, Math.max(0, 0.5 + 0.5 * noise.sum(x, y, z)));
        }
        throw new IllegalStateException("a pattern without values: " + pattern.kind());
    }

    static Pattern.Lay lay(Pattern pattern) {
        return pattern instanceof Pattern.Gradient gradient ? gradient.lay()
                : pattern instanceof Pattern.Marble marble ? marble.lay()
                : pattern instanceof Pattern.Wood wood ? wood.lay()
                : pattern instanceof Pattern.Granite granite ? granite.lay() : ((Pattern.Noise) pattern).lay();
    }

    /** From 0 at whole numbers to 1 half way between; 0 for what is no number. */
    private static double triangle(double t) {
        return 1 - Math.abs(2 * fraction(t) - 1);
    }

    /** 0 for what is no number, or too large to have a fraction. */
    private static double fraction(double t) {
        double fraction = t - Math.floor(t);
        return fraction < 1 ? fraction : 0;
    }
}
