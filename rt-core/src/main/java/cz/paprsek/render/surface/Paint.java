package cz.paprsek.render.surface;

import cz.paprsek.material.CustomPattern;
import cz.paprsek.material.Pattern;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.text.Numbers;

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
     */
    static Paint of(Pattern pattern, Affine toDeclared, Textures textures) {
        if (pattern instanceof Pattern.Plain plain) {
            return new TwoColors.Plain(plain);
        } else if (pattern instanceof Pattern.Checkerboard board) {
            return new TwoColors.Board(board);
        } else if (pattern instanceof Pattern.Checker checker) {
            return new TwoColors.Cubes(checker, toDeclared);
        } else if (pattern instanceof Pattern.Stripes stripes) {
            return new TwoColors.Layers(stripes, toDeclared);
        } else if (pattern instanceof Pattern.Brick brick) {
            return new TwoColors.Bricks(brick, toDeclared);
        }
        if (pattern instanceof Pattern.Picture picture) {
            return new PicturePaint(picture, toDeclared, textures.texture(picture.file(), true));
        }
        return pattern instanceof CustomPattern custom ? new Custom(custom, toDeclared) : new MixedColors(pattern, toDeclared);
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

    /** Writes the colour at the level's hit into the level, linear light. */
    public abstract void color(Level level);

    private static final class Custom extends Paint {
        /** More would not be finite once it is lit. */
        private static final double BRIGHTEST = 1e20;

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
    }
}
