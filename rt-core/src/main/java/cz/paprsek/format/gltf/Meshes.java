package cz.paprsek.format.gltf;

import cz.paprsek.format.model.Notes;
import cz.paprsek.math.Affine;
import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** Puts the meshes of a document into one, each as often as a node shows it; every primitive is a part. */
final class Meshes {
    private static final int TRIANGLES = 4;
    private static final int STRIP = 5;
    private static final int FAN = 6;
    /** A small file may show a large mesh very often. */
    private static final long MOST = 100_000_000;

    private final Tree document;
    private final Accessors accessors;
    private final Materials materials;
    private final Notes notes;
    private final Triangles.Builder builder = Triangles.builder();
    private final Map<String, String> materialOf = new HashMap<>();
    private final Set<String> names = new HashSet<>();
    /** From which number on there is no part of a name yet. */
    private final Map<String, Integer> numbers = new HashMap<>();

    Meshes(Tree document, Accessors accessors, Materials materials, Notes notes) {
        this.document = document;
        this.accessors = accessors;
        this.materials = materials;
        this.notes = notes;
    }

    boolean isEmpty() {
        return builder.triangleCount() == 0;
    }

    Triangles triangles() {
        return builder.build();
    }

    Map<String, String> materialOf() {
        return materialOf;
    }

    /**
     * How a node shows a mesh.
     *
     * @param skin takes the place of the node's own placement
     */
    record Pose(Affine toWorld, Optional<Skin> skin) {
        /** Where a vertex goes. */
        Affine of(Affine[] bones, int vertex) {
            return bones.length > 0 ? bones[vertex] : toWorld;
        }

        boolean isMirrored() {
            return determinant(skin.map(Skin::first).orElse(toWorld)) < 0;
        }
    }

    /**
     * Shows a mesh.
     *
     * @param name of the node
     * @param own weights of the morph targets; empty for those that the mesh has
     */
    void show(int index, String name, Pose pose, double[] own) throws IOException {
        Tree mesh = document.item("meshes", index);
        double[] weights = own.length > 0 ? own : mesh.anyNumbers("weights");
        String called = name.isEmpty() ? mesh.text("name", "").strip() : name;
        int count = mesh.count("primitives");
        if (count == 0) {
            throw mesh.fault("primitives", "a mesh must have at least one");
        }
        for (int i = 0; i < count; i++) {
            primitive(mesh.item("primitives", i), called, pose, weights);
        }
    }

    private void primitive(Tree primitive, String name, Pose pose, double[] weights) throws IOException {
        int mode = primitive.whole("mode", TRIANGLES);
        if (mode < TRIANGLES) {
            notes.add(primitive.path(), "points and lines are not read");
            return;
        }
        if (mode > FAN) {
            throw primitive.fault("mode", "there is no mode " + mode);
        }
        Tree attributes = primitive.child("attributes").orElseThrow(() -> primitive.fault("here must be \"attributes\""));
        if (!attributes.has("POSITION")) {
            notes.add(primitive.path(), "a primitive without places is not read");
            return;
        }
        if (primitive.has("targets")) {
            notes.add(primitive.path(), "morph targets have the weights that they have at first");
        }
        float[] places = morphed(primitive, "POSITION", accessors.floats(attributes.needed("POSITION"), "VEC3"), weights);
        int vertices = places.length / 3;
        int[] indices = primitive.has("indices") ? accessors.indices(primitive.needed("indices"), vertices) : null;
        int corners = indices == null ? vertices : indices.length;
        if (builder.triangleCount() + (long) corners > MOST || builder.vertexCount() + (long) vertices > MOST) {
            throw primitive.fault("all that is shown together is more than " + MOST + " triangles");
        }
        int material = primitive.index("material");
        String part = part(name, material);
        float[] normals = attributes.has("NORMAL") ? morphed(primitive, "NORMAL", accessors.floats(attributes.needed("NORMAL"), "VEC3"), weights) : new float[0];
        int first = vertices(attributes, places, normals, material, pose);
        builder.part(part);
        corners(mode, corners, indices, first, pose.isMirrored());
    }

    private String part(String name, int material) throws IOException {
        String of = material < 0 ? "" : materials.name(material);
        String wanted = !name.isEmpty() && !names.contains(name) ? name : (name + " " + of).strip();
        String part = wanted;
        int next = numbers.getOrDefault(wanted, 2);
        for (; !names.add(part); next++) {
            part = (wanted + " " + next).strip();
        }
        numbers.put(wanted, next);
        if (!of.isEmpty()) {
            materialOf.put(part, of);
        }
        return part;
    }

    /** Numbers of vertices, to each of which targets add theirs times a weight. */
    private float[] morphed(Tree primitive, String attribute, float[] numbers, double[] weights) throws IOException {
        for (int i = 0; i < Math.min(weights.length, primitive.count("targets")); i++) {
            Tree target = primitive.item("targets", i);
            if (weights[i] != 0 && target.has(attribute)) {
                float[] more = accessors.floats(target.needed(attribute), "VEC3");
                if (more.length != numbers.length) {
                    throw target.fault(attribute, "there must be as many as vertices");
                }
                for (int k = 0; k < numbers.length; k++) {
                    numbers[k] = (float) (numbers[k] + weights[i] * more[k]);
                }
            }
        }
        return numbers;
    }

    private int vertices(Tree attributes, float[] places, float[] normals, int material, Pose pose) throws IOException {
        int count = places.length / 3;
        Mapping mapping = material < 0 ? Mapping.PLAIN : materials.mapping(material);
        String set = "TEXCOORD_" + mapping.set();
        float[] map = attributes.has(set) ? accessors.floats(attributes.needed(set), "VEC2") : new float[0];
        if ((normals.length > 0 && normals.length != places.length) || (map.length > 0 && map.length != 2 * count)) {
            throw attributes.fault("there must be as many normals and places in pictures as vertices");
        }
        float[] colors = colors(attributes, count);
        Affine[] bones = pose.skin.isPresent() ? pose.skin.get().placements(attributes, accessors, count) : new Affine[0];
        Affine usual = pose.toWorld.inverse();
        int first = builder.vertexCount();
        for (int i = 0; i < count; i++) {
            double x = places[3 * i];
            double y = places[3 * i + 1];
            double z = places[3 * i + 2];
            Affine toWorld = pose.of(bones, i);
            int vertex = builder.vertex(toWorld.pointX(x, y, z), toWorld.pointY(x, y, z), toWorld.pointZ(x, y, z));
            if (normals.length > 0) {
                normal(vertex, normals[3 * i], normals[3 * i + 1], normals[3 * i + 2], bones.length > 0 ? toWorld.inverse() : usual);
            }
            if (map.length > 0) {
                builder.map(vertex, mapping.u(map[2 * i], map[2 * i + 1]), mapping.v(map[2 * i], map[2 * i + 1]));
            }
            if (colors.length > 0) {
                builder.color(vertex, light(colors[3 * i]), light(colors[3 * i + 1]), light(colors[3 * i + 2]));
            }
        }
        return first;
    }

    /** Three channels for each vertex, linear light; their opacity is said to be left away. */
    private float[] colors(Tree attributes, int count) throws IOException {
        if (!attributes.has("COLOR_0")) {
            return new float[0];
        }
        int accessor = attributes.needed("COLOR_0");
        boolean isFour = document.item("accessors", accessor).text("type", "").equals("VEC4");
        float[] all = accessors.floats(accessor, isFour ? "VEC4" : "VEC3");
        int width = isFour ? 4 : 3;
        if (all.length != width * count) {
            throw attributes.fault("COLOR_0", "there must be as many colours as vertices");
        }
        float[] colors = new float[3 * count];
        boolean isOpaque = true;
        for (int i = 0; i < count; i++) {
            System.arraycopy(all, width * i, colors, 3 * i, 3);
            isOpaque &= !isFour || all[4 * i + 3] == 1;
        }
        if (!isOpaque) {
            notes.add(attributes.path(), "the opacity of vertices is not read");
        }
        return colors;
    }

    private static double light(float channel) {
        return Math.max(0, Math.min(1, channel));
    }

    /** Normals go by the transpose of the way back. */
    private void normal(int vertex, double x, double y, double z, Affine back) {
        double nx = back.xx() * x + back.yx() * y + back.zx() * z;
        double ny = back.xy() * x + back.yy() * y + back.zy() * z;
        double nz = back.xz() * x + back.yz() * y + back.zz() * z;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (length > 0 && length < Double.POSITIVE_INFINITY) {
            builder.normal(vertex, nx / length, ny / length, nz / length);
        }
    }

    private void corners(int mode, int corners, int @Nullable [] indices, int first, boolean isMirrored) {
        int step = mode == TRIANGLES ? 3 : 1;
        for (int i = 0; i + 2 < corners; i += step) {
            boolean isTurned = mode == STRIP && i % 2 == 1;
            int a = mode == FAN ? 0 : isTurned ? i + 1 : i;
            int b = isTurned ? i : i + 1;
            int c = i + 2;
            int ia = indices == null ? a : indices[a];
            int ib = indices == null ? b : indices[b];
            int ic = indices == null ? c : indices[c];
            if (ia != ib && ib != ic && ia != ic) {
                builder.triangle(first + ia, first + (isMirrored ? ic : ib), first + (isMirrored ? ib : ic));
            }
        }
    }

    private static double determinant(Affine m) {
        return m.xx() * (m.yy() * m.zz() - m.yz() * m.zy()) - m.xy() * (m.yx() * m.zz() - m.yz() * m.zx()) + m.xz() * (m.yx() * m.zy() - m.yy() * m.zx());
    }
}
