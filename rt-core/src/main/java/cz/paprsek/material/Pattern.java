package cz.paprsek.material;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.List;
import java.util.Objects;

/** What gives a surface its colour at each point. */
public sealed interface Pattern permits Pattern.Plain, Pattern.Checkerboard, Pattern.Checker, Pattern.Gradient, Pattern.Stripes,
        Pattern.Brick, Pattern.Marble, Pattern.Wood, Pattern.Granite, Pattern.Noise, Pattern.Picture, CustomPattern {

    /** The word for its kind: that of its element in a scene file, if it has one. */
    default String kind() {
        return ElementTable.name(getClass());
    }

    /** Which colours its values from 0 to 1 have; of one of cells the even ones are 0, and the odd ones 1. */
    default Colors colors() {
        return Colors.DEFAULT;
    }

    /** Its colours, or those that all others are mixed of, the first first; empty if it does not say which it has. */
    default List<Rgb> palette() {
        return colors().stops().stream().map(Stop::color).toList();
    }

    /** Whether it goes by the place in a picture that covers the surface, u and v, rather than by the place in space. */
    default boolean isMapped() {
        return false;
    }

    /** One colour everywhere. */
    record Plain(
            @Attribute(value = Kind.COLOR, means = "sRGB, 0-255; not together with a pattern", otherwise = "255 255 255") Rgb color) implements Pattern {
        public Plain {
            Objects.requireNonNull(color, "color");
        }

        @Override
        public List<Rgb> palette() {
            return List.of(color);
        }
    }

    /**
     * A board of columns × rows squares over a rectangle or disc; the square at the minimum corner is even.
     * Columns run along the surface's x, rows along its y.
     */
    @Element("A board of columns x rows squares over a rectangle or a disc; the square at the minimum corner is even.")
    record Checkerboard(
            @Attribute(value = Kind.SQUARES, means = "Squares along x") int columns,
            @Attribute(value = Kind.SQUARES, means = "Squares along y") int rows,
            @Attribute(value = Kind.COLOR, means = "Colour of the even ones", otherwise = "255 255 255") Rgb even,
            @Attribute(value = Kind.COLOR, means = "Colour of the odd ones", otherwise = "0 0 0") Rgb odd) implements Pattern {
        public Checkerboard {
            Objects.requireNonNull(even, "even");
            Objects.requireNonNull(odd, "odd");
            check("checkerboard columns", columns, Kind.SQUARES);
            check("checkerboard rows", rows, Kind.SQUARES);
        }

        @Override
        public Colors colors() {
            return new TwoColors(even, odd);
        }

        @Override
        public boolean isMapped() {
            return true;
        }
    }

    /**
     * Boxes of alternating colour filling space, for any shape. One has its corner at {@code origin}, in the space of the object that declares the
     * material, before its placement, and that of the pattern; that one is even.
     *
     * @param size edges of a box, scene units
     */
    @Element("Cubes, or boxes, of alternating colour filling the space of the object that declares the material, before its placement.")
    record Checker(
            @Attribute(value = Kind.POSITIVE_SCALE, means = "Edge of a cube, or the three of a box") Vec3 size,
            @Attribute(value = Kind.VECTOR, means = "A corner of an even cube", otherwise = "0 0 0") Vec3 origin,
            @Attribute(value = Kind.COLOR, means = "Colour of the even ones", otherwise = "255 255 255") Rgb even,
            @Attribute(value = Kind.COLOR, means = "Colour of the odd ones", otherwise = "0 0 0") Rgb odd,
            Lay lay) implements Pattern {
        public Checker {
            checkCells(even, odd, lay);
            Require.sizes("checker size", size);
            Require.place("checker origin", origin);
        }

        /** Cubes of the given edge. */
        public Checker(double size, Vec3 origin, Rgb even, Rgb odd) {
            this(new Vec3(size, size, size), origin, even, odd, Lay.NONE);
        }

        @Override
        public Colors colors() {
            return new TwoColors(even, odd);
        }
    }

    /** From one colour to another between y = 0 and y = 1 of the pattern's own space, one colour below and above: its value is y, from 0 to 1. */
    @Element("From one colour, at y = 0, to another, at y = 1; below and above there is one colour.")
    record Gradient(Colors colors, Lay lay) implements Pattern {
        public Gradient {
            Objects.requireNonNull(colors, "colors");
            Objects.requireNonNull(lay, "lay");
        }
    }

    /**
     * Layers of two colours in turn, along x; the one that begins at 0 is even.
     *
     * @param size thickness of a layer, scene units
     */
    @Element("Layers of two colours in turn, along x; the one that begins at 0 is even.")
    record Stripes(
            @Attribute(value = Kind.POSITIVE, means = "Thickness of a layer") double size,
            @Attribute(value = Kind.COLOR, means = "Colour of the even ones", otherwise = "255 255 255") Rgb even,
            @Attribute(value = Kind.COLOR, means = "Colour of the odd ones", otherwise = "0 0 0") Rgb odd,
            Lay lay) implements Pattern {
        public Stripes {
            checkCells(even, odd, lay);
            Require.size("stripes size", size);
        }

        @Override
        public Colors colors() {
            return new TwoColors(even, odd);
        }
    }

    /**
     * A wall of bricks in courses along y, each half a brick beyond the one below, along x and along z. A brick begins at 0 and ends where mortar
     * takes up the rest of its size.
     *
     * @param size of a brick with its mortar, scene units
     * @param mortar thickness of the mortar, scene units
     */
    @Element("A wall of bricks in courses along y, each half a brick beyond the one below.")
    record Brick(
            @Attribute(value = Kind.POSITIVE_VECTOR, means = "Width, height and depth of a brick with its mortar") Vec3 size,
            @Attribute(value = Kind.NOT_NEGATIVE, means = "Thickness of the mortar", otherwise = "0.01") double mortar,
            @Attribute(value = Kind.COLOR, means = "Colour of the bricks", otherwise = "255 255 255") Rgb even,
            @Attribute(value = Kind.COLOR, means = "Colour of the mortar", otherwise = "0 0 0") Rgb odd,
            Lay lay) implements Pattern {
        public Brick {
            checkCells(even, odd, lay);
            Require.sizes("brick size", size);
            Require.sizeOrZero("brick mortar", mortar);
        }

        @Override
        public Colors colors() {
            return new TwoColors(even, odd);
        }
    }

    /**
     * Veins across x that noise bends: with t = frequency·x + turbulence·Σ noise(2ⁱp)/2ⁱ its value is 0 where t is whole, and 1 half way between,
     * linearly.
     *
     * @param frequency how many veins there are in a scene unit
     * @param turbulence how far noise moves them, in their distance
     * @param octaves how many noises, each of them half as large and half as strong as the last, are added
     * @param seed which of many noises
     */
    @Element("Veins across x that noise bends.")
    record Marble(
            @Attribute(value = Kind.POSITIVE, means = "Veins in a scene unit", otherwise = "1") double frequency,
            @Attribute(value = Kind.NOT_NEGATIVE, means = "How far noise moves them, in their distance", otherwise = "1") double turbulence,
            @Attribute(value = Kind.OCTAVES, means = "Noises added, each half as large and strong as the last", otherwise = "4") int octaves,
            @Attribute(value = Kind.SEED, means = "Which of many noises", otherwise = "0") int seed,
            Colors colors, Lay lay) implements Pattern {
        public Marble {
            Require.size("marble frequency", frequency);
            Require.sizeOrZero("marble turbulence", turbulence);
            checkNoise("marble", octaves, seed, colors, lay);
        }
    }

    /**
     * The rings of a tree about the y axis, each from 0 at its inner side to 1 at its outer one: with t = frequency·√(x² + z²) +
     * turbulence·Σ noise(2ⁱp)/2ⁱ its value is t − ⌊t⌋. Parameters as of {@link Marble}.
     */
    @Element("The rings of a tree about the y axis, each from one colour to the other.")
    record Wood(
            @Attribute(value = Kind.POSITIVE, means = "Rings in a scene unit", otherwise = "8") double frequency,
            @Attribute(value = Kind.NOT_NEGATIVE, means = "How far noise moves them, in their distance", otherwise = "0.4") double turbulence,
            @Attribute(value = Kind.OCTAVES, means = "Noises added, each half as large and strong as the last", otherwise = "2") int octaves,
            @Attribute(value = Kind.SEED, means = "Which of many noises", otherwise = "0") int seed,
            Colors colors, Lay lay) implements Pattern {
        public Wood {
            Require.size("wood frequency", frequency);
            Require.sizeOrZero("wood turbulence", turbulence);
            checkNoise("wood", octaves, seed, colors, lay);
        }
    }

    /** Grains: its value is Σ |noise(2ⁱp)|/2ⁱ, 1 at most. Parameters as of {@link Marble}. */
    @Element("Grains of all sizes, of which the largest are about 1 across.")
    record Granite(
            @Attribute(value = Kind.OCTAVES, means = "Noises added, each half as large and strong as the last", otherwise = "6") int octaves,
            @Attribute(value = Kind.SEED, means = "Which of many noises", otherwise = "0") int seed,
            Colors colors, Lay lay) implements Pattern {
        public Granite {
            checkNoise("granite", octaves, seed, colors, lay);
        }
    }

    /** Clouds: its value is ½ + ½·Σ noise(2ⁱp)/2ⁱ, from 0 to 1. Parameters as of {@link Marble}. */
    @Element("Clouds, of which the largest are about 1 across.")
    record Noise(
            @Attribute(value = Kind.OCTAVES, means = "Noises added, each half as large and strong as the last", otherwise = "4") int octaves,
            @Attribute(value = Kind.SEED, means = "Which of many noises", otherwise = "0") int seed,
            Colors colors, Lay lay) implements Pattern {
        public Noise {
            checkNoise("noise", octaves, seed, colors, lay);
        }
    }

    /**
     * A picture. It repeats beyond its edges, and v is up.
     *
     * @param file its name, relative to the scene's folder: {@code textures/oak.png}
     * @param filter what becomes of its points when it is seen from nearby or afar
     * @param mapping how it lies on the surface
     * @param lay of the picture: within the plane of u and v if the shape maps it, else in space
     */
    @Element(value = "A picture. It repeats beyond its edges.", name = "image")
    record Picture(
            @Attribute(value = Kind.FILE, means = "Its file, beside the scene's") String file,
            @Attribute(value = Kind.WORD, means = "Its nearest point, mixed of four, or the mean over what the pixel covers", otherwise = "smooth") Filter filter,
            @Attribute(value = Kind.WORD, means = "How it lies on the surface: as the shape says, or through space", otherwise = "uv") Mapping mapping,
            Lay lay) implements Pattern {
        public Picture {
            Require.that(!file.isBlank(), "image file must not be blank");
            Objects.requireNonNull(filter, "filter");
            Objects.requireNonNull(mapping, "mapping");
            Objects.requireNonNull(lay, "lay");
        }

        /** As large as the shape says, filtered by what a pixel covers. */
        public static Picture of(String file) {
            return new Picture(file, Filter.SMOOTH, Mapping.UV, Lay.NONE);
        }

        @Override
        public List<Rgb> palette() {
            return List.of();
        }
    }

    /** What becomes of a picture's points when it is seen from nearby or afar. */
    enum Filter {
        /** The nearest point. */
        NEAREST,
        /** The four nearest points, mixed linearly. */
        BILINEAR,
        /** The mean over what the pixel covers, through mirrors and glass too; mixed linearly from nearby. */
        SMOOTH
    }

    /** How a picture lies on a surface. */
    enum Mapping {
        /** As the shape says. */
        UV,
        /** Along z onto the square from 0 to 1 in x and y. */
        PLANAR,
        /** As a globe about the origin, its middle towards +z. */
        SPHERICAL,
        /** As a label around the y axis, from y = 0 to 1, its middle towards +z. */
        CYLINDER,
        /** From the side of a cube that the surface faces most, squares of 1. */
        BOX
    }

    private static void checkCells(Rgb even, Rgb odd, Lay lay) {
        Objects.requireNonNull(even, "even");
        Objects.requireNonNull(odd, "odd");
        Objects.requireNonNull(lay, "lay");
    }

    private static void checkNoise(String pattern, int octaves, int seed, Colors colors, Lay lay) {
        Objects.requireNonNull(colors, "colors");
        Objects.requireNonNull(lay, "lay");
        check(pattern + " octaves", octaves, Kind.OCTAVES);
        check(pattern + " seed", seed, Kind.SEED);
    }

    private static void check(String what, int value, Kind kind) {
        Require.within(what, value, (int) kind.least(), (int) kind.most());
    }

    /** Which colour a pattern has at each of its values from 0 to 1. */
    sealed interface Colors permits TwoColors, Stops {
        /** From white to black. */
        Colors DEFAULT = new TwoColors(Rgb.WHITE, Rgb.BLACK);

        /** All of them, from the lowest value to the highest: at least two. Between two that follow each other they are mixed linearly, in linear light. */
        List<Stop> stops();
    }

    /** One colour at 0, another at 1. */
    record TwoColors(
            @Attribute(value = Kind.COLOR, means = "Colour at 0; not together with stops", otherwise = "255 255 255") Rgb even,
            @Attribute(value = Kind.COLOR, means = "Colour at 1; not together with stops", otherwise = "0 0 0") Rgb odd) implements Colors {
        public TwoColors {
            Objects.requireNonNull(even, "even");
            Objects.requireNonNull(odd, "odd");
        }

        @Override
        public List<Stop> stops() {
            return List.of(new Stop(0, even), new Stop(1, odd));
        }
    }

    /** Colours at any values; below the first and above the last there is one colour. */
    record Stops(List<Stop> stops) implements Colors {
        /** How many there may be. */
        public static final int MOST = 256;

        /** @throws IllegalArgumentException unless there are two at least, in rising order; two at the same value are an edge */
        public Stops {
            stops = List.copyOf(stops);
            Require.that(stops.size() >= 2 && stops.size() <= MOST, "a pattern must have from 2 to " + MOST + " stops, but has " + stops.size());
            for (int i = 1; i < stops.size(); i++) {
                Require.that(stops.get(i).at() >= stops.get(i - 1).at(),
                        "stops must be in rising order, but after " + stops.get(i - 1).at() + " comes " + stops.get(i).at());
            }
        }

        public static Stops of(Stop... stops) {
            return new Stops(List.of(stops));
        }
    }

    /** A colour at one of the values of a pattern. */
    @Element("A colour at one of the values of a pattern, in place of its two colours. Between two, colours are mixed linearly.")
    record Stop(
            @Attribute(value = Kind.SHARE, means = "Where it is, from 0 to 1") double at,
            @Attribute(value = Kind.COLOR, means = "The colour there") Rgb color) {
        public Stop {
            Require.within("stop at", at, 0, 1);
            Objects.requireNonNull(color, "color");
        }
    }

    /**
     * Where a pattern stands in the space of the object that declares the material, before its placement: scaled, then rotated, then moved.
     *
     * @param position where the pattern's own origin goes, scene units
     * @param rotation degrees about x, then y, then z, each counter-clockwise seen from the positive end of its axis
     * @param scale factor along each of the pattern's own axes; not 0, negative mirrors
     */
    record Lay(
            @Attribute(value = Kind.VECTOR, means = "Where the pattern's own origin goes", otherwise = "0 0 0") Vec3 position,
            @Attribute(value = Kind.ROTATION, means = "Turns the pattern: degrees about x, then y, then z", otherwise = "0 0 0") Vec3 rotation,
            @Attribute(value = Kind.SCALE, means = "Makes the pattern larger; applied before the rotation", otherwise = "1") Vec3 scale) {
        public static final Lay NONE = new Lay(Vec3.ZERO, Vec3.ZERO, Vec3.ONE);

        /** @throws IllegalArgumentException if a scale is 0, or a number is out of all proportion ({@link Require#LARGEST}) */
        public Lay {
            Objects.requireNonNull(rotation, "rotation");
            Require.place("position", position);
            Require.scale(scale);
        }

        /** So many times as large. */
        public static Lay scaled(double factor) {
            return NONE.withScale(new Vec3(factor, factor, factor));
        }

        public Lay withPosition(Vec3 value) {
            return new Lay(value, rotation, scale);
        }

        public Lay withRotation(Vec3 degrees) {
            return new Lay(position, degrees, scale);
        }

        public Lay withScale(Vec3 value) {
            return new Lay(position, rotation, value);
        }

        /** The map from the pattern's own space to the space around it. */
        public Affine toParent() {
            Affine turn = rotation.equals(Vec3.ZERO) ? Affine.IDENTITY : Affine.rotation(rotation);
            return Affine.translation(position).after(turn).after(Affine.scaling(scale));
        }
    }
}
