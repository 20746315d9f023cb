package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.formula.FormulaException;
import cz.paprsek.formula.Written;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Formulas put where numbers stand, as the editor does. */
@Timeout(60)
class FormulatedTest {
    private static final String TEXT = """
            <?xml version="1.0"?>
            <!-- mine --><scene xmlns="urn:paprsek:scene:1">
              <param name='w' value='3'/> <camera position="0 0 9" target="0 0 0"/>
              <sphere  radius="1" position="0 {w/2} 5" /> <!-- ball -->
              <repeat count="2" position="3 0 0"><block min="0 0 0" max="1 1 1" position="{w} 0 0"/></repeat>
            </scene>
            """;

    @TempDir
    private Path folder;

    private static Scene radius(Scene scene, double value) {
        return scene.with(ScenePath.body(0), body -> body.withShape(new Sphere(value)));
    }

    private static Scene height(Scene scene, double value) {
        return scene.with(ScenePath.body(0), body -> body.placed(Placement.at(0, value, 0)));
    }

    @Test
    void aFormulaIsPutWhereANumberStandsAndAllElseStays() throws Exception {
        Path file = Files.writeString(folder.resolve("mine.xml"), TEXT);
        SceneFile opened = SceneFiles.open(file);
        Scene made = SceneFiles.withFormula(opened.scene(), value -> radius(opened.scene(), value), "w*w < 1 ? 2 : w - 1");
        assertThat(made.objects().get(0).shape()).isEqualTo(new Sphere(2));
        opened.save(made);
        assertThat(file).hasContent(TEXT.replace("radius=\"1\"", "radius=\"{w*w &lt; 1 ? 2 : w - 1}\""));
        assertThat(SceneFiles.with(made, Map.of("w", "5")).objects().get(0).shape()).isEqualTo(new Sphere(4));
    }

    /** What is repeated stays so, and all copies have the formula of the first; one in another copy is its own. */
    @Test
    void copiesFollowTheFormulaOfTheFirst() throws Exception {
        Scene row = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 9' target='0 0 0'/><param name='r' value='0.5'/>"
                + "<repeat name='row' count='3' position='2 0 0'><sphere radius='{r}'/></repeat>"
                + "<difference><sphere radius='4'/><repeat count='2' position='2 0 0'><sphere radius='1'/></repeat></difference></scene>");
        for (String formula : List.of("r*1.4", "r")) {
            Scene made = SceneFiles.withFormula(row, value -> radius(row, value), formula);
            assertThat(made.recipe().text()).contains("<repeat name=\"row\" count=\"3\"", "<sphere radius=\"{" + formula + "}\"/>");
            double radius = formula.equals("r") ? 0.5 : 0.7;
            assertThat(made.objects().subList(0, 3)).extracting(SceneObject::shape).containsOnly(new Sphere(radius));
            assertThat(SceneFiles.with(made, Map.of("r", "1")).objects().subList(0, 3)).extracting(SceneObject::shape).containsOnly(new Sphere(2 * radius));
        }
        ScenePath.BodyAt inside = ScenePath.body(3, 1, 0);
        Scene operands = SceneFiles.withFormula(row, value -> row.with(inside, body -> body.withShape(new Sphere(value))), "r/2");
        assertThat(operands.recipe().text()).contains("<repeat count=\"2\"", "radius=\"{r/2}\"");
        Scene second = SceneFiles.withFormula(row, value -> row.with(ScenePath.body(1), body -> body.withShape(new Sphere(value))), "r*3");
        assertThat(second.objects().subList(0, 3)).extracting(SceneObject::shape).containsExactly(new Sphere(0.5), new Sphere(1.5), new Sphere(0.5));
    }

    /** As if it had been written in the file: each copy has what the formula comes to with its number, also in the place of another such formula. */
    @Test
    void theNumberOfACopyMayStandInAFormulaOfTheFirst() throws Exception {
        String text = "<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 9' target='0 0 0'/><param name='r' value='0.5'/><sphere name='aside' radius='1'/>"
                + "<repeat name='row' count='3' position='2 0 0'><sphere radius='RADIUS' position='0 0 1'/></repeat></scene>";
        Scene row = SceneFiles.parse(text.replace("RADIUS", "0.4"));
        ScenePath.BodyAt first = ScenePath.body(1);
        Scene made = row;
        for (String formula : List.of("r+i/10", "r*(i+1)", "i % 2 == 0 ? 1 : r")) {
            Scene from = made;
            made = SceneFiles.withFormula(from, value -> from.with(first, body -> body.withShape(new Sphere(value))), formula);
            assertThat(made.withRecipe(Recipe.NONE)).isEqualTo(SceneFiles.parse(text.replace("RADIUS", "{" + formula + "}")).withRecipe(Recipe.NONE));
            assertThat(made.recipe().text()).contains("<repeat name=\"row\" count=\"3\"", "radius=\"{" + formula + "}\"");
            assertThat(SceneFiles.formulas(made).get(Optional.of(first))).extracting(Written::formula).containsExactly(formula);
            assertThat(SceneFiles.settled(made)).as("nothing is left to do").isSameAs(made);
        }
        Scene high = made;
        Scene raised = SceneFiles.withFormula(high, value -> high.with(first, body -> body.placed(Placement.at(0, value, 1))), "i*i");
        assertThat(raised.objects().subList(1, 4)).extracting(object -> object.placement().position()).containsExactly(new Vec3(0, 0, 1), new Vec3(2, 1, 1), new Vec3(4, 4, 1));
    }

    @Test
    void copiesWithinCopiesKnowBothNumbersAndOthersNone() throws Exception {
        Scene grid = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 9' target='0 0 0'/><sphere radius='1'/>"
                + "<difference><sphere radius='4'/><repeat count='2' index='k' position='0 2 0'><repeat count='2' position='2 0 0'><sphere radius='1'/></repeat></repeat></difference></scene>");
        ScenePath.BodyAt first = ScenePath.body(1, 1, 0, 0);
        Scene made = SceneFiles.withFormula(grid, value -> grid.with(first, body -> body.withShape(new Sphere(value))), "1 + k/2 + i/4");
        assertThat(made.recipe().text()).contains("index=\"k\"", "radius=\"{1 + k/2 + i/4}\"");
        assertThat(List.of(ScenePath.body(1, 1, 0, 0), ScenePath.body(1, 1, 0, 1), ScenePath.body(1, 1, 1, 0), ScenePath.body(1, 1, 1, 1)))
                .extracting(at -> at.find(made).orElseThrow().shape()).containsExactly(new Sphere(1), new Sphere(1.25), new Sphere(1.5), new Sphere(1.75));
        assertThatThrownBy(() -> SceneFiles.withFormula(grid, value -> radius(grid, value), "2 + i")).isInstanceOfSatisfying(FormulaException.class, wrong -> assertThat(wrong.column()).isEqualTo(5))
                .hasMessageContaining("\"i\" is not a number");
        assertThatThrownBy(() -> SceneFiles.withFormula(grid, value -> grid.with(first, body -> body.withShape(new Sphere(value))), "1 - i"))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("above 0").hasMessageNotContaining("\"i\"");
    }

    @Test
    void theOtherNumbersOfAnAttributeKeepTheirs() throws Exception {
        Scene scene = SceneFiles.parse(TEXT);
        Scene moved = SceneFiles.settled(scene.with(ScenePath.body(0), body -> body.placed(Placement.at(7, 1.5, 5))));
        assertThat(moved.recipe().text()).contains("position=\"7 {w/2} 5\"");
        Scene over = SceneFiles.settled(scene.with(ScenePath.body(0), body -> body.placed(Placement.at(0, 2, 5))));
        assertThat(over.recipe().text()).contains("position=\"0 2 5\"");
    }

    @Test
    void aSceneWithoutFormulasGetsItsFirst() {
        Scene plain = Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).named("b2").at(4, 0, 0).madeOf(Material.DEFAULT), SceneObject.of(new Sphere(1)).at(0, 1, 0));
        Scene made = SceneFiles.withFormula(plain, value -> height(plain, value), "1 / 3");
        assertThat(made.withRecipe(Recipe.NONE)).isEqualTo(height(plain, 1.0 / 3));
        assertThat(SceneFiles.format(made)).contains("position=\"0 {1 / 3} 0\"");
        assertThat(SceneFiles.formulas(made)).containsExactly(Map.entry(Optional.of(ScenePath.body(0)),
                List.of(new Written(List.of(), "position", 1, 3, "1 / 3", "0.3333333333333333"))));
        Scene usual = SceneFiles.withFormula(made, value -> height(made, value), "0");
        assertThat(SceneFiles.format(usual)).contains("position=\"0 {0} 0\"");
        assertThat(usual.objects().get(0).placement().position()).isEqualTo(Vec3.ZERO);
    }

    @Test
    void mistakesAreToldByTheirColumnAndRefusalsInTheRecordsWords() throws SceneFileException {
        Scene scene = SceneFiles.parse(TEXT);
        assertThatThrownBy(() -> SceneFiles.withFormula(scene, value -> radius(scene, value), "w + q")).isInstanceOfSatisfying(FormulaException.class, wrong ->
                assertThat(wrong.column()).isEqualTo(5)).hasMessageContaining("\"q\" is not a number");
        assertThatThrownBy(() -> SceneFiles.withFormula(scene, value -> radius(scene, value), "-w")).hasMessageContaining("above 0, but is -3");
    }

    @Test
    void formulasAreFoundByWhatHasThem() throws SceneFileException {
        Map<Optional<ScenePath>, List<Written>> found = SceneFiles.formulas(SceneFiles.parse(TEXT));
        assertThat(found.get(Optional.of(ScenePath.body(0)))).containsExactly(new Written(List.of(), "position", 1, 3, "w/2", "1.5"));
        assertThat(found.get(Optional.of(ScenePath.body(1)))).containsExactly(new Written(List.of(), "position", 0, 3, "w", "3"));
        assertThat(SceneFiles.formulas(Scene.EMPTY)).isEmpty();
    }
}
