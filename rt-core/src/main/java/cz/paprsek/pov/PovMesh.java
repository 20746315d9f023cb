package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.mesh.Triangles;
import java.util.List;
import java.util.function.IntConsumer;

/** A mesh in POV-Ray's words, with its normals and what its parts are made of; one that is closed has an inside there too. */
final class PovMesh {
    private final StringBuilder out = new StringBuilder("mesh2 {");

    private PovMesh() {}

    /** @param textures for each part; empty if all are of one that the mesh is given */
    static String of(Mesh mesh, List<String> textures) {
        Require.that(mesh.isRead(), "a scene for POV-Ray needs the triangles of a mesh, but \"" + mesh.file() + "\" has not been read");
        return new PovMesh().write(mesh.triangles(), textures);
    }

    private String write(Triangles mesh, List<String> textures) {
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
            if (!textures.isEmpty()) {
                out.append(", ").append(mesh.part(t));
            }
        });
        // Not along an axis: there lie the sides of many meshes, on which POV-Ray stumbles.
        return mesh.isClosed() ? out.append("\n inside_vector <0.577, 0.641, 0.506>").toString() : out.toString();
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
