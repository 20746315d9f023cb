package cz.paprsek.fx.model.edit;

import static cz.paprsek.scene.ScenePath.body;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.fx.model.TestScenes;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import java.util.List;
import org.junit.jupiter.api.Test;

class MaterialsTest {
    private final Scene kitchen = TestScenes.kitchen();

    @Test
    void usesAreCountedAtAnyDepth() {
        assertThat(Materials.uses(kitchen, "red")).isEqualTo(2);
        assertThat(Materials.uses(kitchen, "green")).isZero();
    }

    @Test
    void renamedMaterialIsReferredToByItsNewName() {
        Scene after = Materials.rename(kitchen, "red", "rouge");
        assertThat(after.materials()).containsOnlyKeys("rouge").containsValue(TestScenes.RED);
        assertThat(after.objects().get(0).material()).isEqualTo(new MaterialName("rouge"));
        assertThat(after.objects().get(2)).isSameAs(kitchen.objects().get(2));
        assertThat(Materials.rename(after, "rouge", "red")).isEqualTo(kitchen);
        assertThatThrownBy(() -> Materials.rename(kitchen.plus("blue", TestScenes.BLUE), "red", "blue")).hasMessageContaining("already a material named");
        assertThatThrownBy(() -> Materials.rename(kitchen, "red", " ")).hasMessageContaining("must not be blank");
    }

    @Test
    void deletedMaterialStaysWithWhatIsMadeOfIt() {
        Scene after = Materials.delete(kitchen, "red");
        assertThat(after.materials()).isEmpty();
        assertThat(after.objects().get(0).material()).isEqualTo(TestScenes.RED);
    }

    @Test
    void ownMaterialLooksLikeTheOneBefore() {
        Scene after = Materials.own(kitchen, List.of(body(0), body(1, 0), body(2)));
        assertThat(after.objects().get(0).material()).isEqualTo(TestScenes.RED);
        assertThat(body(1, 0).in(after).material()).isEqualTo(TestScenes.RED);
        assertThat(after.objects().get(2).material()).isEqualTo(Material.DEFAULT);
    }

    @Test
    void namedMaterialIsSharedByAllThatHadAnEqualOne() {
        Scene owned = Materials.own(kitchen, List.of(body(0), body(3)));
        Scene after = Materials.name(owned, List.of(body(0), body(3)), "red");
        assertThat(after.objects().get(0).material()).isEqualTo(new MaterialName("red 2"));
        assertThat(after.objects().get(3).material()).isEqualTo(Material.DEFAULT);
        assertThatThrownBy(() -> Materials.name(kitchen, List.of(body(2)), "x")).hasMessageContaining("material of its own");
        assertThat(kitchen.objects().get(2).material()).isEqualTo(Inherited.INHERITED);
    }

    @Test
    void aMaterialThatIsGivenComesUnderItsNameOrAFreeOneAndOnlyOnce() {
        Material gold = Material.color(255, 196, 70);
        Scene scene = Scene.EMPTY.plus("gold", gold).plus(SceneObject.of(new Sphere(1)), SceneObject.of(new Sphere(2)));
        Scene same = Materials.give(scene, List.of(ScenePath.body(1)), "gold", gold);
        assertThat(same.materials()).containsOnlyKeys("gold");
        assertThat(same.objects().get(1).material()).isEqualTo(new MaterialName("gold"));
        assertThat(same.objects().get(0)).isSameAs(scene.objects().get(0));
        Scene other = Materials.give(scene, List.of(ScenePath.body(0)), "gold", Material.color(180, 190, 200));
        assertThat(other.materials()).containsEntry("gold", gold).containsEntry("gold 2", Material.color(180, 190, 200));
        assertThat(other.objects().get(0).material()).isEqualTo(new MaterialName("gold 2"));
    }
}
