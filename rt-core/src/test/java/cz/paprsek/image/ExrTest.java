package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.image.exr.Half;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Ours against files that the Python binding of the OpenEXR library (3.5.3) wrote: R = x/4, G = y/8, B = (xy mod 7)/2 − 1, 29 × 37 pixels. */
class ExrTest {
    @Test
    void layersWithoutPlanesAreRefusedRatherThanWrittenSoThatNobodyCanReadThem(@TempDir Path folder) {
        assertThatThrownBy(() -> ImageFiles.write(Layers.ofSize(2, 2), folder.resolve("none.exr"), ImageOptions.DEFAULT))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("no planes");
        assertThat(folder.resolve("none.exr")).doesNotExist();
    }

    private static final Path RECORDED = Path.of("src/test/resources/exr");

    @ParameterizedTest
    @ValueSource(strings = {"none-half", "none-float", "rle-half", "rle-float", "zips-half", "zips-float", "zip-half", "zip-float", "layers"})
    void filesOfTheReferenceLibraryAreReadExactly(String name) throws IOException {
        StoredImage read = ImageFiles.readStored(RECORDED.resolve(name + ".exr"));
        assertThat(read.precision()).isEqualTo(name.endsWith("float") ? Precision.FLOAT : Precision.HALF);
        assertThat(read.isGrey()).isFalse();
        for (int y = 0; y < 37; y++) {
            for (int x = 0; x < 29; x++) {
                assertThat(new float[] {read.image().red(x, y), read.image().green(x, y), read.image().blue(x, y)})
                        .containsExactly(x / 4f, y / 8f, x * y % 7 / 2f - 1);
            }
        }
    }

    @Test
    void layersAreReadByTheirNames() throws IOException {
        Layers layers = ImageFiles.readLayers(RECORDED.resolve("layers.exr"));
        assertThat(layers.names()).containsExactly("A", "B", "G", "R", "depth.Z", "objectid");
        assertThat(layers.at("depth.Z", 5, 16)).isEqualTo(5 / 4f + 16 / 8f);
        assertThat(layers.at("objectid", 28, 36)).isEqualTo(3628);
        assertThat(layers.at("A", 3, 3)).isEqualTo(1);
        assertThat(layers.image("").green(2, 8)).isEqualTo(1);
        assertThatThrownBy(() -> layers.image("albedo")).hasMessageContaining("there is no plane named albedo.Y among ");
    }

    @Test
    void brightnessAloneIsGrey() throws IOException {
        StoredImage read = ImageFiles.readStored(RECORDED.resolve("grey.exr"));
        assertThat(read.isGrey()).isTrue();
        assertThat(read.image().blue(8, 0)).isEqualTo(2);
    }

    @ParameterizedTest
    @CsvSource({
        "piz, it is compressed by PIZ; none",
        "pxr24, it is compressed by PXR24; none",
        "b44, it is compressed by B44; none",
        "dwaa, it is compressed by DWAA; none",
        "tiled, its pixels lie in tiles",
    })
    void otherKindsAreRefusedByName(String name, String sentence) {
        assertThatThrownBy(() -> ImageFiles.read(RECORDED.resolve(name + ".exr"))).isInstanceOf(IOException.class)
                .hasMessageStartingWith(RECORDED.resolve(name + ".exr") + ": this kind of OpenEXR file cannot be read: " + sentence);
    }

    @ParameterizedTest
    @ValueSource(ints = {16, 32})
    void layersReadBackAsTheyWere(int bits, @TempDir Path folder) throws IOException {
        Random random = new Random(1);
        float[] depth = new float[50 * 33];
        float[] id = new float[50 * 33];
        Image albedo = new Image(50, 33);
        for (int i = 0; i < depth.length; i++) {
            depth[i] = Half.toFloat(Half.of(random.nextFloat() * 1000));
            id[i] = i % 7;
            albedo.set(i % 50, i / 50, i % 2, i % 8 / 8.0, 0.25);
        }
        Path file = folder.resolve("a.exr");
        ImageFiles.write(Layers.of(new Image(50, 33)).with("albedo", albedo).with("depth.Z", depth).with("a name longer than thirty-one letters.id", id), file,
                ImageOptions.DEFAULT.withBits(bits));
        Layers back = ImageFiles.readLayers(file);
        for (int i = 0; i < depth.length; i++) {
            assertThat(back.at("depth.Z", i % 50, i / 50)).isEqualTo(depth[i]);
            assertThat(back.at("a name longer than thirty-one letters.id", i % 50, i / 50)).isEqualTo(id[i]);
            assertThat(back.image("albedo").green(i % 50, i / 50)).isEqualTo(i % 8 / 8f);
        }
        assertThat(ImageFiles.read(file).red(0, 0)).isZero();
    }

    @Test
    void whatCannotBeALayerIsRefused() {
        Layers layers = Layers.ofSize(2, 2).with("Z", new float[4]);
        assertThatThrownBy(() -> layers.with("Z", new float[4])).hasMessage("there are two planes named Z");
        assertThatThrownBy(() -> layers.with("", new float[4])).hasMessageContaining("from 1 to 200 characters");
        assertThatThrownBy(() -> layers.with("Y", new float[5])).hasMessageContaining("5 values does not fit 2 × 2 pixels");
        assertThatThrownBy(() -> layers.with("", new Image(1, 4))).hasMessageContaining("1 × 4 pixels does not fit 2 × 2");
        assertThatThrownBy(() -> ImageFiles.write(layers, Path.of("a.exr"), ImageOptions.DEFAULT.withBits(8))).hasMessage("exr has 16 or 32 bits per channel, not 8");
    }

    @Test
    void everyHalfIsAFloatAndBack() {
        for (int bits = 0; bits < 1 << 16; bits++) {
            float value = Half.toFloat((short) bits);
            assertThat(Float.isNaN(value) ? Half.of(value) & 0x7C00 : Half.of(value) & 0xFFFF).isEqualTo(Float.isNaN(value) ? 0x7C00 : bits);
        }
    }

    /** By its definition: no other half is nearer, and of two as near it is the even one. */
    @Test
    void theNearestHalfIsFound() {
        Random random = new Random(5);
        for (int i = 0; i < 300_000; i++) {
            float value = Math.scalb(random.nextFloat() + (i % 3 == 0 ? 1 : 0), random.nextInt(46) - 31);
            value = i % 5 == 0 ? (Half.toFloat(Half.of(value)) + Half.toFloat((short) (Half.of(value) + 1))) / 2 : value;
            short half = Half.of(value);
            if (Float.isInfinite(Half.toFloat(half))) {
                assertThat(value).isGreaterThanOrEqualTo(65_520);
                continue;
            }
            double error = Math.abs((double) Half.toFloat(half) - value);
            for (int other : new int[] {half - 1, half + 1}) {
                double otherError = other < 0 || other >= 0x7C00 ? Double.MAX_VALUE : Math.abs((double) Half.toFloat((short) other) - value);
                assertThat(error < otherError || (error == otherError && half % 2 == 0)).as("%s", value).isTrue();
            }
        }
    }
}
