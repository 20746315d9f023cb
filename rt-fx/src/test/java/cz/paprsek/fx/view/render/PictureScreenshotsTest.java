package cz.paprsek.fx.view.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.picture.UnfinishedPictures;
import cz.paprsek.fx.view.camera.CameraPane;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.render.fields.Remembered;
import cz.paprsek.fx.view.render.fields.WholeNumberField;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.property.SimpleObjectProperty;
import javafx.concurrent.Worker;
import javafx.scene.Node;
import javafx.scene.control.Labeled;
import javafx.scene.control.TabPane;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import javax.imageio.ImageIO;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The camera pane and the render window in both themes, to be looked at in {@code target/screenshots}; that no label is cut off is checked. */
class PictureScreenshotsTest {
    private static final Path FOLDER = Path.of("target/screenshots");

    @ParameterizedTest
    @EnumSource
    void cameraPane(Theme theme) throws Exception {
        CameraPane pane = Gui.on(() -> new CameraPane(new EditorModel(scene()), fault -> {}));
        try (Gui gui = Gui.show(() -> pane, 620, 420)) {
            gui.act(() -> theme.applyTo(gui.stage().getScene()));
            gui.until("the picture is complete", pane::isComplete);
            shoot(gui, "camera", theme);
        }
        pane.close();
    }

    @ParameterizedTest
    @EnumSource
    void renders(Theme theme) throws Exception {
        // Czech words are the longer ones.
        Locale language = theme == Theme.LIGHT ? Locale.ENGLISH : Locale.forLanguageTag("cs");
        RenderPane pane = Gui.on(() -> new RenderPane(new EditorModel(scene()), new RenderDesk(Remembered.forNow(), UnfinishedPictures.notKept()), Texts.in(language), new SimpleObjectProperty<>(Theme.LIGHT),
                (owner, name) -> Optional.empty(), (owner, name) -> Optional.empty()));
        try (Gui gui = Gui.show(() -> pane, 1000, 720)) {
            gui.act(() -> theme.applyTo(gui.stage().getScene()));
            gui.act(pane::render);
            RenderTab first = (RenderTab) ((TabPane) pane.lookup("#renders")).getTabs().get(0);
            gui.until("it is half done", () -> first.task().progress().share() > 0.5);
            shoot(gui, "render-running", theme);
            gui.until("it is done", () -> first.task().getState() == Worker.State.SUCCEEDED);
            gui.moveTo(first.view(), 420, 300);
            shoot(gui, "render-done", theme);
            gui.click("#render-ask");
            shoot(gui, "render-ask", theme);
            gui.act(() -> {
                ((WholeNumberField) pane.lookup("#render-depth")).set(2);
                ((WholeNumberField) pane.lookup("#render-samples")).set(1);
            });
            gui.click("#render-start");
            RenderTab second = (RenderTab) ((TabPane) pane.lookup("#renders")).getTabs().get(1);
            gui.until("the second one is done", () -> second.task().getState() == Worker.State.SUCCEEDED);
            gui.act(() -> gui.stage().getScene().lookup("#render-compare").requestFocus());
            gui.keys(KeyCode.DOWN);
            shoot(gui, "render-compare", theme);
        }
    }

    private static Scene scene() throws IOException, SceneFileException {
        return SceneFiles.read(Path.of("../scenes/showcase.xml")).withSettings(new RenderSettings(480, 270, 8, 2));
    }

    private static void shoot(Gui gui, String name, Theme theme) throws IOException {
        for (Node node : Gui.on(() -> gui.stage().getScene().getRoot().lookupAll(".label, .button"))) {
            if (node instanceof Labeled labeled && !labeled.getText().isEmpty()) {
                assertThat(Gui.on(() -> labeled.getWidth() + 1 - labeled.prefWidth(-1))).as("room for \"%s\"", labeled.getText()).isPositive();
            }
        }
        WritableImage image = Gui.on(() -> gui.stage().getScene().snapshot(null));
        int width = (int) image.getWidth();
        int height = (int) image.getHeight();
        int[] argb = new int[width * height];
        image.getPixelReader().getPixels(0, 0, width, height, PixelFormat.getIntArgbInstance(), argb, 0, width);
        BufferedImage copy = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        copy.setRGB(0, 0, width, height, argb, 0, width);
        Files.createDirectories(FOLDER);
        ImageIO.write(copy, "png", FOLDER.resolve((name + "-" + theme).toLowerCase(Locale.ROOT) + ".png").toFile());
    }
}
