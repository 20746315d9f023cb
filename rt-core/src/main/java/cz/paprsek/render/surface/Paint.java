package cz.paprsek.render.surface;

import cz.paprsek.material.CustomPattern;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share.ColorChannel;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.text.Numbers;
import java.util.List;
import java.util.Objects;

/** A pattern ready to be asked for its colour at a point. */
public abstract class Paint {
    private final boolean mapped;

    Paint(Pattern pattern) {
        this.mapped = pattern.isMapped();
    }

    /**
     * The paint of a pattern.
     *
     * @param toDeclared from the world to the space of the object that declares the pattern
     * @param textures the pictures
     * @param isLight whether colours are light, or numbers, which are 0–1 as they stand
     */
    static Paint of(Pattern pattern, Affine toDeclared, Textures textures, boolean isLight) {
        if (pattern instanceof Pattern.Plain plain) {
            return new TwoColors.Plain(plain, isLight);
        } else if (pattern instanceof Pattern.Checkerboard board) {
            return new TwoColors.Board(board, isLight);
        } else if (pattern instanceof Pattern.Checker checker) {
            return new TwoColors.Cubes(checker, toDeclared, isLight);
        } else if (pattern instanceof Pattern.Stripes stripes) {
            return new TwoColors.Layers(stripes, toDeclared, isLight);
        } else if (pattern instanceof Pattern.Brick brick) {
            return new TwoColors.Bricks(brick, toDeclared, isLight);
        }
        if (pattern instanceof Pattern.Picture picture) {
            return new PicturePaint(picture, toDeclared, textures.texture(picture.file(), isLight));
        }
        return pattern instanceof CustomPattern custom ? new Custom(custom, toDeclared) : new MixedColors(pattern, toDeclared, isLight);
    }

    /** Whether its colours depend on where in space the pattern is declared. */
    public static boolean isPlaced(Pattern pattern) {
        return !(pattern instanceof Pattern.Plain || pattern instanceof Pattern.Checkerboard);
    }

    /** From the world to a pattern's own space. */
    static Affine toOwn(Pattern.Lay lay, Affine toDeclared) {
        // Not a product with one that does nothing: minus zeros might become zeros.
        return lay.equals(Pattern.Lay.NONE) ? toDeclared : lay.toParent().inverse().after(toDeclared);
    }

    /** Whether it asks for the map of the hit: u, v and the tangent. */
    public final boolean isMapped() {
        return mapped;
    }

    /** Whether it asks which part is hit, and for the footprint of the ray. */
    public boolean isPicture() {
        return false;
    }

    /** Whether colours of the surface itself lie over it. */
    boolean isTinted() {
        return false;
    }

    /** As {@link #color}, where u and v of the hit may be those that another paint has left there. */
    final void ask(Level level) {
        if (mapped) {
            Objects.requireNonNull(level.part).map(level.ray.face < 0 ? ~level.ray.face : level.ray.face, level.hit);
        }
        color(level);
    }

    /** Writes the colour at the level's hit into the level, linear light. */
    public abstract void color(Level level);

    /** Says what it has at the level's hit, of which u and v are known. Changes the level's colour. */
    Told tell(Level level, String of, String kind) {
        color(level);
        return new Told(of, kind, "", 0, 0, 0, 0, 0, 0, 0, level.colorRed, level.colorGreen, level.colorBlue);
    }

    /**
     * Sets the level's slope to how much the luminance of the colours grows at the hit, a scene unit along x, y and z of the world; or along the
     * surface only, for what lies on it. Exact, but for what has edges or is a picture.
     */
    abstract void slope(Level level);

    /** The channels of colours, one after the other. */
    static double[] channels(List<Rgb> colors, boolean isLight) {
        double[] channels = new double[3 * colors.size()];
        for (int i = 0; i < colors.size(); i++) {
            Rgb color = colors.get(i);
            channels[3 * i] = isLight ? color.linearRed() : color.red() / 255;
            channels[3 * i + 1] = isLight ? color.linearGreen() : color.green() / 255;
            channels[3 * i + 2] = isLight ? color.linearBlue() : color.blue() / 255;
        }
        return channels;
    }

    static double luminance(double[] channels, int at) {
        return ColorChannel.LUMINANCE.of(channels[at], channels[at + 1], channels[at + 2]);
    }

    /** A slope in the world, of one in the space that a map leads to. */
    static void toWorld(Affine map, double x, double y, double z, double[] slope) {
        slope[0] = map.xx() * x + map.yx() * y + map.zx() * z;
        slope[1] = map.xy() * x + map.yy() * y + map.zy() * z;
        slope[2] = map.xz() * x + map.yz() * y + map.zz() * z;
    }

    private static final class Custom extends Paint {
        /** More would not be finite once it is lit. */
        private static final double BRIGHTEST = 1e20;

        /** How far on each side its slope is looked for, scene units of the space of the object. */
        private static final double STEP = 0x1p-10;

        private final CustomPattern pattern;
        private final Affine toPattern;

        Custom(CustomPattern pattern, Affine toPattern) {
            super(pattern);
            this.pattern = pattern;
            this.toPattern = toPattern;
        }

        @Override
        public void color(Level level) {
            Hit hit = level.hit;
            pattern.color(toPattern.pointX(hit.px, hit.py, hit.pz), toPattern.pointY(hit.px, hit.py, hit.pz), toPattern.pointZ(hit.px, hit.py, hit.pz), hit);
            // Also false for what is not a number.
            if (!(Math.abs(hit.red) <= BRIGHTEST && Math.abs(hit.green) <= BRIGHTEST && Math.abs(hit.blue) <= BRIGHTEST)) {
                throw new IllegalStateException("the pattern \"" + pattern.kind() + "\", which is made in code, has the colour " + hit.red + " " + hit.green + " " + hit.blue
                        + " at " + Numbers.text(new Vec3(hit.px, hit.py, hit.pz)) + " in the world; it must be of finite numbers");
            }
            level.colorRed = hit.red;
            level.colorGreen = hit.green;
            level.colorBlue = hit.blue;
        }

        @Override
        void slope(Level level) {
            double[] slope = level.slope;
            double x = beside(level, STEP, 0, 0) - beside(level, -STEP, 0, 0);
            double y = beside(level, 0, STEP, 0) - beside(level, 0, -STEP, 0);
            double z = beside(level, 0, 0, STEP) - beside(level, 0, 0, -STEP);
            toWorld(toPattern, x / (2 * STEP), y / (2 * STEP), z / (2 * STEP), slope);
        }

        private double beside(Level level, double x, double y, double z) {
            Hit hit = level.hit;
            pattern.color(toPattern.pointX(hit.px, hit.py, hit.pz) + x, toPattern.pointY(hit.px, hit.py, hit.pz) + y, toPattern.pointZ(hit.px, hit.py, hit.pz) + z, hit);
            return ColorChannel.LUMINANCE.of(hit.red, hit.green, hit.blue);
        }
    }
}
