package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.Item;
import cz.paprsek.fx.view.Theme;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javafx.scene.image.WritableImage;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures of the main states, in target/screenshots, to be looked at by people. */
class ScreenshotTest {
    private static final Path FOLDER = Path.of("target/screenshots");

    @TempDir
    Path folder;

    @Test
    void bothThemesAndLanguages() throws IOException {
        try (EditorGui editor = new EditorGui(folder, Templates.read("showcase"))) {
            editor.gui.act(() -> editor.model().select(Item.body(1)));
            shoot(editor, "light-1280x800");
            editor.gui.act(() -> editor.editor.theme().set(Theme.DARK));
            shoot(editor, "dark-1280x800");
            editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            editor.gui.act(() -> editor.model().select(Item.CAMERA));
            shoot(editor, "dark-czech-1280x800");
        }
        try (EditorGui editor = new EditorGui(folder, Templates.read("test"), 1600, 1000)) {
            editor.gui.act(() -> editor.editor.theme().set(Theme.LIGHT));
            editor.gui.act(() -> editor.model().select(Item.body(8), Item.light(0)));
            shoot(editor, "light-1600x1000");
        }
    }

    private static void shoot(EditorGui editor, String name) throws IOException {
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        editor.gui.pulse();
        WritableImage image = Gui.on(() -> editor.gui.stage().getScene().snapshot(null));
        int width = (int) image.getWidth();
        int height = (int) image.getHeight();
        BufferedImage copy = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                copy.setRGB(x, y, image.getPixelReader().getArgb(x, y));
            }
        }
        Files.createDirectories(FOLDER);
        assertThat(ImageIO.write(copy, "png", FOLDER.resolve(name + ".png").toFile())).isTrue();
    }
}
