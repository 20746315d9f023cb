package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.formula.Maker;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What is repeated, changed as one thing. */
@Timeout(60)
class RepeatsTest {
    @TempDir
    private Path folder;

    private static Scene scene(String inside) throws SceneFileException {
        return SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 9' target='0 0 0'/>" + inside + "</scene>");
    }

    private static Scene moved(Scene scene, BodyAt at, double x, double y, double z) {
        return SceneFiles.following(scene.with(at, body -> body.placed(body.placement().withPosition(new Vec3(x, y, z)))));
    }

    @Test
    void allCopiesFollowTheFirst() throws SceneFileException {
        Scene row = scene("<param name='d' value='2'/><repeat count='4' position='{d} 0 0'><sphere name='ball' radius='{d/4}' position='0 {d} 0'/></repeat>");
        Scene lower = moved(row, ScenePath.body(0), 0, 1, 0);
        assertThat(lower.objects()).extracting(object -> object.placement().position()).containsExactly(new Vec3(0, 1, 0), new Vec3(2, 1, 0), new Vec3(4, 1, 0), new Vec3(6, 1, 0));
        assertThat(lower.recipe().text()).contains("<repeat count=\"4\" position=\"{d} 0 0\">", "radius=\"{d/4}\" position=\"0 1 0\"");
        Scene named = SceneFiles.following(row.with(ScenePath.body(0), body -> body.named("pearl[0]")));
        assertThat(named.objects()).extracting(SceneObject::name).containsExactly("pearl[0]", "pearl[1]", "pearl[2]", "pearl[3]");
        assertThat(SceneFiles.following(row.withObjects(row.objects().subList(1, 4))).objects()).isEmpty();
        Scene more = SceneFiles.following(row.plus(SceneObject.of(new Sphere(3)).named("new")));
        assertThat(more.objects()).hasSize(5);
        assertThat(more.recipe().text()).contains("<repeat", "name=\"new\"");
    }

    @Test
    void operandsFollowAndWhatStandsAsAWholeIsPutIntoSomething() throws SceneFileException {
        Scene gear = scene("<difference name='g'><cylinder radius='2' height='1'/><repeat name='holes' count='3' rotation='0 120 0'><cylinder radius='0.2' height='3' position='1 -1 0'/></repeat></difference>");
        Scene wider = SceneFiles.following(gear.with(ScenePath.body(0, 1, 0), body -> body.placed(Placement.at(1.5, -1, 0))));
        assertThat(wider.recipe().text()).contains("position=\"1.5 -1 0\"", "<repeat name=\"holes\" count=\"3\" rotation=\"0 120 0\">");
        assertThat(ScenePath.body(0, 1, 2).in(wider).placement()).isEqualTo(ScenePath.body(0, 1, 2).in(gear).placement().withPosition(
                Placement.NONE.withRotation(new Vec3(0, 240, 0)).toParent().point(new Vec3(1.5, -1, 0))));
        Scene whole = SceneFiles.following(gear.with(ScenePath.body(0, 1), body -> body.placed(Placement.at(0, 0.5, 0)).named("bores")));
        assertThat(whole.recipe().text()).contains("<union position=\"0 0.5 0\">", "<repeat name=\"bores\" count=\"3\"");
        assertThat(SceneFiles.parse(SceneFiles.format(whole))).isEqualTo(whole);
    }

    @Test
    void whatEachCopyHasOfItsOwnIsNotOverwritten() throws SceneFileException {
        Scene steps = scene("<repeat count='3'><sphere radius='1' position='{3*i} 0 0'/></repeat>");
        assertThatThrownBy(() -> moved(steps, ScenePath.body(0), 1, 0, 0)).hasMessage("each copy has a position of its own, by {3*i}; change that formula instead");
        assertThat(moved(steps, ScenePath.body(0), 0, 2, 0).objects()).extracting(object -> object.placement().position())
                .containsExactly(new Vec3(0, 2, 0), new Vec3(3, 2, 0), new Vec3(6, 2, 0));
    }

    @Test
    void instancesWithinRepeatsStayInstances() throws SceneFileException {
        Scene wood = scene("<define name='tree'><union><sphere radius='1'/></union></define><repeat name='t' count='2' position='5 0 0'><instance of='tree'/></repeat><instance of='tree' position='0 0 9'/>");
        Scene moved = moved(wood, ScenePath.body(0), 0, 1, 0);
        assertThat(moved.recipe().text()).contains("<instance of=\"tree\" position=\"0 1 0\"/>", "<instance of=\"tree\" position=\"0 0 9\"/>");
        assertThat(moved.objects().get(1).placement().position()).isEqualTo(new Vec3(5, 1, 0));
        assertThat(moved(wood, ScenePath.body(2), 1, 1, 1).recipe().text()).contains("<instance of=\"tree\" position=\"1 1 1\"/>");
    }

    @Test
    void makersSayWhatIsMadeByWhat() throws SceneFileException {
        Scene scene = scene("<sphere radius='1'/><repeat name='a' count='2' position='0 0 5'><repeat count='3' position='2 0 0' index='j'><sphere radius='1'/><disc radius='1'/></repeat></repeat>"
                + "<union><block min='0 0 0' max='1 1 1'/><repeat count='4' rotation='0 90 0'><sphere radius='1' position='3 0 0'/></repeat></union>");
        List<Maker> makers = SceneFiles.makers(scene);
        assertThat(makers).extracting(Maker::count).containsExactly(2, 3, 4);
        assertThat(makers.get(0).originals()).hasSize(6).startsWith(List.of(1));
        assertThat(makers.get(1).originals()).containsExactly(List.of(1), List.of(2));
        assertThat(makers.get(1).copies()).hasSize(6);
        assertThat(makers.get(2).whole()).containsExactly(13, 1);
        assertThat(makers.get(2).originals()).containsExactly(List.of(13, 1, 0));
        Scene more = SceneFiles.withMaker(scene, 1, "count", "{2 + 2}");
        assertThat(more.objects()).hasSize(18);
        assertThat(more.recipe().text()).contains("count=\"{2 + 2}\"");
        assertThatThrownBy(() -> SceneFiles.withMaker(scene, 1, "count", "-1")).hasMessageContaining("whole number from 0");
        assertThat(SceneFiles.makers(Scene.EMPTY)).isEmpty();
    }

    @Test
    void whatStandsSideBySideIsRepeated() throws Exception {
        Path file = Files.writeString(folder.resolve("two.xml"), "<scene xmlns='urn:paprsek:scene:1'>\n <!-- one --><camera position='0 0 9' target='0 0 0'/>\n <sphere radius='1'/> <disc radius='2'/>\n</scene>\n");
        SceneFile opened = SceneFiles.open(file);
        Scene row = SceneFiles.repeated(opened.scene(), List.of(List.of(0), List.of(1)), Map.of("count", "3", "position", "4 0 0"));
        assertThat(row.objects()).hasSize(6);
        opened.save(row);
        assertThat(Files.readString(file)).contains("<!-- one -->", "<repeat", "count=\"3\"");
        assertThat(SceneFiles.read(file).withRecipe(Recipe.NONE)).isEqualTo(row.withRecipe(Recipe.NONE));
        Scene inside = scene("<union><sphere radius='1'/></union><disc radius='1'/>");
        assertThatThrownBy(() -> SceneFiles.repeated(inside, List.of(List.of(0, 0), List.of(1)), Map.of("count", "3"))).hasMessageContaining("side by side");
        List<Integer> operand = new ArrayList<>(List.of(0, 0));
        assertThat(SceneFiles.repeated(inside, List.of(operand), Map.of("count", "3", "position", "1 0 0")).recipe().text()).contains("<repeat");
    }
}
