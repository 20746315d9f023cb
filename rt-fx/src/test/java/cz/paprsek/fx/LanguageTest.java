package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.present.PresenterPane;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.ScenePath;
import java.lang.ref.WeakReference;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.DialogPane;
import javafx.scene.control.Labeled;
import javafx.scene.text.Text;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LanguageTest {
    @TempDir
    Path folder;

    @Test
    void contentsOfTheWindowInAnotherLanguageAreLetGo() {
        try (EditorGui editor = new EditorGui(folder, Templates.read("test"))) {
            WeakReference<Parent> old = Gui.on(() -> new WeakReference<>(editor.gui.stage().getScene().getRoot()));
            for (String language : List.of("cs", "en", "cs")) {
                editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag(language)));
            }
            editor.gui.until("the first content of the window is gone", () -> {
                System.gc();
                return old.get() == null;
            });
            assertThat(editor.dialogs.faults).isEmpty();
        }
    }

    @Test
    void theOpenPresenterGoesOnInAnotherLanguageAtTheSamePixel() {
        try (EditorGui editor = new EditorGui(folder, Templates.read("test"))) {
            editor.gui.act(() -> editor.editor.presenter().show(Optional.empty()));
            Stage window = editor.editor.presenter().stage().orElseThrow();
            editor.gui.act(() -> presenter(window).show(7, 9));
            assertThat(presenter(window).title()).startsWith("Pixel 7, 9");
            assertThat(tooltip(window, "present-play")).isEqualTo("Space");
            editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            assertThat(presenter(window).title()).startsWith("Bod 7, 9");
            assertThat(window.getTitle()).startsWith("Proč");
            assertThat(tooltip(window, "present-play")).isEqualTo("Mezerník");
            assertThat(tooltip(window, "present-back")).isEqualTo("←");
            editor.gui.act(window::close);
            assertThat(editor.dialogs.faults).isEmpty();
        }
    }

    /** Some names are words or sentences of the library: these are what the user wrote, and stay. */
    @Test
    void namesInMessagesAreNotTranslated() {
        try (EditorGui editor = new EditorGui(folder, Templates.read("test"))) {
            editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            for (String name : List.of("red box", "A must be B, but C", "union")) {
                String said = Texts.in(Locale.forLanguageTag("cs")).of("view.focus-done", name);
                editor.gui.act(() -> editor.editor.say(said));
                assertThat(Gui.on(editor::status)).isEqualTo(said).endsWith(name);
                editor.gui.act(() -> editor.editor.ask(said, List.of()));
                assertThat(Gui.on(() -> all(editor.gui.stage().getScene().getRoot()).filter(Labeled.class::isInstance).map(node -> ((Labeled) node).getText()).toList())).contains(said);
            }
            editor.gui.act(() -> editor.editor.wrong("there is no material named \"gols\""));
            assertThat(Gui.on(editor::status)).isEqualTo("není tu materiál se jménem \"gols\"");
        }
    }

    private static PresenterPane presenter(Stage window) {
        return (PresenterPane) window.getScene().getRoot();
    }

    private static String tooltip(Stage window, String id) {
        return Gui.on(() -> ((ButtonBase) window.getScene().lookup("#" + id)).getAccessibleHelp());
    }

    /** Pictures of the main states, in target/screenshots, to be looked at by people; the light ones of this size are those of the manual. */
    @Test
    void bothThemesAndLanguages() {
        try (EditorGui editor = new EditorGui(folder, Templates.read("showcase"))) {
            editor.gui.act(() -> editor.model().select(ScenePath.body(1)));
            shoot(editor, "window-light");
            editor.gui.act(() -> editor.editor.theme().set(Theme.DARK));
            shoot(editor, "window-dark");
            editor.gui.act(() -> editor.editor.theme().set(Theme.LIGHT));
            editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            assertThat(editor.gui.stage().getScene().lookup("#property-sheet #object-pipette-button")).as("the pipette of what stays selected").isNotNull();
            shoot(editor, "window-light-czech");
            editor.gui.act(() -> editor.editor.theme().set(Theme.DARK));
            editor.gui.act(() -> editor.model().select(ScenePath.camera()));
            shoot(editor, "window-dark-czech");
            editor.gui.act(() -> editor.editor.manuscript().openProperty().set(true));
            editor.gui.until("the text is there", () -> !editor.editor.manuscript().page().text().isEmpty());
            shoot(editor, "window-text-dark-czech");
        }
        try (EditorGui editor = new EditorGui(folder, Templates.read("test"), 1600, 1000)) {
            editor.gui.act(() -> editor.editor.theme().set(Theme.LIGHT));
            editor.gui.act(() -> editor.model().select(ScenePath.body(8), ScenePath.light(0)));
            shoot(editor, "window-light-1600x1000");
        }
    }

    private static void shoot(EditorGui editor, String name) {
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        assertThat(Screenshots.save(editor.gui, name)).isNotEmptyFile();
    }

    /** A window of 1024 × 768 in the language with the longer words: nothing ends in dots, unless a hint has all of it. */
    @Test
    void noWordIsCutInASmallWindow() {
        try (EditorGui editor = new EditorGui(folder, Templates.read("glass"), 1024, 768)) {
            editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            assertThat(cut(editor)).as("views and sheet").isEmpty();
            editor.gui.act(() -> editor.editor.manuscript().openProperty().set(true));
            assertThat(cut(editor)).as("beside the text").isEmpty();
            editor.gui.act(() -> editor.editor.manuscript().openProperty().set(false));
            editor.gui.act(() -> editor.editor.clock().openProperty().set(true));
            assertThat(cut(editor)).as("above the timeline").isEmpty();
            editor.gui.act(() -> editor.editor.lessons().open("camera-rays"));
            assertThat(cut(editor)).as("beside a lesson").isEmpty();
        }
    }

    /** In both languages, folded and not: whole words, and details as far from the edges as the text above them. */
    @Test
    void theDialogOfAFaultIsWhole() {
        for (Locale language : Texts.LANGUAGES) {
            try (EditorGui editor = new EditorGui(folder, Templates.read("test"))) {
                editor.gui.act(() -> new SystemDialogs(editor.gui.stage(), () -> Texts.in(language)).fault(new IllegalStateException("an example"), () -> {}));
                DialogPane pane = Gui.on(() -> Window.getWindows().stream().map(window -> window.getScene().getRoot()).filter(DialogPane.class::isInstance).map(DialogPane.class::cast).findFirst().orElseThrow());
                editor.gui.pulse();
                assertThat(Gui.on(() -> cutIn(pane))).as("folded").isEmpty();
                editor.gui.act(() -> pane.setExpanded(true));
                editor.gui.until("the details are there", () -> pane.getExpandableContent().isVisible() && pane.getExpandableContent().getLayoutBounds().getHeight() > 100);
                editor.gui.pulse();
                assertThat(Gui.on(() -> cutIn(pane))).as("with details").isEmpty();
                Bounds details = Gui.on(() -> {
                    Node area = pane.getExpandableContent().lookup(".text-area");
                    return area.localToScene(area.getLayoutBounds());
                });
                assertThat(details.getMinX()).isBetween(12.0, 16.0);
                assertThat(pane.getWidth() - details.getMaxX()).isBetween(12.0, 16.0);
                assertThat(details.getMinY()).isGreaterThan(60);
                editor.gui.act(() -> pane.getScene().getWindow().hide());
            }
        }
    }

    private static List<String> cut(EditorGui editor) {
        for (int i = 0; i < 2; i++) {
            editor.gui.pulse();
        }
        return Gui.on(() -> cutIn(editor.gui.stage().getScene().getRoot()));
    }

    private static List<String> cutIn(Parent root) {
        return all(root).filter(Labeled.class::isInstance).map(Labeled.class::cast)
                .filter(labeled -> isSeen(labeled) && isCut(labeled)).map(labeled -> labeled + " in " + labeled.getParent()).toList();
    }

    private static boolean isCut(Labeled labeled) {
        String text = labeled.isMnemonicParsing() ? labeled.getText().replaceFirst("_", "") : labeled.getText();
        String hint = labeled.getTooltip() == null ? labeled.getAccessibleHelp() : labeled.getTooltip().getText();
        boolean hasHint = hint != null && hint.contains(text);
        return labeled.getContentDisplay() != ContentDisplay.GRAPHIC_ONLY && !hasHint
                && labeled.getChildrenUnmodifiable().stream().filter(shown -> shown.getStyleClass().contains("text")).anyMatch(shown -> !bare(((Text) shown).getText()).equals(bare(text)));
    }

    /** Without the places where lines may be broken. */
    private static String bare(String text) {
        return text.replaceAll("\\s", "");
    }

    private static boolean isSeen(Labeled labeled) {
        Bounds bounds = labeled.localToScene(labeled.getLayoutBounds());
        return labeled.getText() != null && !labeled.getText().isEmpty() && bounds.getWidth() > 0 && labeled.getScene().getRoot().getLayoutBounds().contains(bounds.getCenterX(), bounds.getCenterY());
    }

    private static Stream<Node> all(Node node) {
        if (!node.isVisible()) {
            return Stream.empty();
        }
        return node instanceof Parent parent ? Stream.concat(Stream.of(node), parent.getChildrenUnmodifiable().stream().flatMap(LanguageTest::all)) : Stream.of(node);
    }
}
