package cz.paprsek.fx.view.present;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.Gui;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.explain.text.Step;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import javafx.beans.property.SimpleObjectProperty;
import javafx.scene.Node;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import javafx.scene.paint.Color;
import javafx.scene.text.Text;
import javafx.scene.text.TextFlow;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A pixel explained before a class, in a window as small as an old projector's picture. */
class PresenterPaneTest {
    private Gui gui;

    @BeforeEach
    void open() throws Exception {
        present(Theme.LIGHT, "en");
    }

    private void present(Theme theme, String language) throws Exception {
        Scene glass = SceneFiles.read(Path.of("../scenes/glass.xml"));
        Scene small = glass.withSettings(glass.settings().withSize(480, 270).withSamples(1));
        gui = Gui.show(() -> new PresenterPane(small, Assets.none(), Texts.in(Locale.forLanguageTag(language)), new SimpleObjectProperty<>(theme)), 1024, 740);
        gui.act(() -> {
            theme.applyTo(gui.stage().getScene());
            pane().requestFocus();
            pane().showMiddle();
        });
        gui.until("the pixel is explained", () -> !steps().getItems().isEmpty());
    }

    private PresenterPane pane() {
        return (PresenterPane) gui.stage().getScene().getRoot();
    }

    @AfterEach
    void close() {
        gui.act(() -> {
            pane().close();
            Theme.LIGHT.applyTo(gui.stage().getScene());
        });
        gui.close();
    }

    @SuppressWarnings("unchecked")
    private ListView<Step> steps() {
        return (ListView<Step>) gui.stage().getScene().lookup("#present-steps");
    }

    private String label(String id) {
        return Gui.on(() -> ((Label) gui.stage().getScene().lookup("#present-" + id)).getText());
    }

    /** All lines of the exercise that are seen, as they are seen. */
    private String shown() {
        return Gui.on(() -> steps().lookupAll(".present-equation").stream().map(text -> ((Text) text).getText()).collect(Collectors.joining("\n")));
    }

    /** The glass ball's middle is column 114 of 480. */
    private void showGlass() {
        Node picture = gui.node("#present-picture");
        double scale = picture.getLayoutBounds().getWidth() / 480;
        gui.click(picture, 114 * scale, picture.getLayoutBounds().getHeight() / 2 + 5 * scale);
        gui.until("the ball's pixel is explained", () -> ((Label) gui.stage().getScene().lookup("#present-progress")).getText().contains(" of ")
                && !((Label) gui.stage().getScene().lookup("#present-progress")).getText().contains(" of 1:"));
    }

    @Test
    void thePictureIsLargeAndItsPixelsHaveTheNumbersOfTheCommandLine() {
        assertThat(label("title")).isEqualTo("Pixel 240, 135 of 480 × 270");
        assertThat(gui.node("#present-picture").getLayoutBounds().getWidth()).isGreaterThan(560);
        gui.keys(KeyCode.SHIFT, KeyCode.RIGHT);
        assertThat(label("title")).isEqualTo("Pixel 241, 135 of 480 × 270");
    }

    @Test
    void keysTellRayByRayAndNumbersCanWait() {
        showGlass();
        assertThat(label("progress")).startsWith("Ray 1 of ").contains(": E, 100 %");
        gui.keys(KeyCode.RIGHT);
        assertThat(label("progress")).startsWith("Ray 2 of ");
        gui.keys(KeyCode.PAGE_UP);
        assertThat(label("progress")).startsWith("Ray 1 of ");
        gui.keys(KeyCode.END);
        assertThat(label("progress")).doesNotContain("Ray 1 of");
        gui.keys(KeyCode.HOME);
        gui.keys(KeyCode.B);
        assertThat(shown()).contains("=\u00a0……").doesNotContain("2.6,");
        assertThat(label("sum")).doesNotContain("sRGB");
        gui.keys(KeyCode.ENTER);
        assertThat(shown()).as("the origin was asked for").contains("2.6,").contains("……");
        gui.keys(KeyCode.B);
        assertThat(shown()).doesNotContain("……");
        assertThat(label("sum")).contains("sRGB");
    }

    /** Rows are as high as their lines, however wide the window has become. */
    @Test
    void everyLineIsSeenWhole() {
        gui.act(() -> pane().show(240, 135));
        // With a bar to scroll by, rows are some pixels narrower: at one of these widths a line breaks because of it.
        for (int width = 1024; width < 1324; width += 10) {
            int now = width;
            gui.act(() -> gui.stage().setWidth(now));
            assertThat(Gui.on(() -> steps().lookupAll(".list-cell").stream().map(ListCell.class::cast).filter(cell -> cell.getGraphic() instanceof TextFlow)
                    .filter(cell -> cell.getHeight() < ((TextFlow) cell.getGraphic()).prefHeight(((TextFlow) cell.getGraphic()).getWidth())).toList())).as("cut off at %s", width).isEmpty();
        }
    }

    @Test
    void kindsOfRaysAreHiddenAndTheyAreZoomedTo() {
        showGlass();
        gui.keys(KeyCode.END);
        Node picture = gui.node("#present-picture");
        int all = changed(picture, () -> ((CheckBox) gui.node("#present-kind-shadow-free")).fire());
        assertThat(all).as("shadow rays are gone").isPositive();
        assertThat(changed(picture, () -> gui.keys(KeyCode.Z))).as("another part of the picture").isGreaterThan(1000);
    }

    private int changed(Node picture, Runnable act) {
        WritableImage before = Gui.on(() -> picture.snapshot(null, null));
        act.run();
        gui.pulse();
        WritableImage after = Gui.on(() -> picture.snapshot(null, null));
        int changed = 0;
        int width = (int) before.getWidth();
        int height = (int) before.getHeight();
        for (int i = 0; i < width * height; i++) {
            int x = i % width;
            int y = i / width;
            changed += before.getPixelReader().getArgb(x, y) != after.getPixelReader().getArgb(x, y) ? 1 : 0;
        }
        return changed;
    }

    @Test
    void everyLineCanBeReadInBothThemesAndLanguages() throws Exception {
        for (Theme theme : Theme.values()) {
            String language = theme == Theme.LIGHT ? "en" : "cs";
            close();
            present(theme, language);
            showGlassIn(language);
            gui.act(() -> steps().getSelectionModel().select(1));
            for (String selector : List.of("#present-steps", "#present-title", "#present-sum", "#present-kinds")) {
                assertThat(contrast(gui.node(selector))).as(theme + " " + selector).isGreaterThan(4.5);
            }
        }
    }

    private void showGlassIn(String language) {
        Node picture = gui.node("#present-picture");
        double scale = picture.getLayoutBounds().getWidth() / 480;
        gui.click(picture, 114 * scale, picture.getLayoutBounds().getHeight() / 2 + 5 * scale);
        gui.until("the ball's pixel is explained in " + language, () -> steps().getItems().size() > 8);
    }

    /** Between the commonest colour of what is drawn, the ground, and that which differs most from it. */
    private static double contrast(Node node) {
        WritableImage drawn = Gui.on(() -> node.snapshot(null, null));
        Map<Integer, Integer> count = new HashMap<>();
        for (int y = 0; y < (int) drawn.getHeight(); y++) {
            for (int x = 0; x < (int) drawn.getWidth(); x++) {
                count.merge(drawn.getPixelReader().getArgb(x, y), 1, Integer::sum);
            }
        }
        int ground = count.entrySet().stream().max(Map.Entry.comparingByValue()).orElseThrow().getKey();
        return count.keySet().stream().mapToDouble(color -> ratio(luminance(color), luminance(ground))).max().orElseThrow();
    }

    /** @source WCAG 2.1, contrast ratio */
    private static double ratio(double a, double b) {
        return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    }

    private static double luminance(int argb) {
        Color color = Color.rgb(argb >> 16 & 0xFF, argb >> 8 & 0xFF, argb & 0xFF);
        return 0.2126 * linear(color.getRed()) + 0.7152 * linear(color.getGreen()) + 0.0722 * linear(color.getBlue());
    }

    private static double linear(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }
}
