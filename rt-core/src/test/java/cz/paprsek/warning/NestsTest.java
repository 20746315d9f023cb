package cz.paprsek.warning;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A few lines of definitions within one another make more bodies than anybody can look at. */
class NestsTest {
    private static Solid doubled(Solid solid, int times) {
        Solid nest = solid;
        for (int i = 0; i < times; i++) {
            nest = Csg.union(Operand.of(nest), Operand.of(nest).at(Math.scalb(3.0, i), 0, 0));
        }
        return nest;
    }

    private static List<String> kinds(Scene scene) {
        return SceneWarnings.of(scene).stream().map(SceneWarning::kind).toList();
    }

    @Test
    @Timeout(5)
    void materialsAreLookedAtInTheLargestNestAndWarningsDoNotTakeLong() {
        Solid leaf = Csg.union(Operand.of(new Sphere(1)).madeOf(new MaterialName("red")));
        Scene scene = Scene.EMPTY.withMaterials(Map.of("red", Material.DEFAULT, "blue", Material.DEFAULT)).plus(SceneObject.of(doubled(leaf, 26)));
        assertThat(kinds(scene)).containsExactly("dark", "unused");
        assertThat(SceneWarnings.of(scene).get(1).message()).contains("blue");
        assertThat(kinds(scene.withMaterials(Map.of("red", Material.DEFAULT.withEmission(Rgb.WHITE, 1))))).isEmpty();
        assertThat(scene.objects().get(0).shape().bounds().maxX()).isEqualTo(3 * (Math.scalb(1.0, 26) - 1) + 1);
    }

    @Test
    @Timeout(5)
    void ofManyNestsOnlySomeAreLookedThrough() {
        Solid nest = doubled(new Sphere(1), 26);
        assertThat(kinds(Scene.EMPTY.withObjects(IntStream.range(0, 1000).mapToObj(i -> SceneObject.of(nest)).toList()))).containsExactly("dark");
    }

    @Test
    void smallOnesAreLookedThrough() {
        Solid nest = doubled(Csg.intersection(Operand.of(new Sphere(1)), Operand.of(new Sphere(1)).at(0, 5, 0)), 3);
        assertThat(kinds(Scene.EMPTY.plus(SceneObject.of(nest)))).containsOnly("dark", "operand").hasSize(9);
        Vec3 eye = Scene.EMPTY.camera().position();
        assertThat(kinds(Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).at(eye.x(), eye.y(), eye.z())))).contains("camera-inside");
    }
}
