package cz.paprsek.resume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.asset.Assets;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Files of tiles that are not what was written. */
class CheckpointTest {
    private static final int BEGINNING = 48;
    private static final int RECORD_HEAD = 24;
    /** As large as a screen, with many numbers kept of each pixel. */
    private static final RenderSettings SETTINGS = new RenderSettings(3840, 2160, 4, 1).withIntegrator(Integrator.PATH).withSamples(64, 4096).withError(0.01).withFilter(PixelFilter.MITCHELL);

    @TempDir
    Path folder;

    private Path tiles;

    @BeforeEach
    void name() {
        tiles = Checkpoint.fileFor(folder.resolve("picture.pfm"));
    }

    private long pixels(boolean anew) throws IOException {
        Path picture = folder.resolve("picture.pfm");
        try (Checkpoint checkpoint = Checkpoint.open(picture, Scene.EMPTY, Assets.none(), RenderOptions.of(SETTINGS), anew)) {
            return checkpoint.pixels();
        }
    }

    /** By a damaged size, bytes of tiles would be more than an int can count, or as many as there is memory for, or more than the file has left. */
    @ParameterizedTest
    @CsvSource({"3840,2160", "2000,1500", "640,360", "33,1", "1,33", "32,32"})
    void aTileThatCannotBeThereIsTorn(int width, int height) throws IOException {
        assertThat(pixels(false)).isZero();
        byte[] begun = Files.readAllBytes(tiles);
        assertThat(begun).hasSize(BEGINNING);
        byte[] torn = ByteBuffer.allocate(BEGINNING + RECORD_HEAD + 1000).put(begun).putInt(0).putInt(0).putInt(width).putInt(height).putInt(1).putInt(7).array();
        Files.write(tiles, torn);
        assertThat(pixels(false)).isZero();
        assertThat(tiles).hasBinaryContent(begun);
    }

    /** Sums that were kept are rounded otherwise by other versions, and would not go on to the same picture. */
    @Test
    void tilesOfAnotherVersionAreRefusedAndLeftAloneOrBegunAnew() throws IOException {
        assertThat(pixels(false)).isZero();
        byte[] begun = Files.readAllBytes(tiles);
        assertThat(new String(Arrays.copyOf(begun, 16), StandardCharsets.US_ASCII)).isEqualTo("paprsek tiles 5\n");
        byte[] before = begun.clone();
        before[14] = '4';
        Files.write(tiles, before);
        assertThatThrownBy(() -> pixels(false)).isInstanceOf(Checkpoint.Refused.class)
                .hasMessage(tiles + ": holds tiles written by another version, with which this one cannot go on; delete it to begin anew, or give this picture another name");
        assertThat(tiles).hasBinaryContent(before);
        assertThat(pixels(true)).isZero();
        assertThat(tiles).hasBinaryContent(begun);
    }
}
