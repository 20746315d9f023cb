package cz.paprsek.fx.view.shell;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Adding;
import cz.paprsek.fx.model.edit.Examples;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicReference;
import javafx.scene.control.Button;
import javafx.scene.control.MenuItem;
import javafx.scene.image.WritableImage;
import javafx.scene.layout.StackPane;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.kordamp.ikonli.javafx.FontIcon;

class AddPaletteTest {
    private final EditorModel model = new EditorModel(Scene.EMPTY);
    private final AtomicReference<AddPalette> palette = new AtomicReference<>();
    private final Edits edits = new Edits(model, Texts.in(Locale.ENGLISH));
    private final Gui gui = Gui.show(() -> {
        palette.set(new AddPalette(model, Texts.in(Locale.ENGLISH), () -> Sight.of(model.state()), edits, sight -> {}, sight -> {}));
        return palette.get();
    }, 300, 120);

    @AfterEach
    void close() {
        gui.close();
    }

    @Test
    void everyKindAndLightsAreAddedByAClickAndSelected() {
        List<Shape> kinds = Examples.ofSize(1);
        for (Shape kind : kinds) {
            gui.click("#add-" + kind.kind());
        }
        for (Light light : Adding.LIGHTS) {
            gui.click("#add-" + light.kind());
        }
        assertThat(model.scene().objects()).extracting(object -> object.shape().kind()).containsExactlyElementsOf(kinds.stream().map(Shape::kind).toList());
        assertThat(model.scene().lights()).extracting(Light::kind).containsExactly("point-light", "spot-light", "area-light", "sphere-light", "sun-light");
        assertThat(model.selection()).containsExactly(ScenePath.light(4));
        for (int i = 0; i < kinds.size() + Adding.LIGHTS.size(); i++) {
            gui.act(model::undo);
        }
        assertThat(model.scene()).isSameAs(Scene.EMPTY);
    }

    /** Two signs of different names were one drawing. */
    @Test
    void noTwoSignsLookTheSame() {
        List<Button> buttons = Gui.on(() -> Objects.requireNonNull(palette.get()).getChildren().stream().map(Button.class::cast).toList());
        List<boolean[]> inked = buttons.stream().map(button -> Gui.on(() -> ink(((FontIcon) button.getGraphic()).getIconLiteral()))).toList();
        assertThat(buttons).hasSizeGreaterThan(25);
        for (int i = 0; i < inked.size(); i++) {
            for (int k = 0; k < i; k++) {
                assertThat(shared(inked.get(i), inked.get(k))).as("%s and %s", buttons.get(i).getId(), buttons.get(k).getId()).isLessThan(0.9);
            }
        }
    }

    /** Which pixels of a square a sign covers. */
    private static boolean[] ink(String literal) {
        FontIcon icon = new FontIcon(literal);
        icon.setIconSize(32);
        StackPane square = new StackPane(icon);
        square.resize(40, 40);
        WritableImage picture = new javafx.scene.Scene(square, 40, 40).snapshot(null);
        boolean[] ink = new boolean[40 * 40];
        for (int i = 0; i < ink.length; i++) {
            ink[i] = picture.getPixelReader().getColor(i % 40, i / 40).getBrightness() < 0.5;
        }
        return ink;
    }

    /** How much of what either covers both do: 0 to 1. */
    private static double shared(boolean[] one, boolean[] other) {
        double both = 0;
        double either = 0;
        for (int i = 0; i < one.length; i++) {
            both += one[i] && other[i] ? 1 : 0;
            either += one[i] || other[i] ? 1 : 0;
        }
        return both / either;
    }

    /** Out of the palette into the camera's picture: onto a table, or a ball; in the air from the front. */
    @Test
    void whatIsDroppedStandsOnWhatIsThereInOneStep() {
        SceneObject table = SceneObject.of(new Block(new Vec3(-2, 0, -2), new Vec3(2, 3, 2)));
        Scene before = Scene.EMPTY.plus(table);
        gui.act(() -> model.edit(Label.of(Label.Edit.ADD), scene -> before));
        AddPalette shown = Objects.requireNonNull(palette.get());
        for (Shape kind : Examples.ofSize(1)) {
            gui.act(() -> shown.put("add-" + kind.kind(), new AddPalette.Place(new Sight(new Vec3(0.5, 3, -0.5), 1), Vec3.Y)));
            Bounds box = ScenePath.body(1).placed(model.scene()).bounds();
            assertThat(!box.isFinite() || Math.abs(box.minY() - 3) < 1e-5).as("%s in %s", kind.kind(), box).isTrue();
            assertThat(model.selection()).containsExactly(ScenePath.body(1));
            gui.act(model::undo);
            assertThat(model.scene()).isEqualTo(before);
        }
        gui.act(() -> shown.put("add-sphere", new AddPalette.Place(new Sight(new Vec3(0.5, 7, 0), 1), Vec3.ZERO)));
        assertThat(model.scene().objects().get(1).placement().position()).isEqualTo(new Vec3(0.5, 7, 0));
        gui.act(() -> shown.put("add-point-light", new AddPalette.Place(new Sight(new Vec3(1, 3, 0), 1), Vec3.Y)));
        assertThat(LightMoves.place(model.scene().lights().get(0))).isEqualTo(new Vec3(1, 4, 0));
        gui.act(() -> shown.put("add-sun-light", new AddPalette.Place(new Sight(new Vec3(1, 3, 0), 1), Vec3.Y)));
        assertThat(model.scene().lights()).hasSize(2);
    }

    @Test
    void operationsNeedSeveralAndTellWhyNot() {
        gui.click("#add-sphere");
        assertThat(gui.node("#combine-union").isDisabled()).isTrue();
        gui.click("#add-disc");
        gui.act(() -> model.select(ScenePath.body(0), ScenePath.body(1)));
        gui.click("#combine-union");
        assertThat(edits.refusalProperty().get()).contains("disc has no inside");
        gui.click("#add-block");
        gui.act(() -> model.select(ScenePath.body(0), ScenePath.body(2)));
        gui.click("#combine-difference");
        assertThat(model.scene().objects().get(0).shape()).isInstanceOf(Csg.class);
        assertThat(edits.refusalProperty().get()).isEmpty();
        gui.click("#dissolve");
        assertThat(model.scene().objects()).hasSize(3);
    }

    @Test
    void menuAddsWhatThePaletteAdds() {
        AddPalette shown = Objects.requireNonNull(palette.get());
        List<String> buttons = Gui.on(() -> shown.getChildren().stream().map(button -> "menu-" + button.getId()).toList());
        List<MenuItem> items = Gui.on(shown::menuItems);
        assertThat(buttons).startsWith(items.stream().map(MenuItem::getId).toArray(String[]::new));
        gui.act(() -> items.forEach(MenuItem::fire));
        assertThat(model.scene().objects()).hasSize(Examples.ofSize(1).size());
        assertThat(model.scene().lights()).hasSameSizeAs(Adding.LIGHTS);
    }
}
