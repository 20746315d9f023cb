package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.item.Item;
import cz.paprsek.fx.model.item.Item.BodyAt;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Csg.Operation;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class VisibleTest {
    private static final Scene SCENE = Scene.EMPTY.plus(Light.at(0, 1, 0).named("key")).plus(Light.at(0, 2, 0).named("fill"))
            .plus(ball(1), csg(Operation.DIFFERENCE, 2, 3, 4), csg(Operation.UNION, 5, 6), ball(7));

    private static SceneObject ball(double radius) {
        return SceneObject.of(new Sphere(radius));
    }

    private static SceneObject csg(Operation operation, double... radii) {
        return SceneObject.of(new Csg(operation, Arrays.stream(radii).mapToObj(radius -> Operand.of(new Sphere(radius))).toList()));
    }

    private static Visible without(Item... hidden) {
        return Visible.of(EditorState.of(SCENE).withHidden(Set.of(hidden)));
    }

    @Test
    void withNothingHiddenItIsTheVerySceneAndEverythingStandsWhereItStands() {
        assertThat(without().scene()).isSameAs(SCENE);
        assertThat(without().original(Item.body(1, 2))).isEqualTo(Item.body(1, 2));
    }

    @Test
    void whatIsAfterSomethingHiddenIsFoundAgain() {
        Visible visible = without(Item.body(0), Item.body(1, 1), Item.light(0));
        assertThat(visible.scene().objects()).hasSize(3).last().isSameAs(SCENE.objects().get(3));
        assertThat(visible.scene().lights()).containsExactly(SCENE.lights().get(1));
        assertThat(visible.original(Item.body(0, 1))).isEqualTo(Item.body(1, 2));
        assertThat(visible.original(Item.body(2))).isEqualTo(Item.body(3));
        assertThat(visible.original(Item.light(0))).isEqualTo(Item.light(1));
        assertThat(((Csg) visible.scene().objects().get(0).shape()).operands()).extracting(operand -> ((Sphere) operand.solid()).radius())
                .containsExactly(2.0, 4.0);
    }

    @Test
    void nothingIsLeftOfADifferenceWithoutItsFirstNorOfAnOperationWithoutAny() {
        assertThat(without(Item.body(1, 0)).scene().objects()).hasSize(3).doesNotContain(SCENE.objects().get(1));
        List<BodyAt> both = List.of(Item.body(2, 0), Item.body(2, 1));
        assertThat(without(both.get(0), both.get(1)).scene().objects()).hasSize(3).doesNotContain(SCENE.objects().get(2));
        assertThat(without(both.get(0)).original(Item.body(2, 0))).isEqualTo(Item.body(2, 1));
    }
}
