package cz.paprsek.shape.height;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Relief by a picture, as a solid that stands on y = 0 with its middle over the origin: black is 0, white as high as it can be, numbers as they stand in
 * the file. Between the points there are flat triangles, two in each square of four neighbours; the upper rim of the picture lies at −z. The heights of a
 * file are not there before somebody has {@linkplain #read read} it, as with a {@link cz.paprsek.shape.Mesh}.
 *
 * @param file of the picture, relative to the scene's folder; empty if heights were made in code
 * @param extent along x, from black to white, and along z, scene units
 * @param smooth whether light is reckoned as if it were round
 * @param content the heights
 */
@Element("Relief by a grey picture, standing on y = 0 with its middle over the origin: black is 0 high, white as high as it can be.")
public record HeightField(
        @Attribute(value = Kind.FILE, means = "The picture, beside the scene's file, of 2 x 2 points or more; its upper rim lies at -z") String file,
        @Attribute(value = Kind.POSITIVE_VECTOR, means = "Along x, the height of white, and along z; above 0", otherwise = "1 1 1") Vec3 extent,
        @Attribute(value = Kind.FLAG, means = "Whether light is reckoned as if it were round, not of flat triangles", otherwise = "false") boolean smooth,
        Content content) implements Solid {
    private static final int MOST_LINES = 17;

    public HeightField {
        Objects.requireNonNull(file, "file");
        Require.that(content.isMadeInCode() || !file.isBlank(), "height-field file must not be blank");
        Require.size("height-field extent", extent.x());
        Require.size("height-field extent", extent.y());
        Require.size("height-field extent", extent.z());
        content = content.of(file);
        if (content.heights != null) {
            Require.sizeOrZero("height-field height", extent.y() * content.heights.greatest());
        }
    }

    /**
     * Heights made in code; such a field can be rendered, but no scene file can hold it.
     *
     * @param columns how many points a row has: 2 at least
     * @param rows how many rows there are: 2 at least
     * @param heights of the points, row by row from −z on, 0 or above; 1 is as high as {@code extent} says
     */
    public static HeightField of(int columns, int rows, float[] heights, Vec3 extent) {
        return of(new Heights(columns, rows, heights, 1), extent);
    }

    static HeightField of(Heights heights, Vec3 extent) {
        return new HeightField("", extent, false, new Content("", Objects.requireNonNull(heights, "heights")));
    }

    /** The heights of a file, which have not been read yet. */
    public static HeightField of(String file, Vec3 extent) {
        return new HeightField(file, extent, false, Content.UNREAD);
    }

    public HeightField withSmooth(boolean value) {
        return new HeightField(file, extent, value, content);
    }

    /**
     * With the content of its file.
     *
     * @throws IllegalArgumentException if that makes it higher than shapes can be, or so low that it is nearly nothing
     */
    public HeightField read(Content heights) {
        return new HeightField(file, extent, smooth, new Content(file, Objects.requireNonNull(heights.heights, "heights")));
    }

    /** Whether its heights are there. */
    public boolean isRead() {
        return content.heights != null;
    }

    private Optional<Heights> heights() {
        return Optional.ofNullable(content.heights);
    }

    @Override
    public String kind() {
        return "height-field";
    }

    @Override
    public Face face(int number) {
        return Face.ofBox(number);
    }

    @Override
    public Bounds bounds() {
        return heights().map(known -> known.bounds(extent)).orElse(Bounds.EMPTY);
    }

    /** Lines over the relief, along both sides, and the rim of the base with the edges up from its corners. */
    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        Heights known = content.heights;
        if (known == null) {
            return List.of();
        }
        List<Curve> curves = new ArrayList<>(known.lines(extent, Math.min(MOST_LINES, Math.max(3, steps / 3)), Math.max(8, 2 * steps)).stream().map(Curve::new).toList());
        double x = extent.x() / 2;
        double z = extent.z() / 2;
        curves.add(new Curve(List.of(new Vec3(-x, 0, -z), new Vec3(x, 0, -z), new Vec3(x, 0, z), new Vec3(-x, 0, z), new Vec3(-x, 0, -z))));
        for (int corner = 0; corner < 4; corner++) {
            double height = extent.y() * known.at(corner % 2 == 0 ? 0 : known.columns() - 1, corner < 2 ? 0 : known.rows() - 1);
            Vec3 foot = new Vec3(corner % 2 == 0 ? -x : x, 0, corner < 2 ? -z : z);
            curves.add(Curve.through(foot, foot.plus(new Vec3(0, height, 0))));
        }
        return curves;
    }

    /** @throws IllegalStateException if the heights have not been read */
    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return heights().orElseThrow(() -> new IllegalStateException("the file of a height-field has not been read")).place(extent, smooth, toWorld, parts);
    }

    /** Tells heights, each once. */
    @FunctionalInterface
    public interface Steps {
        /**
         * The height at a point of the grid.
         *
         * @param column from −x on
         * @param row from −z on
         */
        float at(int column, int row);
    }

    /** The heights of one field. Those of files are told apart by the names of these alone. */
    public static final class Content {
        /** Nothing has been read yet. */
        public static final Content UNREAD = new Content("", null);

        private final String file;
        private final @Nullable Heights heights;

        /**
         * What a file holds.
         *
         * @param columns how many points a row has: 2 at least
         * @param rows how many rows there are: 2 at least
         * @param steps the heights, finite and 0 or above, in units of their own
         * @param unit what one of those is, so that whole numbers stay exact; above 0
         */
        public static Content of(int columns, int rows, Steps steps, double unit) {
            return new Content("", Heights.of(columns, rows, Objects.requireNonNull(steps, "steps"), unit));
        }

        private Content(String file, @Nullable Heights heights) {
            this.file = file;
            this.heights = heights;
        }

        private boolean isMadeInCode() {
            return heights != null && file.isEmpty();
        }

        private Content of(String itsFile) {
            return file.equals(itsFile) ? this : UNREAD;
        }

        @Override
        public boolean equals(@Nullable Object other) {
            return other instanceof Content o && isMadeInCode() == o.isMadeInCode() && (!isMadeInCode() || Objects.equals(heights, o.heights));
        }

        @Override
        public int hashCode() {
            return Boolean.hashCode(isMadeInCode());
        }

        @Override
        public String toString() {
            return heights == null ? "not read" : heights.toString();
        }
    }
}
