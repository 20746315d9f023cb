package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.font.Font;
import cz.paprsek.shape.font.Fonts;
import cz.paprsek.shape.font.Letters;
import cz.paprsek.shape.font.Letters.Letter;
import cz.paprsek.shape.outline.Extruded;
import cz.paprsek.shape.outline.Outline;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Letters in the plane z = 0 made thick, up to z = depth. The first one begins at the origin and stands on y = 0; further lines lie below. Curves are
 * met exactly. A font that is shipped is there at once; that of a file is not before somebody has {@linkplain #read read} it, as with a {@link Mesh}.
 *
 * @param value what is written, of 1 to 1000 characters; a line ends where it has a line feed
 * @param font one of those that are shipped, {@code sans}, {@code sans-bold} and {@code serif}, or the name of a TrueType file, relative to the scene's folder
 * @param size of the em, scene units: capitals are about 0.73 times as high
 * @param depth how thick, scene units
 * @param content the letters
 */
@Element("Letters in the plane z = 0 made thick, from there towards +z; the first one begins at the origin and stands on y = 0.")
public record Text(
        @Attribute(value = Kind.LETTERS, means = "What is written; a line ends at &#10;", example = "Text") String value,
        @Attribute(value = Kind.FONT, means = "One that is shipped: sans, sans-bold or serif; or a TrueType file beside the scene's file", otherwise = Text.USUAL_FONT) String font,
        @Attribute(value = Kind.POSITIVE, means = "Above 0; capitals are about 0.73 times as high", otherwise = "1", example = "0.5") double size,
        @Attribute(value = Kind.POSITIVE, means = "How thick; above 0", otherwise = "0.2", example = "0.1") double depth,
        Content content) implements Solid {
    /** The font if none is named. */
    public static final String USUAL_FONT = "sans";
    /** Those that are shipped. */
    public static final List<String> FONTS = Fonts.NAMES;
    private static final int MOST_LETTERS = 1000;

    public Text {
        Objects.requireNonNull(value, "value");
        Objects.requireNonNull(font, "font");
        Objects.requireNonNull(content, "content");
        Require.that(!value.isBlank(), "text value must not be blank");
        Require.that(value.length() <= MOST_LETTERS, "text value must be of 1 to " + MOST_LETTERS + " characters, but has " + value.length());
        Require.that(!font.isBlank(), "text font must not be blank");
        Require.size("text size", size);
        Require.size("text depth", depth);
        content = content.of(font, value, size);
    }

    /** In the usual font. */
    public static Text of(String value, double size, double depth) {
        return new Text(value, USUAL_FONT, size, depth, Content.UNREAD);
    }

    /** The name of the file that its font lies in; empty if it is shipped. */
    public Optional<String> file() {
        return Fonts.shipped(font).isPresent() ? Optional.empty() : Optional.of(font);
    }

    /**
     * With the letters of its font.
     *
     * @param bytes what is in its file
     * @throws IllegalArgumentException with a sentence if that is no TrueType font, is broken, or has not all of the letters
     */
    public Text read(byte[] bytes) {
        return new Text(value, font, size, depth, Content.of(font, new Font(bytes), value, size));
    }

    /** Whether its letters are there. */
    public boolean isRead() {
        return content.letters != null;
    }

    /**
     * Its letters, those that show anything.
     *
     * @throws IllegalStateException if they have not been {@linkplain #isRead read}
     */
    private List<Letter> letters() {
        Letters known = content.letters;
        if (known == null) {
            throw new IllegalStateException("the font of a text has not been read");
        }
        return known.all();
    }

    @Override
    public Face face(int number) {
        return number >= Extruded.FIRST_SIDE ? Face.SIDE : number == Extruded.BOTTOM ? Face.MINUS_Z : Face.PLUS_Z;
    }

    private Bounds box(Outline outline) {
        return new Bounds(outline.minX(), outline.minY(), 0, outline.maxX(), outline.maxY(), depth);
    }

    @Override
    public Bounds bounds() {
        return isRead() ? letters().stream().map(letter -> box(letter.outline()).transformed(letter.toText())).reduce(Bounds::union).orElseThrow() : Bounds.EMPTY;
    }

    /** Of each letter both ends, and edges from one to the other. */
    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        List<Curve> curves = new ArrayList<>();
        for (List<Vec3> rim : isRead() ? polygons(size / steps) : List.<List<Vec3>>of()) {
            curves.add(new Curve(rim));
            curves.add(new Curve(rim.stream().map(this::behind).toList()));
            for (int i = 0; i + 1 < rim.size(); i += Math.max(1, rim.size() / 8)) {
                curves.add(Curve.through(rim.get(i), behind(rim.get(i))));
            }
        }
        return curves;
    }

    /** The contours of all letters as closed polygons, curves not farther from them than this. */
    private List<List<Vec3>> polygons(double tolerance) {
        return letters().stream().flatMap(letter -> letter.outline().polygons(tolerance / letter.toText().direction(Vec3.X).length()).stream()
                .map(polygon -> polygon.stream().map(letter.toText()::point).toList())).toList();
    }

    /**
     * The contours of all letters as cubic Bézier curves in the plane z = 0, four points each, those of one contour after the other.
     *
     * @throws IllegalStateException if the letters have not been read
     */
    public List<Vec3> curves() {
        return letters().stream().flatMap(letter -> letter.outline().curves().stream().map(letter.toText()::point)).toList();
    }

    private Vec3 behind(Vec3 point) {
        return point.plus(new Vec3(0, 0, depth));
    }

    /** @throws IllegalStateException if the letters have not been read */
    @Override
    public Volume place(Affine toWorld, Parts parts) {
        List<Volume> placed = new ArrayList<>();
        for (Letter letter : letters()) {
            placed.add(parts.add(part -> new Extruded(part, toWorld.after(letter.toText()), box(letter.outline()), letter.outline(), depth, 0, 1)));
        }
        return Csg.together(placed, parts);
    }

    /** The letters of one text. Those of files are told apart by the names of these alone. */
    public static final class Content {
        /** Nothing has been read yet. */
        public static final Content UNREAD = new Content("", null, "", 0, null);

        private final String name;
        private final @Nullable Font font;
        private final String value;
        private final double size;
        private final @Nullable Letters letters;

        private Content(String name, @Nullable Font font, String value, double size, @Nullable Letters letters) {
            this.name = name;
            this.font = font;
            this.value = value;
            this.size = size;
            this.letters = letters;
        }

        private static Content of(String name, Font font, String value, double size) {
            try {
                return new Content(name, font, value, size, new Letters(font, value, size));
            } catch (IllegalArgumentException refused) {
                throw new IllegalArgumentException("text value must have letters of the font \"" + name + "\", but " + refused.getMessage(), refused);
            }
        }

        private Content of(String itsFont, String itsValue, double itsSize) {
            Font known = name.equals(itsFont) ? font : Fonts.shipped(itsFont).orElse(null);
            return known == null ? UNREAD : known == font && value.equals(itsValue) && size == itsSize ? this : of(itsFont, known, itsValue, itsSize);
        }

        @Override
        public boolean equals(@Nullable Object other) {
            return other instanceof Content;
        }

        @Override
        public int hashCode() {
            return 1;
        }

        @Override
        public String toString() {
            return letters == null ? "not read" : letters.all().size() + " letters";
        }
    }
}
