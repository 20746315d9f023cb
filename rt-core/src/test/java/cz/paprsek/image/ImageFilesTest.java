package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class ImageFilesTest {
    @TempDir
    Path folder;

    private static Image noise(int width, int height) {
        Random random = new Random(7);
        Image image = new Image(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.set(x, y, 1.2 * random.nextDouble(), random.nextDouble(), 0.3 * random.nextDouble());
            }
        }
        return image;
    }

    /** Two columns, two rows: white and red above, a dim grey and light far above white below. */
    private static Image small() {
        Image image = new Image(2, 2);
        image.set(0, 0, 1, 1, 1);
        image.set(1, 0, 1, 0, 0);
        image.set(0, 1, 0.25, 0.25, 0.25);
        image.set(1, 1, 8, 8, 8);
        return image;
    }

    private static byte[] bytes(Image image, ImageFormat format) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageFiles.write(image, out, format);
        return out.toByteArray();
    }

    private static String text(Image image, ImageFormat format) throws IOException {
        return new String(bytes(image, format), StandardCharsets.US_ASCII);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "PNG", "bmp", "tif", "tiff"})
    void losslessBitmapsReadBackAsTheSamePixels(String ending) throws IOException {
        Image image = noise(37, 21);
        Path file = folder.resolve("noise." + ending);
        ImageFiles.write(image, file);
        BufferedImage read = Objects.requireNonNull(ImageIO.read(file.toFile()));
        assertThat(read.getRGB(0, 0, 37, 21, null, 0, 37)).isEqualTo(image.toArgb());
    }

    @ParameterizedTest
    @ValueSource(strings = {"jpg", "jpeg"})
    void jpegKeepsASmoothPictureNearlyAsItWas(String ending) throws IOException {
        Image image = new Image(64, 48);
        for (int y = 0; y < 48; y++) {
            for (int x = 0; x < 64; x++) {
                image.set(x, y, x / 63.0, y / 47.0, 0.2);
            }
        }
        Path file = folder.resolve("smooth." + ending);
        ImageFiles.write(image, file);
        BufferedImage read = Objects.requireNonNull(ImageIO.read(file.toFile()));
        for (int y = 0; y < 48; y++) {
            for (int x = 0; x < 64; x++) {
                int found = read.getRGB(x, y);
                assertThat(Math.abs((found >> 8 & 0xFF) - (image.argb(x, y) >> 8 & 0xFF))).isLessThan(12);
            }
        }
    }

    @Test
    void ppmHasThePixelsOfThePng() throws IOException {
        Image image = noise(5, 3);
        byte[] file = bytes(image, ImageFormat.PPM);
        assertThat(new String(file, 0, 11, StandardCharsets.US_ASCII)).isEqualTo("P6\n5 3\n255\n");
        assertThat(file).hasSize(11 + 45);
        for (int i = 0; i < 15; i++) {
            int argb = image.toArgb()[i];
            assertThat(file[11 + 3 * i]).isEqualTo((byte) (argb >> 16));
            assertThat(file[12 + 3 * i]).isEqualTo((byte) (argb >> 8));
            assertThat(file[13 + 3 * i]).isEqualTo((byte) argb);
        }
    }

    @Test
    void sixteenBitPpmIsLinearAndMostSignificantByteFirst() throws IOException {
        byte[] file = bytes(small(), ImageFormat.PPM16);
        assertThat(new String(file, 0, 13, StandardCharsets.US_ASCII)).isEqualTo("P6\n2 2\n65535\n");
        ByteBuffer numbers = ByteBuffer.wrap(file, 13, 24).order(ByteOrder.BIG_ENDIAN);
        int[] expected = {65535, 65535, 65535, 65535, 0, 0, 16384, 16384, 16384, 65535, 65535, 65535};
        for (int number : expected) {
            assertThat(numbers.getShort() & 0xFFFF).isEqualTo(number);
        }
        assertThat(file).hasSize(13 + 24);
    }

    @Test
    void pfmHoldsTheLightItselfBottomRowFirst() throws IOException {
        byte[] file = bytes(small(), ImageFormat.PFM);
        assertThat(new String(file, 0, 12, StandardCharsets.US_ASCII)).isEqualTo("PF\n2 2\n-1.0\n");
        ByteBuffer numbers = ByteBuffer.wrap(file, 12, 48).order(ByteOrder.LITTLE_ENDIAN);
        float[] expected = {0.25f, 0.25f, 0.25f, 8, 8, 8, 1, 1, 1, 1, 0, 0};
        for (float number : expected) {
            assertThat(numbers.getFloat()).isEqualTo(number);
        }
    }

    @Test
    void brightnessIsTheSrgbLevelOfTheLuminance() throws IOException {
        assertThat(text(small(), ImageFormat.TEXT)).isEqualTo("255 127\n137 255\n");
        assertThat(bytes(small(), ImageFormat.PGM)).endsWith((byte) 255, (byte) 127, (byte) 137, (byte) 255).hasSize(11 + 4);
    }

    @Test
    void rawTextIsLinearLuminanceInPlainDecimals() throws IOException {
        assertThat(text(small(), ImageFormat.RAW_TEXT)).isEqualTo("1 0.2126\n0.25 8\n");
        Image odd = new Image(3, 1);
        odd.set(0, 0, 1e-9, 1e-9, 1e-9);
        odd.set(1, 0, 2e-8, 2e-8, 2e-8);
        odd.set(2, 0, 1 - 1e-9, 1 - 1e-9, 1 - 1e-9);
        assertThat(text(odd, ImageFormat.RAW_TEXT)).isEqualTo("0 0.00000002 1\n");
    }

    @ParameterizedTest
    @EnumSource
    void aPictureOfOnePixelIsWrittenInEveryFormat(ImageFormat format) throws IOException {
        assertThat(bytes(new Image(1, 1), format)).isNotEmpty();
    }

    @Test
    void unknownEndingIsRefusedWithTheOnesThereAre() {
        assertThatThrownBy(() -> ImageFiles.write(small(), folder.resolve("a.gif")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(".png, .jpg, .jpeg, .bmp, .tif, .tiff, .ppm, .pgm, .pfm, .txt");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void formatsAreFoundByNameAndByEnding() {
        assertThat(ImageFormat.named("JPEG")).contains(ImageFormat.JPEG);
        assertThat(ImageFormat.named("ppm16")).contains(ImageFormat.PPM16);
        assertThat(ImageFormat.named("gif")).isEmpty();
        assertThat(ImageFormat.of(Path.of("a.b/c.PPM"))).contains(ImageFormat.PPM);
        assertThat(ImageFormat.of(Path.of("png"))).isEmpty();
        assertThat(ImageFormat.of(Path.of("/"))).isEmpty();
        assertThat(ImageFormat.PPM16.extension()).isEqualTo("ppm");
        assertThat(ImageFormat.RAW_TEXT.extension()).isEqualTo("txt");
    }
}
