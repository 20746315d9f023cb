package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Sphere;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.TreeSet;
import javafx.scene.Node;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.TextField;
import javafx.scene.control.TitledPane;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Where the keyboard is, and how it gets there. */
class FocusTest {
    static final List<Locale> LANGUAGES = Texts.LANGUAGES;

    @TempDir
    Path folder;
    private EditorGui editor;

    @BeforeEach
    void open() {
        editor = new EditorGui(folder, Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 1, 5), Vec3.ZERO))
                .plus(SceneObject.of(new Sphere(0.5)).named("ball").madeOf(Material.DEFAULT)));
    }

    @AfterEach
    void close() {
        editor.close();
    }

    @Test
    void aCopyMadeFromWithinAFieldLeavesTheKeyboardInThatField() {
        editor.gui.act(() -> editor.model().select(ScenePath.body(0)));
        editor.gui.click("#shape-radius");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.D);
        editor.gui.until("the copy is selected", () -> editor.model().selection().contains(ScenePath.body(1)));
        editor.gui.keys(KeyCode.ENTER);
        assertThat(editor.model().scene().objects()).hasSize(2);
        assertThat(owner()).isEqualTo("shape-radius");
    }

    @Test
    void aFieldThatIsGoneGivesTheKeyboardToTheView() {
        editor.gui.act(() -> editor.model().select(ScenePath.body(0)));
        editor.gui.click(editor.projection("front"), 5, 5);
        editor.gui.act(() -> editor.model().select(ScenePath.body(0)));
        editor.gui.click("#shape-radius");
        editor.gui.act(() -> editor.model().select(ScenePath.camera()));
        editor.gui.until("the keyboard is in the view used last", () -> "projection-front".equals(editor.gui.stage().getScene().getFocusOwner().getId()));
        editor.gui.keys(KeyCode.ENTER);
        assertThat(editor.model().scene().objects()).hasSize(1);
    }

    @Test
    void atFirstTheKeyboardIsInAView() {
        assertThat(owner()).isEqualTo("live-picture");
        editor.gui.keys(KeyCode.ENTER);
        assertThat(editor.model().scene().objects()).hasSize(1);
    }

    @Test
    void aClickOnThePaletteLeavesTheKeyboardWhereItIs() {
        focus("#projection-top");
        editor.gui.click("#add-block");
        assertThat(owner()).isEqualTo("projection-top");
        editor.gui.keys(KeyCode.ENTER);
        editor.gui.keys(KeyCode.SPACE);
        assertThat(editor.model().scene().objects()).hasSize(2);
    }

    @Test
    void tabGoesThroughViewsTreePaletteAndSheetAndBack() {
        focus("#projection-top");
        List<String> there = walk(7, KeyCode.TAB);
        assertThat(there).startsWith("projection-top", "live-picture", "projection-front", "projection-right", "tree-find", "tree-list", "add-palette");
        assertThat(there.get(7)).isEqualTo("name");
        List<String> back = walk(7, KeyCode.SHIFT, KeyCode.TAB);
        assertThat(back).endsWith("projection-top");
    }

    @Test
    void inTheSheetTabGoesFromFieldToFieldAndToWhatIsFolded() {
        editor.gui.act(() -> editor.model().select(ScenePath.body(0)));
        editor.gui.click("#shape-radius");
        assertThat(walk(3, KeyCode.TAB)).noneMatch(owner -> owner.contains("sheet-section"));
        editor.gui.click("#shape-radius");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.UP);
        assertThat(owner()).contains("sheet-section");
        editor.gui.keys(KeyCode.SPACE);
        editor.gui.pulse();
        assertThat(Gui.on(() -> editor.gui.stage().getScene().getFocusOwner() instanceof TitledPane pane && !pane.isExpanded() && pane.isFocusTraversable())).isTrue();
        String next = walk(1, KeyCode.TAB).get(1);
        assertThat(walk(1, KeyCode.SHIFT, KeyCode.TAB)).first().isEqualTo(next);
        assertThat(owner()).as("what is folded is a stop").contains("sheet-section");
        editor.gui.keys(KeyCode.SPACE);
        editor.gui.pulse();
        assertThat(walk(1, KeyCode.TAB)).last().isEqualTo("shape-radius");
    }

    @Test
    void f6GoesFromRegionToRegionAndReturnsToWhereOneWas() {
        focus("#projection-right");
        assertThat(walk(3, KeyCode.F6)).containsExactly("projection-right", "tree-find", "add-palette", owner());
        assertThat(walk(1, KeyCode.F6)).last().isEqualTo("projection-right");
        assertThat(walk(2, KeyCode.SHIFT, KeyCode.F6)).last().isEqualTo("add-palette");
    }

    @Test
    void arrowsWalkInThePaletteAndEnterAdds() {
        focus("#add-palette");
        editor.gui.keys(KeyCode.RIGHT);
        editor.gui.keys(KeyCode.ENTER);
        editor.gui.keys(KeyCode.RIGHT);
        editor.gui.keys(KeyCode.RIGHT);
        editor.gui.keys(KeyCode.SPACE);
        assertThat(editor.model().scene().objects()).extracting(SceneObject::shape).hasAtLeastOneElementOfType(Block.class)
                .hasAtLeastOneElementOfType(Plane.class).hasSize(3);
        assertThat(owner()).isEqualTo("add-palette");
    }

    @Test
    void whateverThereIsIsFoundByAFewLettersAndTheKeyboardReturns() {
        focus("#projection-front");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.K);
        assertThat(owner()).isEqualTo("finder-field");
        type("baLL");
        editor.gui.keys(KeyCode.ENTER);
        assertThat(editor.model().selection()).as("an object").containsExactly(ScenePath.body(0));
        assertThat(owner()).isEqualTo("projection-front");
        find("gold");
        assertThat(editor.model().scene().objects().get(0).material()).as("a material").isEqualTo(new MaterialName("gold"));
        find("duplicate");
        assertThat(editor.model().scene().objects()).as("an action").hasSize(2);
        find("snap");
        assertThat(editor.editor.snapping().get()).as("what is switched").isFalse();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.K);
        type("make it the first: that");
        editor.gui.keys(KeyCode.ENTER);
        assertThat(owner()).as("what cannot be done now is not done").isEqualTo("finder-field");
        editor.gui.keys(KeyCode.ESCAPE);
        assertThat(owner()).isEqualTo("projection-front");
        editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        find("Pruhled");
        find("zruset vyber");
        assertThat(editor.model().selection()).as("without accents, and a mistyped word finds nothing").isNotEmpty();
        find("zrusit vyber");
        assertThat(editor.model().selection()).isEmpty();
    }

    private void find(String letters) {
        editor.gui.keys(KeyCode.CONTROL, KeyCode.K);
        type(letters);
        editor.gui.keys(KeyCode.ENTER);
        if (owner().equals("finder-field")) {
            editor.gui.keys(KeyCode.ESCAPE);
        }
    }

    private void type(String letters) {
        editor.gui.act(() -> ((TextField) editor.gui.stage().getScene().lookup("#finder-field")).setText(letters));
    }

    @ParameterizedTest
    @FieldSource("LANGUAGES")
    void everyMenuHasALetterOfItsOwnThatOpensIt(Locale language) {
        editor.gui.act(() -> editor.editor.setLanguage(language));
        MenuBar bar = (MenuBar) editor.gui.node("#menu-bar");
        List<String> letters = Gui.on(() -> bar.getMenus().stream().map(menu -> menu.getText().replaceFirst("^[^_]*_(.).*", "$1").toUpperCase(Locale.ROOT)).toList());
        assertThat(new TreeSet<>(letters)).hasSameSizeAs(letters).allSatisfy(letter -> assertThat(letter).matches("[A-Z]"));
        for (int i = 0; i < letters.size(); i++) {
            Menu menu = bar.getMenus().get(i);
            editor.gui.keys(KeyCode.ALT, KeyCode.getKeyCode(letters.get(i)));
            editor.gui.until("the menu is open: " + menu.getText(), menu::isShowing);
            editor.gui.keys(KeyCode.ESCAPE);
            editor.gui.until("the menu is closed", () -> !menu.isShowing());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"LEFT", "PLUS"})
    void aLockedCameraDoesNotMove(String key) {
        Camera before = editor.model().scene().camera();
        editor.gui.act(() -> editor.model().select(ScenePath.camera()));
        editor.menu("object-lock");
        Node picture = editor.gui.node(".live-picture");
        editor.gui.act(picture::requestFocus);
        editor.gui.drag(picture, 100, 100, 160, 120);
        editor.gui.wheel(2);
        editor.gui.keys(KeyCode.valueOf(key));
        assertThat(editor.model().scene().camera()).isEqualTo(before);
        assertThat(Gui.on(editor::status)).contains("locked");
        assertThat(editor.model().selection()).as("a drag is no click").containsExactly(ScenePath.camera());
    }

    /** Where the keyboard is at first, and after each of some presses of keys. */
    private List<String> walk(int times, KeyCode... keys) {
        List<String> way = new ArrayList<>(List.of(owner()));
        for (int i = 0; i < times; i++) {
            editor.gui.keys(keys);
            way.add(owner());
        }
        return way;
    }

    private void focus(String selector) {
        Node node = editor.gui.node(selector);
        editor.gui.act(node::requestFocus);
    }

    private String owner() {
        return Gui.on(() -> {
            Node owner = editor.gui.stage().getScene().getFocusOwner();
            return Objects.requireNonNullElse(owner.getId(), String.join(" ", owner.getStyleClass()));
        });
    }
}
