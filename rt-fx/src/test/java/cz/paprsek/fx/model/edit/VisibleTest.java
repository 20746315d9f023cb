package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
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

    private static Visible without(ScenePath... hidden) {
        return Visible.of(EditorState.of(SCENE).withHidden(Set.of(hidden)));
    }

    @Test
    void withNothingHiddenItIsTheVerySceneAndEverythingStandsWhereItStands() {
        assertThat(without().scene()).isSameAs(SCENE);
        assertThat(without().original(ScenePath.body(1, 2))).isEqualTo(ScenePath.body(1, 2));
    }

    @Test
    void whatIsAnimatedMayBeHidden() {
        Scene moving = SCENE.withAnimations(List.of(new Animation("sphere#1", "radius", Animation.Turning.ANGLES, List.of(new Animation.Key(0, "1", Animation.Ease.LINEAR)))));
        Visible visible = Visible.of(EditorState.of(moving).withHidden(Set.of(ScenePath.body(0))));
        assertThat(visible.scene().objects()).hasSize(3);
        assertThat(Visible.of(EditorState.of(moving)).scene()).isSameAs(moving);
    }

    @Test
    void whatIsAfterSomethingHiddenIsFoundAgain() {
        Visible visible = without(ScenePath.body(0), ScenePath.body(1, 1), ScenePath.light(0));
        assertThat(visible.scene().objects()).hasSize(3).last().isSameAs(SCENE.objects().get(3));
        assertThat(visible.scene().lights()).containsExactly(SCENE.lights().get(1));
        assertThat(visible.original(ScenePath.body(0, 1))).isEqualTo(ScenePath.body(1, 2));
        assertThat(visible.original(ScenePath.body(2))).isEqualTo(ScenePath.body(3));
        assertThat(visible.original(ScenePath.light(0))).isEqualTo(ScenePath.light(1));
        assertThat(((Csg) visible.scene().objects().get(0).shape()).operands()).extracting(operand -> ((Sphere) operand.solid()).radius())
                .containsExactly(2.0, 4.0);
    }

    @Test
    void whatADifferenceIsWithoutIsSeenWhereItsFirstIsHiddenButNothingWhereThatIsAway() {
        assertThat(without(ScenePath.body(1, 0)).scene().objects()).hasSize(4).contains(csg(Operation.UNION, 3, 4));
        EditorState base = EditorState.of(SCENE).withHidden(Set.of(ScenePath.body(1, 0)));
        assertThat(Visible.of(EditorState.of(SCENE), base.hidden()).scene().objects()).hasSize(3).doesNotContain(SCENE.objects().get(1));
        assertThat(Visible.of(base, base.hidden()).scene().objects()).hasSize(3);
        List<BodyAt> both = List.of(ScenePath.body(2, 0), ScenePath.body(2, 1));
        assertThat(without(both.get(0), both.get(1)).scene().objects()).hasSize(3).doesNotContain(SCENE.objects().get(2));
        assertThat(without(both.get(0)).original(ScenePath.body(2, 0))).isEqualTo(ScenePath.body(2, 1));
    }
}
