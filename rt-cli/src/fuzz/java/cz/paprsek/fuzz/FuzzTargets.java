package cz.paprsek.fuzz;

import com.code_intelligence.jazzer.api.FuzzedDataProvider;
import com.code_intelligence.jazzer.junit.FuzzTest;
import cz.paprsek.cli.CommandLines;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.query.Filter;
import cz.paprsek.query.FilterException;
import cz.paprsek.query.SceneTables;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** What strangers can hand to the program. Each target lets through the one exception that is an answer; any other is a finding. */
class FuzzTargets {

    /** A scene is read or refused; one that is read can be written, and reads back as itself. */
    @FuzzTest(maxDuration = "60s")
    void sceneFile(byte[] file) throws IOException {
        Scene scene;
        try {
            scene = SceneFiles.read(new ByteArrayInputStream(file), "fuzz");
        } catch (SceneFileException refused) {
            return;
        }
        String text = SceneFiles.format(scene);
        try {
            if (!SceneFiles.parse(text).equals(scene)) {
                throw new AssertionError("does not read back as itself: " + text);
            }
        } catch (SceneFileException e) {
            throw new AssertionError("was written but is refused: " + text, e);
        }
    }

    /** A filter is understood or refused at a place within it, and can be asked of any scene. */
    @FuzzTest(maxDuration = "30s")
    void filter(FuzzedDataProvider data) {
        String text = data.consumeRemainingAsString();
        try {
            Filter.parse(text, SceneTables.SCENE).test(Scene.EMPTY);
        } catch (FilterException refused) {
            if (refused.position() < 1 || refused.position() > text.length() + 1) {
                throw new AssertionError("position " + refused.position() + " of a text of " + text.length(), refused);
            }
        }
    }

    /** A picture of any format is read or refused. */
    @FuzzTest(maxDuration = "30s")
    void picture(FuzzedDataProvider data) throws IOException {
        String ending = data.pickValue(new String[] {"png", "jpg", "bmp", "tif", "ppm", "pgm", "pfm", "txt", "lum", "hdr", "exr"});
        Path file = Files.createTempFile("fuzz", "." + ending);
        try {
            Files.write(file, data.consumeRemainingAsBytes());
            ImageFiles.read(file);
        } catch (IOException refused) {
            if (String.valueOf(refused.getMessage()).contains("\n")) {
                throw new AssertionError("more than one line: " + refused.getMessage(), refused);
            }
        } finally {
            Files.delete(file);
        }
    }

    /** Whatever stands behind the options of a command is understood or refused in one line; nothing is rendered. */
    @FuzzTest(maxDuration = "30s")
    void commandLine(FuzzedDataProvider data) {
        String option = data.pickValue(new String[] {"--size", "--region", "--threads", "--samples", "--max-depth", "--format", "--mode", "-o"});
        CommandLines.checkRefused("render", option, data.consumeRemainingAsString(), "/no/such/scene.xml");
    }
}
