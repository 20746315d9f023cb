package cz.paprsek.format.model;

import cz.paprsek.material.Material;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.shape.mesh.Triangles;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * What a file of another program holds: triangles in parts, and what they are made of. Everything stands in the space of the file.
 *
 * @param triangles all of them; their parts have the names that {@code materialOf} goes by
 * @param materialOf for a part's name that of its material; parts without one are left out
 * @param materials by name, in the order of the file; a picture of theirs is one of {@code pictures}, or lies beside the file
 * @param pictures files that are within this one, by the name that materials use
 * @param cameras as seen in the file's space
 * @param lights in the file's space
 * @param convention what its numbers mean
 * @param notes what is in the file but not taken along, in sentences
 * @param missing what should be beside it and cannot be read, which is among them
 */
public record Model(Triangles triangles, Map<String, String> materialOf, Map<String, Material> materials, Map<String, byte[]> pictures,
        List<Camera> cameras, List<Light> lights, Convention convention, List<String> notes, List<String> missing) {
    public Model {
        Objects.requireNonNull(triangles, "triangles");
        materialOf = Map.copyOf(materialOf);
        pictures = Map.copyOf(pictures);
        cameras = List.copyOf(cameras);
        lights = List.copyOf(lights);
        Objects.requireNonNull(convention, "convention");
        notes = List.copyOf(notes);
        missing = List.copyOf(missing);
    }

    /** Triangles of no known material. */
    public static Model of(Triangles triangles, Convention convention, Notes notes) {
        return new Model(triangles, Map.of(), Map.of(), Map.of(), List.of(), List.of(), convention, notes.toList(), notes.missing());
    }
}
