package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.mesh.Triangles;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/** A mesh in POV-Ray's words, with its normals and what its parts are made of; one that is closed has an inside there too. */
final class PovMesh {
    /** Not along an axis: there lie the sides of many meshes, on which POV-Ray stumbles. */
    private static final String INSIDE = "\n inside_vector <0.577, 0.641, 0.506>";

    private final StringBuilder out = new StringBuilder("mesh2 {");

    private PovMesh() {}

    /** @param textures for each part; empty if all are of one that the mesh is given */
    static String of(Mesh mesh, List<String> textures) {
        Require.that(mesh.isRead(), "a scene for POV-Ray needs the triangles of a mesh, but \"" + mesh.file() + "\" has not been read");
        return new PovMesh().write(mesh.triangles(), textures, new int[0]);
    }

    /** Of triangles that enclose something, though corners of some may lie within edges of others. */
    static String enclosing(Triangles triangles) {
        return new PovMesh().written(triangles, List.of(), new int[0]).append(INSIDE).toString();
    }

    /**
     * With what the file has its parts made of, and the colours of its corners: a texture for each of these on each part, which POV-Ray mixes in between as we do.
     *
     * @param textures what a material looks like
     */
    static String ofFile(Mesh mesh, Function<Material, String> textures) {
        Triangles triangles = mesh.triangles();
        List<Material> materials = triangles.parts().stream().map(part -> mesh.materialOf(part).orElse(Material.DEFAULT)).toList();
        return triangles.hasColors() ? new PovMesh().write(triangles, materials, textures) : of(mesh, materials.stream().map(textures).toList());
    }

    /** Whether all that the colours of the corners do can be told: not where they lie over a pattern, or make a surface brighter than white. */
    static boolean isTold(Mesh mesh) {
        Triangles triangles = mesh.triangles();
        return !triangles.hasColors() || (triangles.parts().stream().allMatch(part -> mesh.materialOf(part).orElse(Material.DEFAULT).pattern() instanceof Pattern.Plain)
                && IntStream.range(0, triangles.vertexCount()).mapToObj(triangles::color).allMatch(color -> Math.max(color.x(), Math.max(color.y(), color.z())) <= 1));
    }

    private record Tint(Material material, Vec3 color) {}

    private String write(Triangles mesh, List<Material> materials, Function<Material, String> textures) {
        Map<Tint, Integer> numbers = new LinkedHashMap<>();
        int[] ofCorner = new int[3 * mesh.count()];
        for (int i = 0; i < ofCorner.length; i++) {
            Tint tint = new Tint(materials.get(mesh.part(i / 3)), mesh.color(mesh.corner(i / 3, i % 3)));
            ofCorner[i] = numbers.computeIfAbsent(tint, fresh -> numbers.size());
        }
        return write(mesh, numbers.keySet().stream().map(tint -> textures.apply(tinted(tint))).toList(), ofCorner);
    }

    private static Material tinted(Tint tint) {
        return tint.material.pattern() instanceof Pattern.Plain plain ? tint.material.withPattern(new Pattern.Plain(Rgb.ofLinear(Math.min(1, plain.color().linearRed() * tint.color.x()),
                Math.min(1, plain.color().linearGreen() * tint.color.y()), Math.min(1, plain.color().linearBlue() * tint.color.z())))) : tint.material;
    }

    /** @param ofCorner for each corner of each triangle its texture; empty if those go by the parts */
    private String write(Triangles mesh, List<String> textures, int[] ofCorner) {
        return written(mesh, textures, ofCorner).append(mesh.isClosed() ? INSIDE : "").toString();
    }

    private StringBuilder written(Triangles mesh, List<String> textures, int[] ofCorner) {
        block("vertex_vectors", mesh.vertexCount(), v -> out.append(vector(mesh.place(v))));
        if (isSmooth(mesh)) {
            block("normal_vectors", mesh.vertexCount(), v -> out.append(vector(mesh.normal(v).normalized())));
        }
        if (mesh.hasMap()) {
            block("uv_vectors", mesh.vertexCount(), v -> out.append('<').append(text(mesh.u(v))).append(", ").append(text(mesh.v(v))).append('>'));
        }
        if (!textures.isEmpty()) {
            block("texture_list", textures.size(), i -> out.append(textures.get(i)));
        }
        block("face_indices", mesh.count(), t -> {
            out.append('<').append(mesh.corner(t, 0)).append(", ").append(mesh.corner(t, 1)).append(", ").append(mesh.corner(t, 2)).append('>');
            if (ofCorner.length > 0) {
                out.append(", ").append(ofCorner[3 * t]).append(", ").append(ofCorner[3 * t + 1]).append(", ").append(ofCorner[3 * t + 2]);
            } else if (!textures.isEmpty()) {
                out.append(", ").append(mesh.part(t));
            }
        });
        return out;
    }

    /** POV-Ray has normals for all vertices or for none. */
    static boolean isSmooth(Triangles mesh) {
        for (int v = 0; v < mesh.vertexCount(); v++) {
            if (mesh.normal(v).equals(Vec3.ZERO)) {
                return false;
            }
        }
        return true;
    }

    private void block(String word, int count, IntConsumer item) {
        out.append("\n ").append(word).append(" { ").append(count);
        for (int i = 0; i < count; i++) {
            out.append(i % 4 == 0 ? ",\n  " : ", ");
            item.accept(i);
        }
        out.append("\n }");
    }
}
