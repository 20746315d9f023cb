package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import java.lang.ref.WeakReference;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * Triangles, from a file of another program or made in code. A solid if they are closed; else a surface, seen from both sides, that takes no part in
 * CSG. A file's triangles are not there before somebody has {@linkplain #read read} them: renderer and editor do, from the scene's assets.
 *
 * @param file where they come from, relative to the scene's folder; empty if they were made in code
 * @param part of the file's parts only the one of this name; empty for all
 * @param smoothAngle neighbours bent by no more than this many degrees look smooth; 0 for the normals that come with the triangles, or flat ones
 * @param weld how far corners at open edges may be apart to be one, as a share of the diagonal of the triangles' box, 0–1: those of a seam that another program reckoned twice
 * @param content the triangles
 */
@Element("Triangles from a file beside the scene's: a solid if they are closed, else a surface without an inside.")
public record Mesh(
        @Attribute(value = Kind.FILE, means = "STL, OBJ, PLY, glTF or OFF, beside the scene's file; its axes stay as they are") String file,
        @Attribute(value = Kind.NAME, means = "Of the file's parts only the one of this name", otherwise = Attribute.NOTHING) String part,
        @Attribute(value = Kind.DISC_ANGLE, means = "Neighbours bent by no more than this look smooth; 0 for the normals that the file has, or flat ones", otherwise = "0")
        double smoothAngle,
        @Attribute(value = Kind.SHARE, means = "Corners at open edges that are no further apart become one; a share of the diagonal of its box", otherwise = "1e-5") double weld,
        Content content) implements Solid {
    /** As far as numbers of six digits are apart that should be the same. */
    public static final double USUAL_WELD = 1e-5;

    private static final int ROUGH = 20;

    public Mesh {
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(part, "part");
        Require.within("mesh smooth-angle", smoothAngle, 0, 180);
        Require.that(content.isMadeInCode() || !file.isBlank(), "mesh file must not be blank");
        Require.within("mesh weld", weld, 0, 1);
        content = content.of(file, part, smoothAngle, weld);
    }

    /** Triangles made in code, with their own normals or flat; such a mesh can be rendered, but no scene file can hold it. */
    public static Mesh of(Triangles triangles) {
        return new Mesh("", "", 0, USUAL_WELD, new Content(new Whole("", true, triangles, Map.of(), Map.of(), Set.of(), List.of()), "", 0, USUAL_WELD));
    }

    /** All of a file's triangles, which have not been read yet. */
    public static Mesh of(String file) {
        return new Mesh(file, "", 0, USUAL_WELD, Content.UNREAD);
    }

    public Mesh withPart(String value) {
        return new Mesh(file, value, smoothAngle, weld, content);
    }

    public Mesh withSmoothAngle(double degrees) {
        return new Mesh(file, part, degrees, weld, content);
    }

    public Mesh withWeld(double share) {
        return new Mesh(file, part, smoothAngle, share, content);
    }

    /** With the content of its file. */
    public Mesh read(Whole whole) {
        return new Mesh(file, part, smoothAngle, weld, new Content(Objects.requireNonNull(whole, "whole"), "", 0, 0));
    }

    /** Whether its triangles are there. */
    public boolean isRead() {
        return content.whole != null;
    }

    /**
     * Its triangles: only those of its part, with seams closed, turned so that they fit, with its normals.
     *
     * @throws IllegalStateException if they have not been {@linkplain #isRead read}
     * @throws IllegalArgumentException if the file has no part of that name
     */
    public Triangles triangles() {
        return content.triangles();
    }

    /** Whether it is closed; of one that has not been read it is taken for granted. */
    @Override
    public boolean hasInside() {
        return !isRead() || triangles().isClosed();
    }

    /** What the file's parts are made of that are in this mesh, and have a material. */
    public Collection<Material> materials() {
        return isRead() ? triangles().parts().stream().map(this::materialOf).flatMap(Optional::stream).toList() : List.of();
    }

    /** What a part is made of if the scene says nothing; empty if the file does not say it either, or has not been read. */
    public Optional<Material> materialOf(String partOfFile) {
        Objects.requireNonNull(partOfFile, "partOfFile");
        Whole whole = content.whole;
        return whole == null ? Optional.empty() : Optional.ofNullable(whole.materials.get(partOfFile));
    }

    /** Files that lie nowhere else: pictures within its own by the names that its materials have for them, and that itself if nobody has written it yet. */
    public Map<String, byte[]> within() {
        Whole whole = content.whole;
        return whole == null ? Map.of() : whole.within;
    }

    /** The names of the files that its own needs beside itself, relative to the scene's folder. */
    public Set<String> companions() {
        Whole whole = content.whole;
        return whole == null ? Set.of() : whole.companions;
    }

    /** What its own file needs beside itself and does without, since that cannot be read: its materials; in sentences. */
    public List<String> missing() {
        Whole whole = content.whole;
        return whole == null ? List.of() : whole.missing;
    }

    @Override
    public Bounds bounds() {
        return isRead() ? triangles().bounds() : Bounds.EMPTY;
    }

    /** {@inheritDoc} Of many triangles it is drawn roughly if a circle is to have fewer than {@value #ROUGH} pieces. */
    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        return isRead() ? triangles().outline(along, steps < ROUGH).stream().map(Curve::new).toList() : List.of();
    }

    /** @throws IllegalStateException if the triangles have not been read */
    @Override
    public Volume place(Affine toWorld, Parts parts) {
        Triangles triangles = triangles();
        return triangles.place(toWorld, number -> {
            Optional<Material> own = materialOf(triangles.parts().get(number));
            return own.isEmpty() && !triangles.hasColors() ? parts : parts.unlessGiven(own.orElse(Material.DEFAULT), toWorld, triangles.hasColors());
        });
    }

    /** All that a file holds, shared by the meshes that show it or a part of it. */
    public static final class Whole {
        private final String file;
        private final boolean madeInCode;
        private final Triangles triangles;
        private final Map<String, Material> materials;
        private final Map<String, byte[]> within;
        private final Set<String> companions;
        private final List<String> missing;
        /** What has been made of it and is still in use. */
        private final Map<String, WeakReference<Triangles>> made = new ConcurrentHashMap<>();

        /**
         * The content of a file.
         *
         * @param file its name, as meshes have it
         * @param materials what parts are made of, by their names, where the scene gives a mesh no material
         */
        public Whole(String file, Triangles triangles, Map<String, Material> materials) {
            this(file, triangles, materials, Map.of(), Set.of(), List.of());
        }

        /**
         * The content of a file that comes with others.
         *
         * @param within the others that lie nowhere else, by their names as from the scene's folder; no copies are made
         * @param companions names of the others that lie beside it
         * @param missing what should lie beside it and cannot be read, in sentences
         */
        public Whole(String file, Triangles triangles, Map<String, Material> materials, Map<String, byte[]> within, Set<String> companions, List<String> missing) {
            this(file, false, triangles, materials, within, companions, missing);
        }

        private Whole(String file, boolean madeInCode, Triangles triangles, Map<String, Material> materials, Map<String, byte[]> within, Set<String> companions, List<String> missing) {
            Objects.requireNonNull(missing, "missing");
            this.file = Objects.requireNonNull(file, "file");
            this.madeInCode = madeInCode;
            this.triangles = Objects.requireNonNull(triangles, "triangles");
            this.materials = Map.copyOf(materials);
            this.within = Map.copyOf(within);
            this.companions = Set.copyOf(companions);
            this.missing = List.copyOf(missing);
        }

        private synchronized Triangles made(String part, double smoothAngle, double weld) {
            String key = part + '\n' + smoothAngle + ' ' + weld;
            WeakReference<Triangles> known = made.get(key);
            Triangles ready = known == null ? null : known.get();
            if (ready == null) {
                Triangles cut = part.isEmpty() ? triangles : triangles.onlyPart(number(part));
                Triangles fitting = cut.sewn(weld).oriented();
                ready = smoothAngle > 0 ? fitting.smoothed(smoothAngle) : fitting;
                made.put(key, new WeakReference<>(ready));
            }
            return ready;
        }

        private int number(String part) {
            int number = triangles.parts().indexOf(part);
            Require.that(number >= 0, "there is no part \"" + part + "\" in \"" + file + "\"" + (triangles.parts().equals(List.of("")) ? ", which has no parts"
                    : "; it has " + String.join(", ", triangles.parts().stream().limit(10).map(name -> '"' + name + '"').toList())));
            return number;
        }
    }

    /** The triangles of one mesh, worked out when they are first asked for. Contents of files are told apart by the names of these alone. */
    public static final class Content {
        /** Nothing has been read yet. */
        public static final Content UNREAD = new Content(null, "", 0, 0);

        private final @Nullable Whole whole;
        private final String part;
        private final double smoothAngle;
        private final double weld;
        private volatile @Nullable Triangles triangles;

        private Content(@Nullable Whole whole, String part, double smoothAngle, double weld) {
            this.whole = whole;
            this.part = part;
            this.smoothAngle = smoothAngle;
            this.weld = weld;
        }

        private boolean isMadeInCode() {
            return whole != null && whole.madeInCode;
        }

        private Content of(String itsFile, String itsPart, double itsAngle, double itsWeld) {
            return whole == null || !whole.file.equals(itsFile) ? UNREAD
                    : part.equals(itsPart) && smoothAngle == itsAngle && weld == itsWeld ? this : new Content(whole, itsPart, itsAngle, itsWeld);
        }

        private Triangles triangles() {
            Triangles known = triangles;
            if (known == null) {
                if (whole == null) {
                    throw new IllegalStateException("the file of a mesh has not been read");
                }
                known = whole.made(part, smoothAngle, weld);
                triangles = known;
            }
            return known;
        }

        @Override
        public boolean equals(@Nullable Object other) {
            return this == other || (other instanceof Content o && isMadeInCode() == o.isMadeInCode()
                    && (!isMadeInCode() || Objects.requireNonNull(whole).triangles.equals(Objects.requireNonNull(o.whole).triangles)));
        }

        @Override
        public int hashCode() {
            return Boolean.hashCode(isMadeInCode());
        }

        @Override
        public String toString() {
            return whole == null ? "not read" : whole.triangles.toString();
        }
    }
}
