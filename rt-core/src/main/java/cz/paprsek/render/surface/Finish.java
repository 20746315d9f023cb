package cz.paprsek.render.surface;

import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Pattern;
import cz.paprsek.math.Affine;
import cz.paprsek.render.lanes.Lanes;
import cz.paprsek.render.texture.Textures;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A material ready for shading: never changed, but for that of a level, which says what it is at one point. */
public final class Finish {
    /** From this α on a lobe is wide, about as the lamps of a room. */
    private static final double WIDE = 0.08;

    public Material material = Material.DEFAULT;
    public Paint paint = new TwoColors.Plain((Pattern.Plain) material.pattern(), true);
    public double diffusion;
    public double specular;
    /** The share of light that the highlight sends on, about: all of it, where no part of it is below the surface. */
    public double highlights;
    public double reflection;
    public double transparency;
    public double refractiveIndex;
    public Fresnel fresnel = Fresnel.FALSE;
    /** How far facets are spread; 0 if it is smooth. */
    public double alpha;
    /**
     * Whether lights that rays can see are looked for all the same, and then not seen by the rays it sends: a wide lobe seldom meets a small lamp,
     * a narrow one is seldom met by a point of a large one.
     */
    public boolean looksForLamps;
    public boolean isThin;
    /** Whether it mirrors and lets through the same shares at every angle: nearly all surfaces do, and are shaded by a shorter way. */
    public boolean isPlain;
    /** Whether nothing but the colour differs from point to point, and nothing bends the normals: of all others, {@link #at} says what there is at one. */
    public boolean isEven;
    /** Whether it gives off light of its own: {@link #red} and so on, linear. */
    public boolean glows;
    public double red;
    public double green;
    public double blue;
    private double roughness;
    private double shininess;
    /** The exponent if it is a whole number, else −1. */
    private int wholeShininess;
    private Variety variety = Variety.NONE;

    /** For a level. */
    Finish() {}

    /** @param toDeclared from the world to the space of the object that declares the material */
    Finish(Material material, Affine toDeclared, Textures textures) {
        this(material, toDeclared, textures, false);
    }

    /** @param isTinted whether colours of the surface itself lie over it */
    Finish(Material material, Affine toDeclared, Textures textures, boolean isTinted) {
        this.material = material;
        Paint own = Paint.of(material.pattern(), toDeclared, textures, true);
        paint = isTinted ? new TintedPaint(material.pattern(), own) : own;
        variety = Variety.of(material, toDeclared, textures);
        isEven = variety.isNone();
        diffusion = material.diffusion();
        specular = material.specular();
        shininess = material.shininess();
        wholeShininess = shininess == Math.rint(shininess) ? (int) shininess : -1;
        highlights = 2 * specular / (shininess + 1);
        reflection = material.reflection();
        transparency = material.transparency();
        refractiveIndex = material.refractiveIndex();
        fresnel = material.fresnel();
        rough(material.roughness());
        isThin = material.thin();
        isPlain = fresnel == Fresnel.FALSE && alpha == 0 && !isThin;
        red = material.emission().linearRed() * material.emissionStrength();
        green = material.emission().linearGreen() * material.emissionStrength();
        blue = material.emission().linearBlue() * material.emissionStrength();
        glows = red > 0 || green > 0 || blue > 0;
    }

    private void rough(double value) {
        roughness = value;
        alpha = value * value;
        looksForLamps = alpha >= WIDE;
    }

    /**
     * What it is at the level's hit: there the colour is set, and the normal bent that light is reckoned with. The part that is hit and the
     * footprint are known. Shares that depend on the point are, before, the greatest there are.
     */
    public Finish at(Level level) {
        Finish own = level.own;
        own.become(this);
        if (variety.hasShares()) {
            own.diffusion = variety.diffusion().share(level, diffusion);
            own.specular = variety.specular().share(level, specular);
            own.highlights = 2 * own.specular / (shininess + 1);
            own.reflection = variety.reflection().share(level, reflection);
            own.transparency = variety.transparency().share(level, transparency);
            own.rough(variety.roughness().share(level, material.roughness()));
        }
        variety.bending().bend(level);
        paint.ask(level);
        return own;
    }

    /** The share of light that is let through at the level's hit, of which only the place and the part are known. */
    public double transparencyAt(Level level) {
        return variety.transparency().share(level, transparency);
    }

    /** Whether it lets through different shares of light at different points. */
    public boolean isVeil() {
        return variety.transparency().isByPattern();
    }

    /** The material as it is at the level's hit, after {@link #at}: its shares are numbers. */
    public Material here(Level level) {
        Finish own = level.own;
        return isEven ? material : material.withShares(Material.Shares.EVEN).withDiffusion(own.diffusion).withHighlight(own.specular, material.shininess())
                .withReflection(own.reflection).withTransparency(own.transparency, material.refractiveIndex()).withRoughness(own.roughness);
    }

    /** Says what the patterns have at the level's hit, whose normals have been turned to the viewer and whose u and v are those of the shape; changes these two. */
    public List<Told> tell(Level level) {
        List<Told> told = new ArrayList<>();
        double colorRed = level.colorRed;
        double colorGreen = level.colorGreen;
        double colorBlue = level.colorBlue;
        if (level.leaving) {
            level.hit.turn();
        }
        if (!(material.pattern() instanceof Pattern.Plain) || paint.isTinted()) {
            told.add(paint.tell(level, "color", material.pattern().kind()));
        }
        variety.tell(level, material.shares(), told);
        if (level.leaving) {
            level.hit.turn();
        }
        level.colorRed = colorRed;
        level.colorGreen = colorGreen;
        level.colorBlue = colorBlue;
        return told;
    }

    private void become(Finish other) {
        material = other.material;
        paint = other.paint;
        diffusion = other.diffusion;
        specular = other.specular;
        highlights = other.highlights;
        reflection = other.reflection;
        transparency = other.transparency;
        refractiveIndex = other.refractiveIndex;
        fresnel = other.fresnel;
        roughness = other.roughness;
        alpha = other.alpha;
        looksForLamps = other.looksForLamps;
        isThin = other.isThin;
        isPlain = other.isPlain;
        glows = other.glows;
        red = other.red;
        green = other.green;
        blue = other.blue;
        shininess = other.shininess;
        wholeShininess = other.wholeShininess;
    }

    /** Whether rays that meet it must know which part they meet, and their footprint. */
    boolean asksForPlace() {
        return paint.isPicture() || !isEven;
    }

    /** Whether what is made of a material depends on where in space that is declared. */
    static boolean isPlaced(Material material) {
        return !(material.relief() instanceof Material.Flat) || Paint.isPlaced(material.pattern())
                || (!material.shares().isEven() && material.patterns().anyMatch(Paint::isPlaced));
    }

    /** Whether light that falls on it shows: if not, no shadow ray is needed. */
    public boolean isLit() {
        return diffusion > 0 || specular > 0 || alpha > 0;
    }

    /**
     * kS · max(0, cos)ⁿ. Whole exponents by squaring, which is fast and rounds alike on every JDK; {@link Math#pow} need not.
     *
     * @param cosine of the angle between the mirrored eye ray and the light
     */
    public double highlight(double cosine) {
        if (!(cosine > 0) || specular == 0) {
            return 0;
        }
        if (wholeShininess < 0) {
            return specular * StrictMath.pow(cosine, shininess);
        }
        double result = specular;
        double factor = cosine;
        for (int n = wholeShininess; n > 0; n >>= 1) {
            if ((n & 1) != 0) {
                result *= factor;
            }
            factor *= factor;
        }
        return result;
    }

    /**
     * The same of many at once, in plain loops.
     *
     * @param cosines of the first so many; they are changed, but for those that are not numbers
     * @param results receives as many; of what is not a number, that
     */
    public void highlights(double[] cosines, double[] results, int count) {
        if (wholeShininess <= 0 || specular == 0) {
            for (int i = 0; i < count; i++) {
                results[i] = highlight(cosines[i]);
            }
            return;
        }
        Arrays.fill(results, 0, count, specular);
        for (int i = 0; i < count; i++) {
            cosines[i] = Math.max(0, cosines[i]);
        }
        for (int n = wholeShininess; n > 0; n >>= 1) {
            if ((n & 1) != 0) {
                Lanes.multiply(results, cosines, count);
            }
            Lanes.multiply(cosines, cosines, count);
        }
    }
}
