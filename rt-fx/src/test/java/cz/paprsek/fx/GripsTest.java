package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Text;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Labeled;
import javafx.scene.control.TextField;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.Test;

/** The numbers of cameras, lights and repeats, pulled in the projections; parameters by their sliders, and definitions. The picture is twice as wide as high; the camera, at z = 4, looks at the origin. */
class GripsTest extends InProjections {
    private static final Camera CAMERA = Camera.lookingAt(new Vec3(0, 0, 4), Vec3.ZERO);
    private static final Scene SCENE = Scene.EMPTY.withSettings(new RenderSettings(200, 100, 5, 1)).withCamera(CAMERA)
            .plus(Light.at(-3, 5, 3)).plus(SceneObject.of(new Sphere(1)).named("ball"));
    private static final double TAN_HALF = Math.tan(Math.toRadians(22.5));

    private static final Scene ROW = parsed("""
            <scene xmlns="urn:paprsek:scene:1">
              <param name="n" value="4" min="1" max="9" step="1"/>
              <param name="d" value="3" min="1" max="9"/>
              <camera position="0 2 19" target="0 0 0"/>
              <repeat name="ball" count="{n}" position="{d} 0 {d*0}"><sphere radius="1"/></repeat>
            </scene>""");

    private static Scene parsed(String text) {
        try {
            return SceneFiles.parse(text);
        } catch (SceneFileException e) {
            throw new IllegalStateException(e);
        }
    }

    @Override
    Scene scene() {
        return SCENE;
    }

    @Test
    void theFieldOfViewIsPulledByTheUpperEdgeOfWhatIsSeen() {
        seenThrough(CAMERA);
        drag("right", new Vec3(0, 4 * TAN_HALF, 0), new Vec3(0, 4 * Math.tan(Math.toRadians(30)), 0));
        assertThat(lens(Lens.Perspective.class).fovy()).isCloseTo(60, within(1.0));
        assertThat(lens(Lens.Perspective.class).fovy() * 2).as("to be read").isEqualTo(Math.rint(lens(Lens.Perspective.class).fovy() * 2));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene().camera()).as("one step").isEqualTo(CAMERA);
    }

    @Test
    void fromAboveItIsPulledByTheRightEdge() {
        seenThrough(CAMERA);
        drag("top", new Vec3(2 * 4 * TAN_HALF, 0, 0), new Vec3(2 * 4 * Math.tan(Math.toRadians(10)), 0, 0));
        assertThat(lens(Lens.Perspective.class).fovy()).isCloseTo(20, within(1.0));
    }

    @Test
    void aParallelPictureIsMadeHigherByItsEdge() {
        seenThrough(CAMERA.withLens(new Lens.Orthographic(3)));
        drag("front", new Vec3(0, 1.5, 0), new Vec3(0, 2.5, 0));
        assertThat(lens(Lens.Orthographic.class).height()).isCloseTo(5, within(0.2));
        drag("front", new Vec3(0, lens(Lens.Orthographic.class).height() / 2, 0), new Vec3(0, -3, 0));
        assertThat(lens(Lens.Orthographic.class).height()).as("never nothing").isBetween(1e-4, 0.1);
    }

    @Test
    void whatIsSharpIsPulledAlongTheEdgeOfTheView() {
        seenThrough(CAMERA.withLens(Lens.Perspective.DEFAULT.withAperture(0.1)));
        drag("right", new Vec3(0, -4 * TAN_HALF, 0), new Vec3(0, -2 * TAN_HALF, 2));
        assertThat(lens(Lens.Perspective.class).focus()).isCloseTo(2, within(0.1));
        assertThat(lens(Lens.Perspective.class).fovy()).isEqualTo(45);
        editor.gui.act(() -> editor.editor.snapping().set(true));
        drag("right", new Vec3(0, -2 * TAN_HALF, 2), new Vec3(0, -3 * TAN_HALF, 1));
        assertThat(lens(Lens.Perspective.class).focus() * 10).as("on the grid").isCloseTo(30, within(2.1)).isEqualTo(Math.rint(lens(Lens.Perspective.class).focus() * 10));
    }

    @Test
    void aPinholeHasNothingThatIsSharp() {
        seenThrough(CAMERA);
        drag("right", new Vec3(0, -4 * TAN_HALF, 0), new Vec3(0, -2 * TAN_HALF, 2));
        assertThat(editor.model().scene().camera()).isEqualTo(CAMERA);
    }

    @Test
    void aFisheyeIsMadeWiderByItsRim() {
        seenThrough(CAMERA.withLens(Lens.Fisheye.DEFAULT));
        drag("right", new Vec3(0, 4, 4), new Vec3(0, 2.83, 4 - 2.83));
        assertThat(lens(Lens.Fisheye.class).angle()).isCloseTo(90, within(2.0));
    }

    @Test
    void aSpotHasADotForEachOfItsAngles() {
        lit(SpotLight.from(new Vec3(-3, 4, 0), new Vec3(-3, 2, 0)));
        double inner = 2 * Math.tan(Math.toRadians(30));
        // Seen from the front, the light shining down, the outer angle has its dot to the right and the inner one to the left.
        drag("front", new Vec3(-3 - inner, 2, 0), new Vec3(-3 - 2 * Math.tan(Math.toRadians(10)), 2, 0));
        assertThat(spot().innerAngle()).isCloseTo(10, within(1.5));
        assertThat(spot().outerAngle()).isEqualTo(45);
        drag("front", new Vec3(-3 - 2 * Math.tan(Math.toRadians(spot().innerAngle())), 2, 0), new Vec3(-7, 2, 0));
        assertThat(spot().innerAngle()).as("never wider than the outer one").isEqualTo(45);
        drag("front", new Vec3(-1, 2, 0), new Vec3(-2, 2, 0));
        assertThat(spot().outerAngle()).isCloseTo(26.5, within(1.5));
        assertThat(spot().innerAngle()).as("in proportion").isCloseTo(spot().outerAngle(), within(0.5));
    }

    @Test
    void nothingJumpsWhereADotStandsApart() {
        lit(SunLight.along(0, -4, 0));
        ProjectionPane front = editor.projection("front");
        Point2D dot = EditorGui.place(front, 0, 4, 0).add(-18, 0);
        editor.gui.drag(front, dot.getX(), dot.getY(), dot.getX() - 4, dot.getY());
        assertThat(((SunLight) light()).angle()).isBetween(0.5, 8.0);
    }

    @Test
    void theNumberStandsBesideTheMouseAndEscapeGivesItUp() {
        seenThrough(CAMERA.withLens(Lens.Perspective.DEFAULT.withAperture(0.15).withFocus(3)));
        editor.gui.act(() -> editor.editor.theme().set(Theme.DARK));
        ProjectionPane right = editor.projection("right");
        Point2D from = EditorGui.place(right, 0, 4 * TAN_HALF, 0);
        WritableImage before = Gui.on(() -> right.snapshot(null, null));
        editor.gui.moveTo(right, from.getX(), from.getY());
        editor.gui.press(MouseButton.PRIMARY);
        editor.gui.moveTo(right, from.getX(), from.getY() - 10);
        editor.gui.moveTo(right, from.getX(), from.getY() - 20);
        assertThat(Screenshots.save(editor.gui, "grips-camera")).isNotEmptyFile();
        WritableImage now = Gui.on(() -> right.snapshot(null, null));
        assertThat(different(before, now, from.getX() + 16, from.getY() - 46, 90, 14)).as("letters beside the mouse").isGreaterThan(40);
        assertThat(lens(Lens.Perspective.class).fovy()).isGreaterThan(45);
        editor.gui.keys(KeyCode.ESCAPE);
        editor.gui.release(MouseButton.PRIMARY);
        assertThat(lens(Lens.Perspective.class).fovy()).isEqualTo(45);
        lit(SpotLight.from(new Vec3(-3, 4, 0), new Vec3(-2, 1, 0)).withAngles(12, 30));
        assertThat(Screenshots.save(editor.gui, "grips-spot")).isNotEmptyFile();
    }

    @Test
    void aBodyIsTurnedAboutItsMiddleUnlessItsPivotIsPutElsewhere() {
        SceneObject bowl = SceneObject.of(Csg.difference(Operand.of(new Sphere(1)).at(2, 1, 0), Operand.of(new Block(new Vec3(-2, 0, -2), new Vec3(2, 2, 2))).at(2, 1, 0)));
        change(SCENE.withObjects(List.of(bowl)), ScenePath.body(0));
        type("#placement-rotation-z", "90");
        assertThat(world(new Vec3(2, 1, 0))).as("its middle stays, by numbers").isEqualTo(new Vec3(2, 1, 0));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        editor.menu("object-pivot");
        drag("front", new Vec3(2, 1, 0), new Vec3(3, 1, 0));
        assertThat(body().pivot()).isInstanceOfSatisfying(Placement.Point.class, point -> assertThat(point.pivot().minus(new Vec3(3, 1, 0)).length()).isLessThan(0.05));
        assertThat(body().placement()).as("nothing else is moved").isEqualTo(bowl.placement());
        assertThat(Screenshots.save(editor.gui, "pivot")).isNotEmptyFile();
        Vec3 pivot = ((Placement.Point) body().pivot()).pivot();
        type("#placement-rotation-z", "90");
        assertThat(world(pivot).minus(pivot).length()).isLessThan(1e-9);
        editor.menu("object-pivot");
        assertThat(body().pivot()).isEqualTo(Placement.MIDDLE);
    }

    @Test
    void handlesOfARepeatChangeItsNumbersInTheFile() {
        ProjectionPane front = editor.projection("front");
        editor.gui.act(() -> editor.model().open(ROW));
        editor.gui.act(() -> editor.model().select(ScenePath.body(0)));
        editor.gui.act(front::fitAll);
        editor.gui.act(() -> front.zoom(0.5));
        drag(front, new Vec3(10.5, 0, 0), new Vec3(16.5, 0, 0));
        assertThat(editor.model().scene().objects()).as("two more").hasSize(6);
        assertThat(fileText()).contains("count=\"6\"", "position=\"{d} 0 {d*0}\"");
        drag(front, new Vec3(3, 0, 0), new Vec3(3, 2, 0));
        assertThat(position(ScenePath.body(1)).y()).isCloseTo(2, within(0.1));
        assertThat(position(ScenePath.body(5)).y()).isCloseTo(10, within(0.5));
        assertThat(fileText()).contains("count=\"6\"", " {d*0}\"").doesNotContain(" 0 {d*0}\"");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene()).isSameAs(ROW);
    }

    @Test
    void theSliderOfASignsParameterMakesAnotherSign() throws Exception {
        Scene sign = SceneFiles.read(Path.of("../scenes/sign.xml"));
        editor.gui.act(() -> editor.model().open(sign));
        editor.gui.act(() -> editor.model().select());
        Node slider = editor.gui.node("#parameter-slider-size");
        double width = slider.getLayoutBounds().getWidth();
        double middle = slider.getLayoutBounds().getHeight() / 2;
        // From 0.8 of 0.3–0.9 to its begin.
        editor.gui.drag(slider, width * 0.83, middle, 2, middle);
        assertThat(editor.model().scene().recipe().parameters().get(0).formula()).isEqualTo("0.3");
        Scene wanted = SceneFiles.read(Path.of("../scenes/sign.xml"), Map.of("size", "0.3"));
        assertThat(editor.model().scene().objects()).isEqualTo(wanted.objects());
        assertThat(fileText()).contains("name=\"size\" value=\"0.3\"", "size=\"{1.3*size}\"");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene()).as("one step").isSameAs(sign);
    }

    @Test
    void whatIsSelectedBecomesADefinitionAndIsUsedAgain() throws Exception {
        Scene scene = parsed("""
                <scene xmlns="urn:paprsek:scene:1"><camera position="0 2 9" target="0 0 0"/><disc radius="9"/>
                <difference name="bowl" position="1 0.1 0" rotation="0 0 33"><sphere radius="1"/><block min="-2 0 -2" max="2 2 2"/></difference></scene>""");
        editor.gui.act(() -> editor.model().open(scene));
        editor.gui.act(() -> editor.model().select(ScenePath.body(1)));
        assertThatThrownBy(() -> editor.menu("object-another")).hasStackTraceContaining("is disabled");
        editor.menu("object-define");
        Scene defined = editor.model().scene();
        assertThat(defined.withRecipe(Recipe.NONE)).as("the same picture").isEqualTo(scene.withRecipe(Recipe.NONE));
        assertThat(fileText()).contains("<define name=\"bowl\">", "<instance of=\"bowl\" name=\"bowl\" position=\"1 0.1 0\" rotation=\"0 0 33\"");
        editor.menu("object-another");
        assertThat(editor.model().scene().objects()).hasSize(3);
        Path file = folder.resolve("bowls.xml");
        editor.dialogs.save = Optional.of(file);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        editor.gui.until("saved", () -> Files.exists(file));
        assertThat(Files.readString(file)).contains("<define name=\"bowl\">").containsPattern("(?s)<instance of=\"bowl\".*<instance of=\"bowl\"");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene()).isSameAs(scene);
    }

    @Test
    void aTextHasOneOfTheFontsOrThatOfAFile() throws Exception {
        editor.gui.act(() -> editor.model().open(parsed("<scene xmlns='urn:paprsek:scene:1'><camera position='0 2 9' target='0 0 0'/><text value='Ab' size='1' depth='0.2'/></scene>")));
        editor.gui.act(() -> editor.model().select(ScenePath.body(0)));
        ComboBox<?> fonts = (ComboBox<?>) editor.gui.node("#shape-font");
        editor.gui.act(fonts::requestFocus);
        editor.gui.keys(KeyCode.SPACE);
        editor.gui.keys(KeyCode.DOWN);
        editor.gui.keys(KeyCode.DOWN);
        editor.gui.keys(KeyCode.ENTER);
        assertThat(font()).isEqualTo("serif");
        editor.gui.act(() -> fonts.getSelectionModel().selectLast());
        editor.gui.until("why not", () -> editor.gui.stage().getScene().getRoot().lookupAll(".refusal").stream().anyMatch(node -> ((Labeled) node).getText().startsWith("Save the scene first")));
        assertThat(fonts.getValue()).as("still").isEqualTo("serif");
        Path file = folder.resolve("letters.xml");
        editor.dialogs.save = Optional.of(file);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        editor.gui.until("saved", () -> Files.exists(file));
        editor.dialogs.chosen = Optional.of(Files.copy(Path.of("../rt-core/src/main/resources/cz/paprsek/shape/font/sans-bold.ttf"), folder.resolve("own.ttf")));
        editor.gui.act(() -> fonts.getSelectionModel().selectLast());
        assertThat(font()).isEqualTo("own.ttf");
        editor.gui.until("shown", () -> "own.ttf".equals(fonts.getValue()));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(font()).isEqualTo("serif");
    }

    private String font() {
        return ((Text) body().shape()).font();
    }

    private String fileText() {
        return SceneFiles.format(editor.model().scene());
    }

    private void type(String field, String text) {
        editor.gui.click(field);
        editor.gui.act(() -> ((TextField) editor.gui.node(field)).setText(text));
        editor.gui.keys(KeyCode.ENTER);
    }

    private SceneObject body() {
        return editor.model().scene().objects().get(0);
    }

    private Vec3 world(Vec3 own) {
        return body().placement().toParent().point(own);
    }

    private static int different(WritableImage a, WritableImage b, double x, double y, int width, int height) {
        int found = 0;
        for (int i = 0; i < width; i++) {
            for (int j = 0; j < height; j++) {
                Color one = a.getPixelReader().getColor((int) x + i, (int) y + j);
                found += one.equals(b.getPixelReader().getColor((int) x + i, (int) y + j)) ? 0 : 1;
            }
        }
        return found;
    }

    private void seenThrough(Camera camera) {
        change(SCENE.withCamera(camera), ScenePath.camera());
    }

    private void lit(Light light) {
        change(SCENE.withLights(List.of(light)), ScenePath.light(0));
    }

    private void change(Scene scene, ScenePath selected) {
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.CHANGE), old -> scene));
        editor.gui.act(() -> editor.model().select(selected));
        for (String axes : new String[] {"front", "top", "right"}) {
            editor.gui.act(() -> {
                editor.projection(axes).fitAll();
                editor.projection(axes).zoom(0.7);
            });
        }
    }

    private void drag(String axes, Vec3 from, Vec3 to) {
        drag(editor.projection(axes), from, to);
    }

    private <L extends Lens> L lens(Class<L> kind) {
        return kind.cast(editor.model().scene().camera().lens());
    }

    private Light light() {
        return editor.model().scene().lights().get(0);
    }

    private SpotLight spot() {
        return (SpotLight) light();
    }
}
