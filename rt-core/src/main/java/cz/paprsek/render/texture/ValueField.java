package cz.paprsek.render.texture;

import cz.paprsek.material.Pattern;

/** The value, from 0 to 1, that a pattern has at each point of its own space. */
public interface ValueField {
    double value(double x, double y, double z);

    /** Sets the three numbers to how much the value grows along x, y and z: where it jumps, to what it is beside. */
    void slope(double x, double y, double z, double[] out);

    static ValueField of(Pattern pattern) {
        if (pattern instanceof Pattern.Gradient) {
            return new Rising();
        } else if (pattern instanceof Pattern.Marble marble) {
            return new Veins(marble, new LatticeNoise(marble.octaves(), marble.seed()));
        } else if (pattern instanceof Pattern.Wood wood) {
            return new Rings(wood, new LatticeNoise(wood.octaves(), wood.seed()));
        } else if (pattern instanceof Pattern.Granite granite) {
            return new Grains(new LatticeNoise(granite.octaves(), granite.seed()));
        } else if (pattern instanceof Pattern.Noise clouds) {
            return new Clouds(new LatticeNoise(clouds.octaves(), clouds.seed()));
        }
        throw new IllegalStateException("a pattern without values: " + pattern.kind());
    }

    static Pattern.Lay lay(Pattern pattern) {
        return pattern instanceof Pattern.Gradient gradient ? gradient.lay()
                : pattern instanceof Pattern.Marble marble ? marble.lay()
                : pattern instanceof Pattern.Wood wood ? wood.lay()
                : pattern instanceof Pattern.Granite granite ? granite.lay() : ((Pattern.Noise) pattern).lay();
    }

    /** Of {@link Pattern.Gradient}. */
    record Rising() implements ValueField {
        @Override
        public double value(double x, double y, double z) {
            return Math.min(1, Math.max(0, y));
        }

        @Override
        public void slope(double x, double y, double z, double[] out) {
            set(out, 0, y > 0 && y < 1 ? 1 : 0, 0);
        }
    }

    /** Of {@link Pattern.Marble}. */
    record Veins(Pattern.Marble marble, LatticeNoise noise) implements ValueField {
        @Override
        public double value(double x, double y, double z) {
            return 1 - Math.abs(2 * fraction(at(x, y, z)) - 1);
        }

        private double at(double x, double y, double z) {
            return marble.frequency() * x + marble.turbulence() * noise.sum(x, y, z);
        }

        @Override
        public void slope(double x, double y, double z, double[] out) {
            noise.slope(x, y, z, out);
            double steep = fraction(at(x, y, z)) < 0.5 ? 2 : -2;
            double bent = steep * marble.turbulence();
            set(out, steep * marble.frequency() + bent * out[0], bent * out[1], bent * out[2]);
        }
    }

    /** Of {@link Pattern.Wood}. */
    record Rings(Pattern.Wood wood, LatticeNoise noise) implements ValueField {
        @Override
        public double value(double x, double y, double z) {
            return fraction(wood.frequency() * Math.sqrt(x * x + z * z) + wood.turbulence() * noise.sum(x, y, z));
        }

        @Override
        public void slope(double x, double y, double z, double[] out) {
            noise.slope(x, y, z, out);
            double radius = Math.sqrt(x * x + z * z);
            double outwards = radius > 0 ? wood.frequency() / radius : 0;
            double bent = wood.turbulence();
            set(out, outwards * x + bent * out[0], bent * out[1], outwards * z + bent * out[2]);
        }
    }

    /** Of {@link Pattern.Granite}. */
    record Grains(LatticeNoise noise) implements ValueField {
        @Override
        public double value(double x, double y, double z) {
            return Math.min(1, noise.sumOfSizes(x, y, z));
        }

        @Override
        public void slope(double x, double y, double z, double[] out) {
            noise.slopeOfSizes(x, y, z, out);
            if (noise.sumOfSizes(x, y, z) > 1) {
                set(out, 0, 0, 0);
            }
        }
    }

    /** Of {@link Pattern.Noise}. */
    record Clouds(LatticeNoise noise) implements ValueField {
        @Override
        public double value(double x, double y, double z) {
            return Math.min(1, Math.max(0, 0.5 + 0.5 * noise.sum(x, y, z)));
        }

        @Override
        public void slope(double x, double y, double z, double[] out) {
            noise.slope(x, y, z, out);
            double steep = Math.abs(noise.sum(x, y, z)) < 1 ? 0.5 : 0;
            set(out, steep * out[0], steep * out[1], steep * out[2]);
        }
    }

    private static void set(double[] out, double x, double y, double z) {
        out[0] = x;
        out[1] = y;
        out[2] = z;
    }

    /** 0 for what is no number, or too large to have a fraction. */
    private static double fraction(double t) {
        double fraction = t - Math.floor(t);
        return fraction < 1 ? fraction : 0;
    }
}
