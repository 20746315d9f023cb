package cz.paprsek.fx.view.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Pattern.Stop;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.event.ActionEvent;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ColorPicker;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;

/** One window for all: what takes long is laying out its many fields for the first time. */
@TestInstance(Lifecycle.PER_CLASS)
class PropertySheetTest {
    private static final Material GLASS = Material.DEFAULT.withTransparency(0.8, 1.5);

    private static final Scene START = Scene.EMPTY
            .plus("steel", Material.color(180, 190, 200))
            .plus(Light.at(1, 2, 3).named("key"))
            .plus(SceneObject.of(new Sphere(0.5)).named("ball").madeOf(GLASS),
                    SceneObject.of(new Sphere(2)).named("moon").at(3, 0, 0).madeOf(Material.DEFAULT),
                    SceneObject.of(new Block(Vec3.ZERO, Vec3.ONE)).named("box").madeOf("steel"));
    private final EditorModel model = new EditorModel(START);
    private final Gui gui = Gui.show(() -> new PropertySheet(model, Texts.in(Locale.ENGLISH), new SimpleBooleanProperty(true), (kind, owner) -> java.util.Optional.empty(), new Clock(model)), 320, 900);

    @BeforeEach
    void selectTheBall() {
        gui.act(() -> model.open(START));
        select(ScenePath.body(0));
    }

    @AfterAll
    void close() {
        gui.close();
    }

    @Test
    void readyMaterialsAreForBodiesAndForTheScene() {
        assertThat(gui.stage().getScene().lookup("#ready-materials")).isNotNull();
        select(ScenePath.light(0));
        gui.until("a light has none", () -> gui.stage().getScene().lookup("#ready-materials") == null);
    }

    /** What is typed after a click takes the place of the number; after a second one it goes between its digits. */
    @Test
    void theFirstClickIntoANumberTakesAllOfIt() {
        TextField radius = (TextField) gui.node("#shape-radius");
        gui.click("#shape-radius");
        assertThat(Gui.on(radius::getSelectedText)).isEqualTo(shown("#shape-radius")).isNotEmpty();
        gui.click(radius, 6, 10);
        assertThat(Gui.on(radius::getSelectedText)).isEmpty();
    }

    @Test
    void typedNumberIsOneStepAndSumsAreWorkedOut() {
        type("#shape-radius", "1/4");
        assertThat(ball()).isEqualTo(new Sphere(0.25));
        assertThat(shown("#shape-radius")).isEqualTo("0.25");
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(START);
        gui.until("the field follows", () -> ((TextField) gui.stage().getScene().lookup("#shape-radius")).getText().equals("0.5"));
    }

    @Test
    void refusedValueTellsTheRecordsOwnSentenceAndChangesNothing() {
        type("#shape-radius", "-2");
        assertThat(model.scene()).isSameAs(START);
        assertThat(((Label) gui.node(".refusal")).getText()).isEqualTo("sphere radius must be a finite number above 0, but is -2");
        gui.keys(KeyCode.ESCAPE);
        assertThat(shown("#shape-radius")).isEqualTo("0.5");
        gui.until("nothing is refused any more", () -> gui.stage().getScene().getRoot().lookupAll(".refusal").stream().noneMatch(Node::isVisible));
    }

    /** The sheet itself must not be laid out for each digit that changes while something is dragged. */
    @Test
    void anotherNumberHasNothingAroundItsFieldLaidOutAnew() {
        NumberField field = (NumberField) gui.node("#shape-radius");
        gui.pulse();
        assertThat(Gui.on(() -> {
            field.show(START.withObjects(List.of(SceneObject.of(new Sphere(7.25)))));
            return field.getText() + " " + field.isNeedsLayout() + " " + field.getParent().isNeedsLayout();
        })).isEqualTo("7.25 true false");
    }

    @Test
    void numbersFollowADragAndAreRightAtItsEnd() {
        Gesture drag = Gui.on(() -> model.begin(cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.MOVE)));
        gui.act(() -> drag.preview(scene -> Moves.translated(scene, model.selection(), new Vec3(2.5, 0, 0))));
        gui.until("the field follows", () -> ((TextField) gui.node("#placement-position-x")).getText().equals("2.5"));
        gui.act(() -> {
            IntStream.rangeClosed(1, 50).forEach(i -> drag.preview(scene -> Moves.translated(scene, model.selection(), new Vec3(0.5 * i, 0, 0))));
            drag.commit();
        });
        gui.pulse();
        assertThat(shown("#placement-position-x")).isEqualTo("25");
    }

    @Test
    void undoReachesTheHistoryFromWithinAField() {
        type("#shape-radius", "3");
        gui.click("#shape-radius");
        gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(model.scene()).isSameAs(START);
        gui.keys(KeyCode.CONTROL, KeyCode.Y);
        assertThat(ball()).isEqualTo(new Sphere(3));
    }

    @Test
    void arrowKeysHeldDownAreOneStep() {
        gui.click("#shape-radius");
        gui.hold(KeyCode.UP);
        gui.act(() -> again(KeyCode.UP));
        gui.act(() -> again(KeyCode.UP));
        gui.letGo(KeyCode.UP);
        assertThat(ball()).isEqualTo(new Sphere(0.65));
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(START);
    }

    @Test
    void draggingTheLetterOfAnAxisIsOneStep() {
        Node letter = gui.node(".axis-y");
        gui.drag(letter, 5, 5, 45, 5);
        assertThat(model.scene().objects().get(0).placement().position()).isEqualTo(new Vec3(0, 1, 0));
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(START);
    }

    @Test
    void escapeGivesADragBack() {
        gui.click("#placement-position-y");
        gui.hold(KeyCode.UP);
        assertThat(model.scene()).isNotEqualTo(START);
        gui.keys(KeyCode.ESCAPE);
        gui.letGo(KeyCode.UP);
        assertThat(model.scene()).isSameAs(START);
        assertThat(model.undoableProperty().get()).isEmpty();
    }

    @Test
    void sliderMovementIsOneStep() {
        Slider slider = (Slider) gui.node("#transparency-slider");
        double width = Gui.on(slider::getWidth);
        gui.drag(slider, width * 0.8, 8, width * 0.2, 8);
        assertThat(material().transparency()).isBetween(0.05, 0.3);
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(START);
    }

    @Test
    void escapeGivesASliderAndADraggedLetterBack() {
        for (String handle : List.of("#transparency-slider .thumb", ".axis-y")) {
            Node node = gui.node(handle);
            gui.moveTo(node, 5, 5);
            gui.press(MouseButton.PRIMARY);
            gui.moveTo(node, -25, 5);
            assertThat(model.scene()).as(handle).isNotEqualTo(START);
            gui.keys(KeyCode.ESCAPE);
            assertThat(model.scene()).as(handle).isSameAs(START);
            gui.moveTo(node, -45, 5);
            gui.release(MouseButton.PRIMARY);
            assertThat(model.scene()).as(handle).isSameAs(START);
        }
    }

    @Test
    void severalAreChangedTogetherAndDifferencesAreShownAsSuch() {
        select(ScenePath.body(0), ScenePath.body(1));
        TextField radius = (TextField) gui.node("#shape-radius");
        assertThat(shown("#shape-radius")).isEmpty();
        assertThat(radius.getPromptText()).isEqualTo("mixed");
        type("#placement-position-y", "7");
        assertThat(model.scene().objects()).extracting(object -> object.placement().position())
                .containsExactly(new Vec3(0, 7, 0), new Vec3(3, 7, 0), Vec3.ZERO);
        type("#shape-radius", "1");
        assertThat(model.scene().objects()).extracting(SceneObject::shape).startsWith(new Sphere(1), new Sphere(1));
    }

    @Test
    void linkedScalesKeepTheirProportions() {
        type("#placement-scale-x", "2");
        assertThat(model.scene().objects().get(0).placement().scale()).isEqualTo(new Vec3(2, 2, 2));
        gui.click("#scale-link");
        type("#placement-scale-y", "3");
        assertThat(model.scene().objects().get(0).placement().scale()).isEqualTo(new Vec3(2, 3, 2));
    }

    @Test
    void colourChannelsAreNumbers() {
        type("#pattern-color-green", "100");
        assertThat(((Pattern.Plain) material().pattern()).color()).isEqualTo(new Rgb(255, 100, 255));
        type("#pattern-color-green", "100.256");
        assertThat(shown("#pattern-color-green")).as("as many decimals as have room").isEqualTo("100.26");
        gui.click("#pattern-color-green");
        gui.click("#pattern-color-red");
        assertThat(((Pattern.Plain) material().pattern()).color()).as("it is only shown so").isEqualTo(new Rgb(255, 100.256, 255));
        ColorPicker picker = (ColorPicker) gui.node("#pattern-color-picker");
        gui.act(() -> {
            picker.setValue(Color.web("#006400"));
            picker.fireEvent(new ActionEvent());
        });
        assertThat(((Pattern.Plain) material().pattern()).color()).as("only what is another number").isEqualTo(new Rgb(0, 100.256, 0));
        gui.act(model::undo);
        type("#pattern-color-green", "300");
        assertThat(((Label) gui.node(".refusal")).getText()).isEqualTo("green must be a number from 0 to 255, but is 300");
    }

    @Test
    void presetGivesWaterItsIndex() {
        gui.act(() -> ((MenuButton) gui.stage().getScene().lookup("#refractiveIndex-presets")).getItems().get(2).fire());
        assertThat(material().refractiveIndex()).isEqualTo(1.33);
    }

    @Test
    void otherPatternKeepsTheColourAndABoardIsRefusedOnABall() {
        choose("#pattern", Pattern.Checker.class);
        assertThat(material().pattern()).isEqualTo(new Pattern.Checker(0.25, Vec3.ZERO, Rgb.WHITE, new Rgb(40, 40, 40)));
        gui.until("the cubes have a size", () -> gui.stage().getScene().lookup("#pattern-size-x") != null);
        choose("#pattern", Pattern.Checkerboard.class);
        assertThat(material().pattern()).isInstanceOf(Pattern.Checker.class);
        assertThat(((Label) gui.node(".refusal")).getText()).contains("a checkerboard lies on a rectangle or a disc only");
    }

    @Test
    void materialIsChosenNamedSharedAndRenamed() {
        choose("#material", new MaterialName("steel"));
        assertThat(model.scene().objects().get(0).material()).isEqualTo(new MaterialName("steel"));
        type("#diffusion", "0.3");
        assertThat(model.scene().materials().get("steel")).extracting(Material::diffusion).isEqualTo(0.3);
        type("#material-name", "iron");
        assertThat(model.scene().objects()).extracting(SceneObject::material).contains(new MaterialName("iron"));
        choose("#material", new MaterialName("water"));
        assertThat(model.scene().objects().get(0).material()).isEqualTo(new MaterialName("water"));
        assertThat(model.scene().materials()).as("every scene knows it").doesNotContainKey("water");
        assertThat(gui.node("#material-share").isDisabled()).isTrue();
        type("#diffusion", "0.3");
        assertThat(model.scene().materials().get("water")).as("changed, it is this scene's own").extracting(Material::diffusion).isEqualTo(0.3);
        choose("#material", Inherited.INHERITED);
        assertThat(model.scene().objects().get(0).material()).isEqualTo(Inherited.INHERITED);
        gui.until("there is nothing to set", () -> gui.stage().getScene().lookup("#diffusion") == null);
    }

    @Test
    void materialIsChosenByKeysAloneAndOnlyWithEnter() {
        Node box = gui.node("#material");
        gui.act(box::requestFocus);
        gui.keys(KeyCode.DOWN);
        assertThat(isOpen("#material")).isTrue();
        gui.keys(KeyCode.DOWN);
        gui.keys(KeyCode.DOWN);
        assertThat(model.scene()).isSameAs(START);
        gui.keys(KeyCode.ENTER);
        assertThat(model.scene().objects().get(0).material()).isEqualTo(new MaterialName("glass"));
        gui.until("the keyboard is still there", () -> "material".equals(gui.stage().getScene().getFocusOwner().getId()));
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(START);
    }

    @Test
    void escapeLeavesTheMaterialAsItWas() {
        Node box = gui.node("#material");
        gui.act(box::requestFocus);
        gui.keys(KeyCode.SPACE);
        gui.keys(KeyCode.DOWN);
        gui.keys(KeyCode.ESCAPE);
        gui.until("the list is closed", () -> !((ComboBox<?>) box).isShowing());
        assertThat(model.scene()).isSameAs(START);
        assertThat(Gui.on(() -> ((ComboBox<?>) box).getValue().toString())).isEqualTo("OWN");
    }

    private boolean isOpen(String box) {
        return Gui.on(() -> ((ComboBox<?>) gui.stage().getScene().lookup(box)).isShowing());
    }

    @Test
    void ownMaterialIsGivenAName() {
        gui.click("#material-share");
        assertThat(model.scene().objects().get(0).material()).isEqualTo(new MaterialName("material"));
        assertThat(model.scene().materials().get("material")).isEqualTo(GLASS);
    }

    @Test
    void sceneItsPictureAndItsMaterialsAreShownWhenNothingIsSelected() {
        select();
        type("#background-blue", "200");
        type("#width", "1920");
        type("#tags", "glass  red");
        assertThat(model.scene().background()).isEqualTo(new Rgb(0, 0, 200));
        assertThat(model.scene().settings().width()).isEqualTo(1920);
        assertThat(model.scene().tags()).containsExactly("glass", "red");
        type("#width", "12.5");
        assertThat(((Label) gui.node(".refusal")).getText()).contains("whole number");
        gui.act(() -> ((Button) gui.stage().getScene().lookup("#materials-add")).fire());
        assertThat(model.scene().materials()).containsKey("material");
        gui.act(() -> ((Button) gui.stage().getScene().lookup("#materials-delete")).fire());
        assertThat(model.scene().materials()).containsOnlyKeys("steel");
    }

    @Test
    void lightAndCameraHaveTheirProperties() {
        select(ScenePath.light(0));
        type("#intensity", "0.5");
        assertThat(model.scene().lights().get(0).intensity()).isEqualTo(0.5);
        select(ScenePath.camera());
        choose("#aim", Camera.Target.class);
        assertThat(model.scene().camera().aim()).isEqualTo(new Camera.Target(new Vec3(0, 1, 0)));
        type("#lens-fovy", "190");
        assertThat(((Label) gui.node(".refusal")).getText()).isEqualTo("camera fovy must be above 0 and below 180 degrees, but is 190");
    }

    /** What a key that is held down does again and again; a robot's key does not. */
    private void again(KeyCode key) {
        Node owner = gui.stage().getScene().getFocusOwner();
        owner.fireEvent(new KeyEvent(KeyEvent.KEY_PRESSED, "", "", key, false, false, false, false));
    }

    @Test
    void stopsAreTypedMovedAddedAndTakenAwayByKeyboardAndMouse() {
        Pattern.Stops three = Pattern.Stops.of(new Stop(0, Rgb.BLACK), new Stop(0.2, Rgb.WHITE), new Stop(1, new Rgb(200, 0, 0)));
        gui.act(() -> model.edit(cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.CHANGE), scene -> scene.withObjects(
                List.of(SceneObject.of(new Sphere(0.5)).madeOf(Material.DEFAULT.withPattern(new Pattern.Marble(1, 1, 4, 0, three, Pattern.Lay.NONE)))))));
        gui.pulse();
        assertThat(shown("#pattern-colors-stops-1-at")).isEqualTo("0.2");
        type("#pattern-colors-stops-1-at", "1/4");
        assertThat(stops()).extracting(Stop::at).containsExactly(0.0, 0.25, 1.0);
        gui.keys(KeyCode.UP);
        gui.pulse();
        assertThat(stops()).extracting(Stop::at).containsExactly(0.0, 0.26, 1.0);
        gui.click("#pattern-colors-stops-add");
        gui.pulse();
        assertThat(stops()).extracting(Stop::at).containsExactly(0.0, 0.26, 0.63, 1.0);
        assertThat(stops().get(2).color()).isEqualTo(Rgb.ofLinear((1 + new Rgb(200, 0, 0).linearRed()) / 2, 0.5, 0.5));
        assertThat(Screenshots.save(gui, "sheet-stops")).isNotEmptyFile();
        type("#pattern-colors-stops-3-at", "0.5");
        assertThat(stops()).as("in order").extracting(Stop::at).containsExactly(0.0, 0.26, 0.5, 0.63);
        assertThat(stops().get(2).color()).isEqualTo(new Rgb(200, 0, 0));
        gui.act(() -> {
            ColorPicker picker = (ColorPicker) gui.stage().getScene().lookup("#pattern-colors-stops-0-color");
            picker.setValue(javafx.scene.paint.Color.LIME);
            picker.fireEvent(new javafx.event.ActionEvent());
        });
        assertThat(stops().get(0).color()).isEqualTo(new Rgb(0, 255, 0));
        gui.click("#pattern-colors-stops-1-remove");
        gui.pulse();
        gui.act(() -> gui.stage().getScene().lookup("#pattern-colors-stops-1-remove").requestFocus());
        gui.keys(KeyCode.SPACE);
        gui.pulse();
        assertThat(stops()).extracting(Stop::at).containsExactly(0.0, 0.63);
        assertThat(gui.node("#pattern-colors-stops-0-remove").isDisabled()).as("a pattern has two").isTrue();
        type("#pattern-colors-stops-0-at", "2");
        assertThat(((Label) gui.node(".refusal")).getText()).contains("stop at must be a number from 0 to 1");
        gui.act(() -> {
            model.undo();
            model.undo();
        });
        gui.until("the sheet follows", () -> gui.stage().getScene().lookup("#pattern-colors-stops-3-at") != null);
    }

    private List<Stop> stops() {
        return model.scene().objects().get(0).material() instanceof Material own && own.pattern() instanceof Pattern.Marble marble
                && marble.colors() instanceof Pattern.Stops stops ? stops.stops() : List.of();
    }

    private void select(ScenePath... items) {
        gui.act(() -> model.select(items));
        gui.pulse();
    }

    private void type(String field, String text) {
        gui.act(() -> {
            TextField node = (TextField) gui.stage().getScene().lookup(field);
            node.requestFocus();
            node.setText(text);
        });
        gui.keys(KeyCode.ENTER);
        gui.pulse();
    }

    @SuppressWarnings("unchecked")
    private void choose(String box, Object option) {
        gui.act(() -> ((ComboBox<Object>) gui.stage().getScene().lookup(box)).setValue(option));
        gui.pulse();
    }

    private String shown(String field) {
        return Gui.on(() -> ((TextField) gui.stage().getScene().lookup(field)).getText());
    }

    private Object ball() {
        return model.scene().objects().get(0).shape();
    }

    private Material material() {
        return (Material) model.scene().objects().get(0).material();
    }
}
