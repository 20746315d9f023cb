package cz.paprsek.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.scene.SceneDatabase.Clash;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import java.util.List;
import org.junit.jupiter.api.Test;

class SceneDatabaseTest {
    private static final Scene ONE = Scene.EMPTY.withName("one");
    private static final Scene TWO = Scene.EMPTY.withName("two").plus(Light.at(1, 2, 3));
    private static final Scene THREE = Scene.EMPTY.withName("three");
    private static final SceneDatabase BOTH = SceneDatabase.EMPTY.plus(ONE, TWO);

    @Test
    void scenesAreKnownByNameAndKeepTheirOrder() {
        assertThat(BOTH.scenes()).containsExactly(ONE, TWO);
        assertThat(BOTH.find("two")).contains(TWO);
        assertThat(BOTH.plus(THREE).names()).containsExactly("one", "two", "three");
        assertThat(BOTH.size()).isEqualTo(2);
        assertThatThrownBy(() -> BOTH.get("tow")).hasMessage("there is no scene named \"tow\"; did you mean \"two\"?");
    }

    @Test
    void aNameIsNeededAndCanBeTakenOnce() {
        assertThatThrownBy(() -> BOTH.plus(Scene.EMPTY)).hasMessageContaining("needs a name");
        assertThatThrownBy(() -> BOTH.plus(THREE, ONE)).hasMessageContaining("already a scene named \"one\"");
        assertThatThrownBy(() -> BOTH.rename("one", "two")).hasMessageContaining("already a scene named \"two\"");
        assertThatThrownBy(() -> BOTH.rename("one", "a\u001bb")).hasMessageContaining("control characters");
        assertThatThrownBy(() -> BOTH.without(List.of("two", "four"))).hasMessageContaining("no scene named \"four\"");
    }

    @Test
    void aChangeGivesANewDatabaseAndLeavesTheOldOne() {
        assertThat(BOTH.rename("one", "first").names()).containsExactly("first", "two");
        assertThat(BOTH.replace("one", THREE).scenes()).containsExactly(THREE, TWO);
        assertThat(BOTH.without(List.of("one")).scenes()).containsExactly(TWO);
        assertThat(BOTH.scenes()).containsExactly(ONE, TWO);
    }

    @Test
    void twoDatabasesAreMergedAsIsWished() {
        Scene other = TWO.withDescription("another");
        SceneDatabase more = SceneDatabase.EMPTY.plus(other, THREE);
        assertThatThrownBy(() -> BOTH.merge(more, Clash.REFUSE)).hasMessage("both have different scenes named \"two\"");
        assertThat(BOTH.merge(more, Clash.KEEP).scenes()).containsExactly(ONE, TWO, THREE);
        assertThat(BOTH.merge(more, Clash.REPLACE).scenes()).containsExactly(ONE, other, THREE);
        assertThat(BOTH.merge(BOTH, Clash.REFUSE)).isEqualTo(BOTH).hasSameHashCodeAs(BOTH);
    }

    @Test
    void changesOfTwoPeopleComeTogetherUnlessTheyMeetInOneScene() {
        SceneDatabase mine = BOTH.replace("one", ONE.withDescription("mine"));
        SceneDatabase theirs = BOTH.without(List.of("two")).plus(THREE);
        assertThat(mine.rebase(BOTH, theirs).scenes()).containsExactly(ONE.withDescription("mine"), THREE);
        assertThat(mine.rebase(BOTH, mine)).isEqualTo(mine);
        SceneDatabase otherwise = BOTH.replace("one", ONE.withDescription("theirs"));
        assertThatThrownBy(() -> mine.rebase(BOTH, otherwise)).hasMessage("both changed \"one\"");
        assertThatThrownBy(() -> mine.rebase(BOTH, BOTH.without(List.of("one")))).hasMessage("both changed \"one\"");
    }

    @Test
    void partsAreFoundByKindAtAnyDepth() {
        Csg inner = Csg.intersection(Operand.of(new Torus(2, 1)).named("ring"), Operand.of(new Sphere(3)));
        Csg outer = Csg.difference(Operand.of(new Sphere(2)).named("ball"), Operand.of(inner));
        SceneDatabase database = SceneDatabase.of(List.of(ONE.plus(SceneObject.of(new Sphere(1)), SceneObject.of(outer).named("bowl")), TWO));
        assertThat(database.parts(Sphere.class).map(row -> row.part().text(row.scene()))).containsExactly("sphere#1", "bowl/ball", "bowl/intersection#2/sphere#2");
        assertThat(database.parts(Torus.class).map(row -> row.part().depth())).containsExactly(2);
        assertThat(database.parts().count()).isEqualTo(6);
        assertThat(database.lights().map(light -> light.scene().name())).containsExactly("two");
        assertThat(database.cameras()).hasSize(2);
        assertThat(database.materials()).isEmpty();
    }
}
