package cz.paprsek.scene;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Text;
import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;

/** Which files a scene needs besides its own. */
final class UsedFiles {
    private final SortedSet<String> names = new TreeSet<>();

    private UsedFiles() {}

    static SortedSet<String> of(Scene scene) {
        UsedFiles used = new UsedFiles();
        if (scene.sky() instanceof Scene.Sky.Picture picture) {
            used.names.add(picture.file());
        }
        scene.materials().values().forEach(used::add);
        scene.objects().forEach(object -> used.add(object.material(), object.shape()));
        return Collections.unmodifiableSortedSet(used.names);
    }

    private void add(MaterialSource material, Shape shape) {
        add(material);
        if (shape instanceof Mesh mesh && !mesh.file().isEmpty()) {
            names.add(mesh.file());
        }
        if (shape instanceof Text text) {
            names.addAll(text.file().stream().toList());
        }
        if (shape instanceof Csg csg) {
            for (Operand operand : csg.operands()) {
                add(operand.material(), operand.solid());
            }
        }
    }

    private void add(MaterialSource material) {
        if (material instanceof Material own) {
            names.addAll(own.files());
        }
    }
}
