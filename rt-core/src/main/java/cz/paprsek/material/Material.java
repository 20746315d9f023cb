package cz.paprsek.material;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.material.Share.Even;
import cz.paprsek.math.Require;
import cz.paprsek.text.Numbers;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * How a surface answers light.
 *
 * @param pattern its colour C at each point
 * @param diffusion share of diffusely reflected light kD, 0–1
 * @param specular strength of the highlight kS, 0–1; the highlight has the light's colour
 * @param shininess exponent n of the highlight, 0–1 000 000; the higher, the smaller and sharper
 * @param reflection share of mirrored light kR, 0–1
 * @param transparency share of transmitted light kT, 0–1
 * @param refractiveIndex index of the medium inside relative to the vacuum, above 0 and at most 100
 * @param fresnel how what is mirrored and what is let through depends on the angle
 * @param roughness 0–1: what is mirrored and let through is strewn by facets with α = roughness², whose normals are spread as GGX has it; 0 is smooth
 * @param thin whether a body is a wall without thickness around what is outside: it bends nothing, absorbs nothing, and mirrors on both sides at once
 * @param attenuationColor the colour c, in linear light, of the substance inside: on its way d through it light is weakened to exp(−(1 − c)·d/D) of what it was, by
 *     the law of Bouguer, Lambert and Beer; white does not weaken it
 * @param attenuationDistance D, above 0, scene units
 * @param emission colour of the light that the surface gives off to both sides, the same in all directions
 * @param emissionStrength what that is multiplied by, at least 0
 * @param shares those of the shares that differ from point to point: of these, the number above is the greatest there is
 * @param relief bumps and dents that light sees, though the surface is smooth
 */
@Element("How a surface answers light. A pattern inside takes the place of the colour, and one in an element of the name of a share that of this share.")
public record Material(
        Pattern pattern,
        @Attribute(value = Kind.SHARE, means = "Share of diffusely reflected light", otherwise = "0.8") double diffusion,
        @Attribute(value = Kind.SHARE, means = "Strength of the highlight", otherwise = "0") double specular,
        @Attribute(value = Kind.EXPONENT, inForce = "hasHighlight", means = "Exponent of the highlight", otherwise = "30") double shininess,
        @Attribute(value = Kind.SHARE, means = "Share of mirrored light", otherwise = "0") double reflection,
        @Attribute(value = Kind.SHARE, means = "Share of transmitted light", otherwise = "0") double transparency,
        @Attribute(value = Kind.REFRACTIVE_INDEX, inForce = "hasIndex", means = "Index of the medium inside", otherwise = "1") double refractiveIndex,
        @Attribute(value = Kind.WORD, means = "How reflection depends on the angle: not, as that of glass or water, as that of metals", otherwise = "false") Fresnel fresnel,
        @Attribute(value = Kind.SHARE, means = "How far what is mirrored and let through is strewn", otherwise = "0") double roughness,
        @Attribute(value = Kind.FLAG, means = "A wall without thickness, around what is outside", otherwise = "false") boolean thin,
        @Attribute(value = Kind.COLOR, inForce = "absorbs", means = "What the substance inside leaves of light, white being all", otherwise = "255 255 255") Rgb attenuationColor,
        @Attribute(value = Kind.POSITIVE, inForce = "absorbs", means = "Depth that the attenuation-color is stated for", otherwise = "1") double attenuationDistance,
        @Attribute(value = Kind.COLOR, inForce = "shines", means = "Light of its own", otherwise = "0 0 0") Rgb emission,
        @Attribute(value = Kind.INTENSITY, inForce = "shines", means = "Factor of the emission", otherwise = "1") double emissionStrength,
        Shares shares,
        Relief relief)
        implements MaterialSource {

    /** Matte white: what an object without a material is made of. */
    public static final Material DEFAULT = new Material(new Pattern.Plain(Rgb.WHITE), 0.8, 0, 30, 0, 0, 1);

    /** How reflection depends on the angle θ between the ray and the normal. */
    public enum Fresnel {
        /** Not at all. */
        FALSE,
        /**
         * As of surfaces that do not conduct: of the share R = ½((n₁·cos θ₁ − n₂·cos θ₂)/(n₁·cos θ₁ + n₂·cos θ₂))² + ½((n₁·cos θ₂ − n₂·cos θ₁)/(n₁·cos θ₂ +
         * n₂·cos θ₁))², kR·R is mirrored, kT·(1 − kR·R) let through; and kR + kT·(1 − kR) mirrored where no light is let through.
         *
         * @source Fresnel, Mémoire sur la loi des modifications que la réflexion imprime à la lumière polarisée, 1823, for light of no polarisation
         */
        TRUE,
        /**
         * As of metals of colour C: kR·(C + (1 − C)·(1 − cos θ)⁵) is mirrored.
         *
         * @source Schlick, An Inexpensive BRDF Model for Physically-based Rendering, Computer Graphics Forum 13(3), 1994
         */
        METAL
    }

    /** @throws IllegalArgumentException if a number is outside its range */
    public Material {
        Objects.requireNonNull(pattern, "pattern");
        Require.within("diffusion", diffusion, 0, 1);
        Require.within("specular", specular, 0, 1);
        Require.within("shininess", shininess, 0, 1e6);
        Require.within("reflection", reflection, 0, 1);
        Require.within("transparency", transparency, 0, 1);
        Require.positive("refractive-index", refractiveIndex);
        Require.within("refractive-index", refractiveIndex, 0, 100);
        Objects.requireNonNull(fresnel, "fresnel");
        Require.within("roughness", roughness, 0, 1);
        Objects.requireNonNull(attenuationColor, "attenuation-color");
        Require.size("attenuation-distance", attenuationDistance);
        Objects.requireNonNull(emission, "emission");
        Require.within("emission-strength", emissionStrength, 0, Kind.INTENSITY.most());
        Objects.requireNonNull(shares, "shares");
        diffusion = shares.diffusion().most(diffusion);
        specular = shares.specular().most(specular);
        reflection = shares.reflection().most(reflection);
        transparency = shares.transparency().most(transparency);
        roughness = shares.roughness().most(roughness);
        Objects.requireNonNull(relief, "relief");
    }

    /** A material that neither glows nor absorbs, and whose reflection does not depend on the angle. */
    public Material(Pattern pattern, double diffusion, double specular, double shininess, double reflection, double transparency, double refractiveIndex) {
        this(pattern, diffusion, specular, shininess, reflection, transparency, refractiveIndex, Fresnel.FALSE, 0, false, Rgb.WHITE, 1, Rgb.BLACK, 1, Shares.EVEN, Relief.FLAT);
    }

    public boolean hasHighlight() {
        return specular > 0;
    }

    /** Whether its refractive index matters: where light goes in, or is mirrored by the angle as of what does not conduct. */
    public boolean hasIndex() {
        return transparency > 0 || fresnel == Fresnel.TRUE;
    }

    /** Whether the substance inside weakens light. */
    public boolean absorbs() {
        return transparency > 0 && !thin && !attenuationColor.equals(Rgb.WHITE);
    }

    /** Whether it gives off light. */
    public boolean shines() {
        return emissionStrength > 0 && !emission.equals(Rgb.BLACK);
    }

    /** What says a share point by point, by the name of its attribute; nothing of one that is the same everywhere, or of what is no share. */
    public Optional<ByPattern> byPattern(String attribute) {
        Objects.requireNonNull(attribute, "attribute");
        return !shares.isEven() && Described.values(shares).get(attribute) instanceof ByPattern by ? Optional.of(by) : Optional.empty();
    }

    /** Of all that may have thousands of values, without the method Java makes of records. */
    @Override
    public int hashCode() {
        double[] numbers = {diffusion, specular, shininess, reflection, transparency, refractiveIndex, roughness, attenuationDistance, emissionStrength};
        int colors = 31 * (31 * (pattern instanceof Pattern.Plain plain ? plain.color() : pattern).hashCode() + attenuationColor.hashCode()) + emission.hashCode();
        return 31 * (31 * (31 * Arrays.hashCode(numbers) + colors) + (shares.isEven() ? 0 : shares.hashCode())) + (relief instanceof Flat ? 0 : relief.hashCode());
    }

    /** The names of the pictures it needs. */
    public List<String> files() {
        if (pattern instanceof Pattern.Plain && relief instanceof Flat && shares.isEven()) {
            return List.of();
        }
        Stream<String> own = relief instanceof NormalMap map ? Stream.of(map.file()) : Stream.of();
        return Stream.concat(patterns().filter(Pattern.Picture.class::isInstance).map(one -> ((Pattern.Picture) one).file()), own).distinct().toList();
    }

    /** All patterns that it has: that of the colour first. */
    public Stream<Pattern> patterns() {
        if (shares.isEven() && !(relief instanceof Bump)) {
            return Stream.of(pattern);
        }
        return Stream.of(Stream.of(pattern), shares.all().flatMap(share -> share instanceof ByPattern by ? Stream.of(by.pattern()) : Stream.of()),
                relief instanceof Bump bump ? Stream.of(bump.pattern()) : Stream.<Pattern>of()).flatMap(some -> some);
    }

    /** How shares depend on the point, by the name of the share. */
    public record Shares(Share diffusion, Share specular, Share reflection, Share transparency, Share roughness) {
        /** All the same everywhere. */
        public static final Shares EVEN = new Shares(new Even(), new Even(), new Even(), new Even(), new Even());

        public Shares {
            Objects.requireNonNull(diffusion, "diffusion");
            Objects.requireNonNull(specular, "specular");
            Objects.requireNonNull(reflection, "reflection");
            Objects.requireNonNull(transparency, "transparency");
            Objects.requireNonNull(roughness, "roughness");
        }

        /** Whether they are {@link #EVEN}: asked of each object, of which there may be millions. */
        public boolean isEven() {
            return diffusion instanceof Even && specular instanceof Even && reflection instanceof Even && transparency instanceof Even && roughness instanceof Even;
        }

        /** In the order of the components. */
        public Stream<Share> all() {
            return Stream.of(diffusion, specular, reflection, transparency, roughness);
        }
    }

    /** Bumps and dents that light sees, though the surface is smooth: they bend the normal that light is reckoned with, and nothing else. */
    public sealed interface Relief permits Flat, Bump, NormalMap {
        /** None. */
        Relief FLAT = new Flat();
    }

    /** No bumps. */
    public record Flat() implements Relief {}

    /**
     * As high as a pattern is bright: its luminance h, of numbers and not of light, is the height. The normal N becomes N − s·∇h, of the part of ∇h along the surface.
     *
     * @param strength s, how high white is above black, scene units, in the space of the object that declares the material, before its placement; dents if it is negative
     * @param pattern not of one colour
     * @source Blinn, Simulation of Wrinkled Surfaces, SIGGRAPH 1978
     */
    @Element("Bumps, as high as the pattern inside is bright.")
    public record Bump(
            @Attribute(value = Kind.NUMBER, means = "How high white is above black, before the placement of the object", otherwise = "0.02") double strength,
            Pattern pattern) implements Relief {
        /** @throws IllegalArgumentException if the pattern has one colour only, or the strength is out of all proportion */
        public Bump {
            Require.that(Math.abs(strength) <= Require.LARGEST, "bump strength must be a finite number, at most " + Numbers.text(Require.LARGEST) + ", but is " + Numbers.text(strength));
            varied(pattern);
        }
    }

    /**
     * Normals as the points of a picture say, red, green and blue being (1 + x)/2, (1 + y)/2 and (1 + z)/2: x along u, y along v, which is up (as OpenGL has it), z out of the
     * surface.
     *
     * @param file as of {@link Pattern.Picture}, and so are the others
     * @param strength what x and y are multiplied by
     */
    @Element("Normals by the points of a picture, whose red, green and blue are x along u, y along v, which is up (as OpenGL has it), and z out of the surface.")
    public record NormalMap(
            @Attribute(value = Kind.FILE, means = "Its file, beside the scene's") String file,
            @Attribute(value = Kind.NUMBER, means = "What x and y are multiplied by", otherwise = "1") double strength,
            @Attribute(value = Kind.WORD, means = "Its nearest point, mixed of four, or the mean over what the pixel covers", otherwise = "smooth") Pattern.Filter filter,
            @Attribute(value = Kind.WORD, means = "How it lies on the surface: as the shape says, or through space", otherwise = "uv") Pattern.Mapping mapping,
            Pattern.Lay lay) implements Relief {
        public NormalMap {
            Require.that(!file.isBlank(), "normal-map file must not be blank");
            Require.that(Math.abs(strength) <= Require.LARGEST, "normal-map strength must be a finite number, at most " + Numbers.text(Require.LARGEST) + ", but is " + Numbers.text(strength));
            Objects.requireNonNull(filter, "filter");
            Objects.requireNonNull(mapping, "mapping");
            Objects.requireNonNull(lay, "lay");
        }

        /** As large as the shape says. */
        public static NormalMap of(String file) {
            return new NormalMap(file, 1, Pattern.Filter.SMOOTH, Pattern.Mapping.UV, Pattern.Lay.NONE);
        }
    }

    /** Refuses one colour where several are needed. */
    static void varied(Pattern pattern) {
        Objects.requireNonNull(pattern, "pattern");
        Require.that(!(pattern instanceof Pattern.Plain), "bumps and shares need a pattern of several colours, but here is one colour");
    }

    /**
     * The materials that every scene knows by name, unless it has one of its own of that name: glass and stones, metals, what is coated or matte,
     * patterns. Bodies are taken to be about 1 across. Cannot be changed.
     */
    public static Map<String, Material> ready() {
        return ReadyMaterials.byName();
    }

    /** The default material in a colour of sRGB channels 0–255. */
    public static Material color(double red, double green, double blue) {
        return color(new Rgb(red, green, blue));
    }

    /** The default material in a colour. */
    public static Material color(Rgb color) {
        return DEFAULT.withPattern(new Pattern.Plain(color));
    }

    public Material withPattern(Pattern value) {
        return with(it -> it.pattern = value);
    }

    /** With the given share of diffusely reflected light everywhere. */
    public Material withDiffusion(double value) {
        return with(it -> {
            it.diffusion = value;
            it.shares = new Shares(new Even(), it.shares.specular(), it.shares.reflection(), it.shares.transparency(), it.shares.roughness());
        });
    }

    /** With a highlight of the given strength, everywhere, and exponent. */
    public Material withHighlight(double strength, double exponent) {
        return with(it -> {
            it.specular = strength;
            it.shininess = exponent;
            it.shares = new Shares(it.shares.diffusion(), new Even(), it.shares.reflection(), it.shares.transparency(), it.shares.roughness());
        });
    }

    /** Mirroring the given share of light everywhere. */
    public Material withReflection(double value) {
        return with(it -> {
            it.reflection = value;
            it.shares = new Shares(it.shares.diffusion(), it.shares.specular(), new Even(), it.shares.transparency(), it.shares.roughness());
        });
    }

    /** Letting the given share of light through everywhere, bent by the given refractive index. */
    public Material withTransparency(double share, double index) {
        return with(it -> {
            it.transparency = share;
            it.refractiveIndex = index;
            it.shares = new Shares(it.shares.diffusion(), it.shares.specular(), it.shares.reflection(), new Even(), it.shares.roughness());
        });
    }

    public Material withFresnel(Fresnel value) {
        return with(it -> it.fresnel = value);
    }

    /** Strewing what it mirrors and lets through, alike everywhere. */
    public Material withRoughness(double value) {
        return with(it -> {
            it.roughness = value;
            it.shares = new Shares(it.shares.diffusion(), it.shares.specular(), it.shares.reflection(), it.shares.transparency(), new Even());
        });
    }

    /** With shares that depend on the point; those that do not stay as they are. */
    public Material withShares(Shares value) {
        return with(it -> it.shares = value);
    }

    /** With bumps. */
    public Material withRelief(Relief value) {
        return with(it -> it.relief = value);
    }

    public Material withThin(boolean value) {
        return with(it -> it.thin = value);
    }

    /** Weakening light inside: to exp(c − 1) of what it was, c being the colour in linear light, after each distance. */
    public Material withAttenuation(Rgb color, double distance) {
        return with(it -> {
            it.attenuationColor = color;
            it.attenuationDistance = distance;
        });
    }

    /** Giving off light of its own. */
    public Material withEmission(Rgb color, double strength) {
        return with(it -> {
            it.emission = color;
            it.emissionStrength = strength;
        });
    }

    private Material with(Consumer<Parts> change) {
        Parts parts = new Parts(this);
        change.accept(parts);
        return parts.together();
    }

    /** What a material is made of while it is being changed. */
    private static final class Parts {
        private Pattern pattern;
        private double diffusion;
        private double specular;
        private double shininess;
        private double reflection;
        private double transparency;
        private double refractiveIndex;
        private Fresnel fresnel;
        private double roughness;
        private boolean thin;
        private Rgb attenuationColor;
        private double attenuationDistance;
        private Rgb emission;
        private double emissionStrength;
        private Shares shares;
        private Relief relief;

        Parts(Material of) {
            pattern = of.pattern;
            diffusion = of.diffusion;
            specular = of.specular;
            shininess = of.shininess;
            reflection = of.reflection;
            transparency = of.transparency;
            refractiveIndex = of.refractiveIndex;
            fresnel = of.fresnel;
            roughness = of.roughness;
            thin = of.thin;
            attenuationColor = of.attenuationColor;
            attenuationDistance = of.attenuationDistance;
            emission = of.emission;
            emissionStrength = of.emissionStrength;
            shares = of.shares;
            relief = of.relief;
        }

        Material together() {
            return new Material(pattern, diffusion, specular, shininess, reflection, transparency, refractiveIndex, fresnel,
                    roughness, thin, attenuationColor, attenuationDistance, emission, emissionStrength, shares, relief);
        }
    }
}
