package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.material.Rgb;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class ImageFilesTest {
    /** Two rows of three: black, white, red; mid grey, beyond white, below black. */
    private static Image sample() {
        Image image = new Image(3, 2);
        image.set(1, 0, 1, 1, 1);
        image.set(2, 0, 1, 0, 0);
        image.set(0, 1, 0.5, 0.5, 0.5);
        image.set(1, 1, 7, 2, 1.5);
        image.set(2, 1, -1, -0.1, 0);
        return image;
    }

    @Test
    void eachChannelRoundsToTheNearestOf256() {
        for (int v = 0; v < 256; v++) {
            assertThat(Srgb.encode((float) Rgb.linear(v))).isEqualTo(v);
            if (v > 0) {
                double edge = Rgb.linear(v - 0.5);
                assertThat(Srgb.encode((float) (edge * (1 + 1e-6)))).isEqualTo(v);
                assertThat(Srgb.encode((float) (edge * (1 - 1e-6)))).isEqualTo(v - 1);
            }
        }
        assertThat(Srgb.encode(Float.NaN)).isZero();
        assertThat(Srgb.encode(Float.POSITIVE_INFINITY)).isEqualTo(255);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp", "tif"})
    void losslessFormatsReadBackAsTheyWere(String extension, @TempDir Path folder) throws IOException {
        Path file = folder.resolve("a." + extension);
        ImageFiles.write(sample(), file);
        BufferedImage back = ImageIO.read(file.toFile());
        int[] pixels = back.getRGB(0, 0, 3, 2, null, 0, 3);
        assertThat(pixels).containsExactly(0xFF000000, 0xFFFFFFFF, 0xFFFF0000, 0xFFBCBCBC, 0xFFFFFFFF, 0xFF000000);
    }

    @Test
    void jpegIsCloseAndTheRightSize(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("a.JPEG");
        Image image = new Image(64, 48);
        for (int i = 0; i < 64 * 48; i++) {
            image.set(i % 64, i / 64, 0.5, 0.25, 0.1);
        }
        ImageFiles.write(image, file);
        BufferedImage back = ImageIO.read(file.toFile());
        assertThat(back.getWidth()).isEqualTo(64);
        assertThat(Math.abs((back.getRGB(30, 20) >> 16 & 255) - (image.argb(30, 20) >> 16 & 255))).isLessThan(6);
    }

    @Test
    void portableMapsHaveTheBytesOfTheirSpecification() throws IOException {
        assertThat(bytes(ImageFormat.PPM)).isEqualTo(concat("P6\n3 2\n255\n", 0, 0, 0, 255, 255, 255, 255, 0, 0, 188, 188, 188, 255, 255, 255, 0, 0, 0));
        assertThat(bytes(ImageFormat.PGM)).isEqualTo(concat("P5\n3 2\n255\n", 0, 255, 127, 188, 255, 0));
        byte[] wide = bytes(ImageFormat.PPM16);
        ByteBuffer steps = ByteBuffer.wrap(wide, wide.length - 36, 36).slice().order(ByteOrder.BIG_ENDIAN);
        assertThat(steps.getShort(18) & 0xFFFF).as("red of mid grey").isEqualTo(32768);
        assertThat(steps.getShort(24) & 0xFFFF).as("clamped").isEqualTo(65535);
        byte[] floats = bytes(ImageFormat.PFM);
        ByteBuffer values = ByteBuffer.wrap(floats, floats.length - 72, 72).slice().order(ByteOrder.LITTLE_ENDIAN);
        assertThat(values.getFloat(0)).as("the bottom row comes first").isEqualTo(0.5f);
        assertThat(values.getFloat(12)).as("not clamped").isEqualTo(7f);
        assertThat(new String(floats, 0, floats.length - 72, StandardCharsets.US_ASCII)).isEqualTo("PF\n3 2\n-1.0\n");
    }

    @Test
    void brightnessIsOneRowALine() throws IOException {
        assertThat(new String(bytes(ImageFormat.TXT), StandardCharsets.US_ASCII)).isEqualTo("0 255 127\n188 255 0\n");
        assertThat(new String(bytes(ImageFormat.RAW), StandardCharsets.US_ASCII).lines().findFirst()).hasValueSatisfying(
                line -> assertThat(line).startsWith("0 1 0.2126"));
    }

    @Test
    void rawBrightnessIsInPlainDecimals() throws IOException {
        Image odd = new Image(6, 1);
        double[] light = {0, 1e-9, 2e-8, 1 - 1e-9, 0.25, 40.5};
        for (int x = 0; x < light.length; x++) {
            odd.set(x, 0, light[x], light[x], light[x]);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageFiles.write(odd, out, ImageFormat.RAW);
        assertThat(out.toString(StandardCharsets.US_ASCII)).isEqualTo("0 0 0.00000002 1 0.25 40.5\n");
    }

    @ParameterizedTest
    @EnumSource
    void everyFormatIsKnownByItsEnding(ImageFormat format) throws IOException {
        assertThat(ImageFormat.ofFile("some.dir/picture." + format.extension())).contains(format);
        assertThat(bytes(format)).isNotEmpty();
    }

    @Test
    void aPictureThatCannotBeWrittenLeavesTheOldOneWhole(@TempDir Path folder) throws IOException {
        assertThatThrownBy(() -> ImageFiles.write(sample(), folder)).hasMessage(folder + ": this is a directory, not a file");
        Path inNoFolder = folder.resolve("none").resolve("a.png");
        assertThatThrownBy(() -> ImageFiles.write(sample(), inNoFolder)).hasMessage(inNoFolder + ": cannot be written, there is no such folder");
        Path old = Files.writeString(folder.resolve("a.png"), "old");
        assertThatThrownBy(() -> cz.paprsek.io.AtomicFile.write(old, out -> {
            out.write(1);
            throw new IOException("disk full");
        })).hasMessage("disk full");
        assertThat(old).hasContent("old");
        assertThat(folder.toFile().list()).containsExactly("a.png");
    }

    private static byte[] bytes(ImageFormat format) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageFiles.write(sample(), out, format);
        return out.toByteArray();
    }

    private static byte[] concat(String header, int... values) {
        byte[] start = header.getBytes(StandardCharsets.US_ASCII);
        byte[] all = Arrays.copyOf(start, start.length + values.length);
        for (int i = 0; i < values.length; i++) {
            all[start.length + i] = (byte) values[i];
        }
        return all;
    }
}
