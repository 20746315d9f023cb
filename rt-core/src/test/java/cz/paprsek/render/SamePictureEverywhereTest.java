package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * The pictures' digests as recorded: the same to the last bit on every JDK from 17 on, on every machine, for any number of threads. Whoever
 * changes the order of arithmetic on purpose records the new ones; what they differ in from the old is the cross-check's to judge.
 */
class SamePictureEverywhereTest {
    private static final int FRAME = 30;
    private static final Path RECORD = Path.of("src/test/resources/pictures.sha256");

    @Test
    void picturesAreThoseThatWereRecorded() throws Exception {
        StringBuilder found = new StringBuilder();
        for (String name : List.of("combined-room", "combined-table", "csg-nested", "glass-shapes", "highlights", "torus")) {
            Scene scene = SceneFiles.read(Path.of("src/test/resources/crosscheck", name + ".xml"));
            found.append(digest(scene.withSettings(scene.settings().withSize(200, 150)))).append("  ").append(name).append('\n');
        }
        found.append(digest(Scenes.random(21, 60).withSettings(new RenderSettings(200, 150, 6, 2)))).append("  random\n");
        Scene paths = SceneFiles.read(Path.of("../scenes/cornell.xml"));
        found.append(digest(paths.withSettings(paths.settings().withSize(40, 40).withSamples(72)))).append("  cornell\n");
        for (String name : List.of("glass-table", "sunlit-room", "hdr-still-life", "feast", "sign", "gyroid", "shell", "knot", "tumbler", "island")) {
            found.append(shipped(name, 0)).append("  ").append(name).append('\n');
        }
        // Of what moves, while the formulas of its time are at work.
        for (String name : List.of("carousel", "flight", "toy-train")) {
            found.append(shipped(name, FRAME)).append("  ").append(name).append(" ").append(FRAME).append('\n');
        }
        assertThat(found.toString()).as("digests on Java %s, to be recorded in %s if the change is meant", Runtime.version(), RECORD)
                .isEqualTo(Files.readString(RECORD));
    }

    /** A shipped scene, small, with few rays. */
    private static String shipped(String name, int frame) throws Exception {
        Path file = Path.of("../scenes", name + ".xml");
        Scene read = SceneFiles.read(file);
        Scene scene = frame == 0 ? read : SceneFiles.frames(read).apply(frame);
        RenderSettings few = scene.settings().withSize(64, 48).withSamples(scene.settings().isPath() ? 4 : 1);
        return digest(Renderer.render(scene.withSettings(few), Assets.beside(file), RenderOptions.of(few), RenderMonitor.NONE, TileStore.NONE).image());
    }

    private static String digest(Scene scene) throws Exception {
        return digest(Renderer.render(scene));
    }

    private static String digest(Image image) throws Exception {
        ByteBuffer bits = ByteBuffer.allocate(12 * image.width() * image.height());
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                bits.putFloat(image.red(x, y)).putFloat(image.green(x, y)).putFloat(image.blue(x, y));
            }
        }
        return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bits.array()));
    }
}
