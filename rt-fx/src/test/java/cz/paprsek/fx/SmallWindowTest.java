package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Labeled;
import javafx.scene.text.Text;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A window of 1024 × 768 in the language with the longer words: nothing ends in dots, unless a hint has all of it. */
class SmallWindowTest {
    @TempDir
    private Path folder = Path.of("");

    @Test
    void noWordIsCut() {
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

    private static List<String> cut(EditorGui editor) {
        for (int i = 0; i < 2; i++) {
            editor.gui.pulse();
        }
        return Gui.on(() -> all(editor.gui.stage().getScene().getRoot()).filter(Labeled.class::isInstance).map(Labeled.class::cast)
                .filter(labeled -> isSeen(labeled) && isCut(labeled)).map(labeled -> labeled + " in " + labeled.getParent()).toList());
    }

    private static boolean isCut(Labeled labeled) {
        String text = labeled.isMnemonicParsing() ? labeled.getText().replaceFirst("_", "") : labeled.getText();
        boolean hasHint = labeled.getTooltip() != null && labeled.getTooltip().getText().contains(text);
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
        return node instanceof Parent parent ? Stream.concat(Stream.of(node), parent.getChildrenUnmodifiable().stream().flatMap(SmallWindowTest::all)) : Stream.of(node);
    }
}
