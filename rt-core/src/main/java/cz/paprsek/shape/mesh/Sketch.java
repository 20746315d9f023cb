package cz.paprsek.shape.mesh;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Draws triangles by few of their sides: those of which one triangle looks here and the other away, those at which they are bent sharply, and those
 * that have not just two; joined to lines, which are as fine as can be seen. Made once; what was drawn last is kept, for whoever drags a mesh asks
 * again and again. Who turns it asks for another one every time: of edges whose triangles all look much the same way, no single one is asked.
 */
final class Sketch {
    /** By so much of its size lines may be wrong, if they are not too many. */
    private static final double FINE = 1.0 / 1500;
    private static final double COARSE = 1.0 / 50;
    /** More pieces of lines than this are not seen apart. */
    private static final int MOST = 1200;
    /** More sharp edges than this do not help to see what it is. */
    private static final int TOO_MANY = 40_000;
    /** The cosine of 40°. */
    private static final double SHARP = 0.766;
    /** How many edges are passed over at once. */
    private static final int BATCH = 32;
    /** More than rounding does to products of normals. */
    private static final double ROUNDING = 1e-5;
    private static final int KEPT = 12;
    /** So many triangles are few: there is no need to draw them as if they were fewer. */
    private static final int FEW = 50_000;

    private final Optional<Sketch> rough;
    private final double[] places;
    private final double size;
    /** Of each edge that is always drawn its two ends, as vertices; likewise of those that are drawn from some sides only. */
    private final int[] always;
    private final int[] smooth;
    /** Of the latter the two triangles. */
    private final int[] beside;
    /** For each triangle, of length 1; 0 0 0 if it has none. */
    private final float[] normals;
    /** For each batch of the latter the middle of their normals, and the sine of the greatest angle between it and them; beyond 1 if there is none. */
    private final float[] cones;
    private final Map<Vec3, List<List<Vec3>>> drawn = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Vec3, List<List<Vec3>>> eldest) {
            return size() > KEPT;
        }
    };

    /** Where most neighbours are bent sharply, as in what was scanned or is covered with waves, edges tell nothing: then it is drawn as if it were coarser. */
    static Sketch of(Triangles mesh) {
        Optional<Sketch> coarse = mesh.count() > FEW ? Optional.of(new Sketch(Coarse.of(mesh), true, Optional.empty())) : Optional.empty();
        Sketch fine = new Sketch(mesh, false, coarse);
        return fine.always.length / 2 > TOO_MANY ? coarse.orElse(fine) : fine;
    }

    private Sketch(Triangles mesh, boolean isCoarse, Optional<Sketch> rough) {
        this.rough = rough;
        places = mesh.places();
        Bounds box = mesh.bounds();
        size = Math.max(box.maxX() - box.minX(), Math.max(box.maxY() - box.minY(), box.maxZ() - box.minZ()));
        normals = normals(mesh);
        int[] corners = mesh.corners();
        int[] first = Weld.firsts(places);
        IntsOut sharp = new IntsOut();
        IntsOut others = new IntsOut();
        IntsOut triangles = new IntsOut();
        new Edges(first, corners).each((side, other) -> {
            boolean isSmooth = other >= 0 && (isCoarse || alike(side / 3, other / 3) >= SHARP);
            if (isSmooth) {
                others.add(first[corners[side]], first[corners[side % 3 == 2 ? side - 2 : side + 1]]);
                triangles.add(side / 3, other / 3);
            } else {
                sharp.add(first[corners[side]], first[corners[side % 3 == 2 ? side - 2 : side + 1]]);
            }
        });
        smooth = others.all();
        // Where cells of a grid meet there are edges that the mesh itself has not; unless nothing hangs together.
        always = isCoarse ? smooth.length > sharp.count ? new int[0] : sharp.few() : sharp.all();
        beside = triangles.all();
        cones = new float[4 * ((beside.length / 2 + BATCH - 1) / BATCH)];
        for (int i = 0; i < cones.length; i += 4) {
            putCone(i);
        }
    }

    private static float[] normals(Triangles mesh) {
        int[] corners = mesh.corners();
        float[] normals = new float[corners.length];
        for (int i = 0; i < corners.length; i += 3) {
            Vec3 n = Measures.product(mesh.places(), 3 * corners[i], 3 * corners[i + 1], 3 * corners[i + 2]);
            double length = n.length();
            if (length > 0) {
                normals[i] = (float) (n.x() / length);
                normals[i + 1] = (float) (n.y() / length);
                normals[i + 2] = (float) (n.z() / length);
            }
        }
        return normals;
    }

    private void putCone(int cone) {
        int from = cone / 4 * 2 * BATCH;
        int to = Math.min(from + 2 * BATCH, beside.length);
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = from; i < to; i++) {
            x += normals[3 * beside[i]];
            y += normals[3 * beside[i] + 1];
            z += normals[3 * beside[i] + 2];
        }
        double length = Math.sqrt(x * x + y * y + z * z);
        double least = length > 0 ? 1 : -1;
        for (int i = from; i < to && length > 0; i++) {
            least = Math.min(least, (x * normals[3 * beside[i]] + y * normals[3 * beside[i] + 1] + z * normals[3 * beside[i] + 2]) / length);
        }
        cones[cone] = (float) (x / length);
        cones[cone + 1] = (float) (y / length);
        cones[cone + 2] = (float) (z / length);
        cones[cone + 3] = (float) (least > 0 ? Math.sqrt(Math.max(0, 1 - least * least)) + ROUNDING : 2);
    }

    /** That of fewer triangles, in a hundredth of the time; itself if there are few. */
    Sketch rough() {
        return rough.orElse(this);
    }

    synchronized List<List<Vec3>> lines(Vec3 along) {
        return drawn.computeIfAbsent(along, this::draw);
    }

    private List<List<Vec3>> draw(Vec3 along) {
        // A line has a piece at least, however coarse.
        List<int[]> lines = Lines.longest(Lines.joined(seen(along.normalized())), MOST);
        double tolerance = FINE * size;
        lines = Lines.thinned(lines, places, tolerance);
        while (Lines.pieces(lines) > MOST && tolerance < COARSE * size) {
            tolerance *= 2;
            lines = Lines.thinned(lines, places, tolerance);
        }
        return lines.stream().map(line -> Arrays.stream(line).mapToObj(v -> new Vec3(places[3 * v], places[3 * v + 1], places[3 * v + 2])).toList()).toList();
    }

    /** The ends of the edges that are drawn. */
    private int[] seen(Vec3 v) {
        IntsOut out = new IntsOut();
        for (int i = 0; i < always.length; i += 2) {
            out.add(always[i], always[i + 1]);
        }
        for (int cone = 0; cone < cones.length; cone += 4) {
            if (Math.abs(cones[cone] * v.x() + cones[cone + 1] * v.y() + cones[cone + 2] * v.z()) > cones[cone + 3]) {
                continue;
            }
            int from = cone / 4 * 2 * BATCH;
            for (int i = from; i < Math.min(from + 2 * BATCH, beside.length); i += 2) {
                if (looksHere(beside[i], v) != looksHere(beside[i + 1], v)) {
                    out.add(smooth[i], smooth[i + 1]);
                }
            }
        }
        return out.all();
    }

    private boolean looksHere(int t, Vec3 v) {
        return normals[3 * t] * v.x() + normals[3 * t + 1] * v.y() + normals[3 * t + 2] * v.z() > 0;
    }

    private double alike(int t, int other) {
        return normals[3 * t] * normals[3 * other] + normals[3 * t + 1] * normals[3 * other + 1] + normals[3 * t + 2] * normals[3 * other + 2];
    }

    /** Pairs of numbers in a growing array. */
    private static final class IntsOut {
        private int[] pairs = new int[256];
        private int count;

        void add(int a, int b) {
            if (count == pairs.length) {
                pairs = Arrays.copyOf(pairs, 2 * count);
            }
            pairs[count++] = a;
            pairs[count++] = b;
        }

        /** Some of them, from all over. */
        int[] few() {
            int step = 1 + count / (8 * MOST);
            return IntStream.range(0, count / 2).filter(i -> i % step == 0).flatMap(i -> IntStream.of(pairs[2 * i], pairs[2 * i + 1])).toArray();
        }

        int[] all() {
            return Arrays.copyOf(pairs, count);
        }
    }
}
