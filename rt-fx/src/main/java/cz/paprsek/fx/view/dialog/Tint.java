package cz.paprsek.fx.view.dialog;

import javafx.scene.paint.Color;

/**
 * A colour by hue (degrees), saturation and brightness (from 0 to 1), which black, white and grey keep although they do not show them.
 */
record Tint(double hue, double saturation, double brightness) {
    /** What is less is shown as none: half a step of 255. */
    private static final double NONE = 0.5 / 255;

    /** What it can be told by, and up to which number. */
    enum Part {
        HUE("color.hue", 360),
        SATURATION("color.saturation", 100),
        BRIGHTNESS("color.brightness", 100),
        RED("color.red", 255),
        GREEN("color.green", 255),
        BLUE("color.blue", 255);

        private final String key;
        private final int most;

        Part(String key, int most) {
            this.key = key;
            this.most = most;
        }

        /** Of its name. */
        String key() {
            return key;
        }

        /** Its largest number; the least is 0. */
        int most() {
            return most;
        }
    }

    static Tint of(Color color) {
        return new Tint(color.getHue(), color.getSaturation(), color.getBrightness());
    }

    Color color() {
        return Color.hsb(hue, saturation, brightness);
    }

    /** The number of a part, from 0 to its largest. */
    double get(Part part) {
        return switch (part) {
            case HUE -> hue;
            case SATURATION -> saturation * part.most;
            case BRIGHTNESS -> brightness * part.most;
            case RED -> color().getRed() * part.most;
            case GREEN -> color().getGreen() * part.most;
            case BLUE -> color().getBlue() * part.most;
        };
    }

    /** With another number of a part, and all else as it is. */
    Tint with(Part part, double number) {
        double share = Math.max(0, Math.min(1, number / part.most));
        Color old = color();
        return switch (part) {
            case HUE -> new Tint(share * part.most, saturation, brightness);
            case SATURATION -> new Tint(hue, share, brightness);
            case BRIGHTNESS -> new Tint(hue, saturation, share);
            case RED -> shown(Color.color(share, old.getGreen(), old.getBlue()));
            case GREEN -> shown(Color.color(old.getRed(), share, old.getBlue()));
            case BLUE -> shown(Color.color(old.getRed(), old.getGreen(), share));
        };
    }

    /** Another colour, but with the hue and saturation of this one where it has none to be seen. */
    Tint shown(Color color) {
        boolean isGrey = color.getSaturation() < NONE;
        boolean isBlack = color.getBrightness() < NONE;
        return new Tint(isGrey ? hue : color.getHue(), isBlack ? saturation : color.getSaturation(), color.getBrightness());
    }

    /** As {@link #with}, by somebody who looks for a colour: where a hue or a saturation would not be seen, it comes with what makes it seen. */
    Tint sought(Part part, double number) {
        Tint seen = part == Part.HUE && saturation < NONE ? new Tint(hue, 1, brightness) : this;
        boolean isDark = brightness < NONE && (part == Part.HUE || part == Part.SATURATION);
        return (isDark ? new Tint(seen.hue, seen.saturation, 1) : seen).with(part, number);
    }
}
