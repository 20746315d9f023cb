package cz.paprsek.image;

/** How light is fitted to what a screen can show. */
public enum Tone {
    /** Not at all: light beyond white is white. */
    NONE {
        @Override
        double of(double light) {
            return light;
        }
    },
    /**
     * As photographic film does: shadows a little darker, highlights bent towards white, which is reached at 5.6 times what is white otherwise.
     * Channel by channel.
     *
     * @source Hable, Filmic Tonemapping for Real-time Rendering, SIGGRAPH 2010 course Color Enhancement and Rendering in Film and Game
     *     Production: his curve with his constants, exposure bias 2 and linear white 11.2
     */
    FILMIC {
        @Override
        double of(double light) {
            return Math.min(1, curve(2 * Math.max(0, light)) / curve(11.2));
        }

        private double curve(double x) {
            // Beyond all films, where the quotient of squares would overflow.
            double least = Math.min(x, 1e6);
            double shoulder = 0.15;
            double linear = 0.50;
            double angle = 0.10;
            double toe = 0.20;
            double numerator = 0.02;
            double denominator = 0.30;
            return (least * (shoulder * least + angle * linear) + toe * numerator) / (least * (shoulder * least + linear) + toe * denominator)
                    - numerator / denominator;
        }
    };

    /** The light to show, 1 for white. */
    abstract double of(double light);
}
