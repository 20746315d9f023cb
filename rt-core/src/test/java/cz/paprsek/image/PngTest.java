package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.material.Rgb;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.IndexColorModel;
import java.awt.image.WritableRaster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Random;
import java.util.stream.Stream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Our PNGs as the platform reads them, and the platform's as we do. */
class PngTest {
    /** Every filter has rows where it is the best: flat ones, ramps either way, noise, edges. */
    private static Image mixture(int width, int height) {
        Image image = new Image(width, height);
        Random random = new Random(width);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                switch (y / 5 % 5) {
                    case 0 -> image.set(x, y, 0.2, 0.4, 0.6);
                    case 1 -> image.set(x, y, x / (double) width, 0.5, 1 - x / (double) width);
                    case 2 -> image.set(x, y, y / (double) height, x * y % 97 / 97.0, 0.1);
                    case 3 -> image.set(x, y, random.nextDouble(), random.nextDouble(), random.nextDouble());
                    default -> image.set(x, y, (x + y) / (double) (width + height), x / 7 % 2, (x - y) / 50.0);
                }
            }
        }
        return image;
    }

    /** In stripes of 249 rows, whatever the order in which its pixels are finished. */
    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void aPictureCompressedWhileItIsMadeHasTheSameBytes(int bits, @TempDir Path folder) throws IOException {
        Image image = mixture(700, 603);
        Image made = new Image(700, 603);
        ImageOptions options = ImageOptions.DEFAULT.withBits(bits).withOrigin(new Origin("mixture", "", "", ""));
        try (ImageFiles.GrowingPng png = new ImageFiles.GrowingPng(made, bits)) {
            for (int y = 0; y < 603; y += 201) {
                for (int x : new int[] {350, 0}) {
                    for (int i = 0; i < 350 * 201; i++) {
                        int column = x + i % 350;
                        int row = y + i / 350;
                        made.set(column, row, image.red(column, row), image.green(column, row), image.blue(column, row));
                    }
                    png.finished(y, 350, 201);
                }
            }
            assertThat(png.isOf(made, options)).isTrue();
            assertThat(png.isOf(image, options)).isFalse();
            assertThat(png.isOf(made, options.withExposure(1))).isFalse();
            assertThat(png.isOf(made, options.withBits(24 - bits))).isFalse();
            png.write(folder.resolve("grown.png"), options);
        }
        ImageFiles.write(image, folder.resolve("written.png"), options);
        assertThat(folder.resolve("grown.png")).hasSameBinaryContentAs(folder.resolve("written.png"));
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 300", "7, 5", "700, 603", "2000, 1"})
    void thePlatformReadsWhatWeWrite(int width, int height) throws IOException {
        Image image = mixture(width, height);
        BufferedImage back = Objects.requireNonNull(ImageIO.read(new ByteArrayInputStream(written(image, 8))));
        assertThat(back.getRGB(0, 0, width, height, null, 0, width)).isEqualTo(image.toArgb());
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "7, 5", "700, 303"})
    void thePlatformReadsSixteenBitsThatAreExactlyRounded(int width, int height) throws IOException {
        Image image = mixture(width, height);
        BufferedImage back = Objects.requireNonNull(ImageIO.read(new ByteArrayInputStream(written(image, 16))));
        assertThat(back.getRaster().getSampleModel().getSampleSize(0)).isEqualTo(16);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                assertThat(back.getRaster().getSample(x, y, 0)).isEqualTo(exact(image.red(x, y)));
                assertThat(back.getRaster().getSample(x, y, 2)).isEqualTo(exact(image.blue(x, y)));
            }
        }
    }

    private static int exact(float light) {
        return (int) Math.round(Rgb.encoded(Math.min(1, Math.max(0, light))) / 255 * 65_535);
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void whatIsWrittenReadsBackAsItWas(int bits, @TempDir Path folder) throws IOException {
        Image image = mixture(300, 200);
        StoredImage back = ImageFiles.readStored(Files.write(folder.resolve("a.png"), written(image, bits)));
        assertThat(back.isGrey()).isFalse();
        for (int y = 0; y < 200; y++) {
            for (int x = 0; x < 300; x++) {
                double light = Math.min(1, Math.max(0, image.blue(x, y)));
                assertThat((double) back.image().blue(x, y)).isCloseTo(light, offset(bits == 8 ? 0.0046 : 1.8e-5));
            }
        }
    }

    @Test
    void anyNumberOfThreadsWritesTheSameBytes() throws Exception {
        byte[] here = written(mixture(900, 800), 8);
        for (int processors : new int[] {1, 3}) {
            assertThat(OtherProcess.output("-XX:ActiveProcessorCount=" + processors, PngTest.class.getName())).isEqualTo(here);
        }
    }

    /** Writes the mixture to standard output, for the test above. */
    public static void main(String[] none) throws IOException {
        Png.write(mixture(900, 800), 8, Origin.UNTOLD, System.out);
        System.out.flush();
    }

    static Stream<Arguments> kinds() {
        byte[] ramp = new byte[16];
        for (int i = 0; i < 16; i++) {
            ramp[i] = (byte) (i * 17);
        }
        return Stream.of(
                Arguments.of("grey of 1 bit", ImageTypeSpecifier.createGrayscale(1, 0, false)),
                Arguments.of("grey of 2 bits", ImageTypeSpecifier.createGrayscale(2, 0, false)),
                Arguments.of("grey of 4 bits", ImageTypeSpecifier.createGrayscale(4, 0, false)),
                Arguments.of("grey of 8 bits", ImageTypeSpecifier.createGrayscale(8, 0, false)),
                Arguments.of("grey of 16 bits", ImageTypeSpecifier.createGrayscale(16, 1, false)),
                Arguments.of("palette of 2", new ImageTypeSpecifier(new IndexColorModel(1, 2, ramp, ramp, ramp), new IndexColorModel(1, 2, ramp, ramp, ramp)
                        .createCompatibleSampleModel(1, 1))),
                Arguments.of("palette of 16", new ImageTypeSpecifier(new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_BINARY, new IndexColorModel(4, 16, ramp, ramp, ramp)))),
                Arguments.of("palette of 256", new ImageTypeSpecifier(new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_INDEXED))),
                Arguments.of("colours of 8 bits", ImageTypeSpecifier.createFromBufferedImageType(BufferedImage.TYPE_INT_RGB)),
                Arguments.of("colours with opacity", ImageTypeSpecifier.createFromBufferedImageType(BufferedImage.TYPE_INT_ARGB)));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("kinds")
    void everyKindIsReadAsThePlatformReadsIt(String kind, ImageTypeSpecifier type, @TempDir Path folder) throws IOException {
        for (int[] size : new int[][] {{37, 23}, {1, 1}, {3, 2}, {8, 9}}) {
            for (boolean isInterlaced : new boolean[] {false, true}) {
                BufferedImage picture = noise(type, size[0], size[1]);
                Path file = Files.write(folder.resolve("a.png"), written(picture, isInterlaced));
                Image read = ImageFiles.read(file);
                BufferedImage theirs = Objects.requireNonNull(ImageIO.read(file.toFile()));
                WritableRaster raster = theirs.getRaster();
                ColorModel colors = theirs.getColorModel();
                for (int y = 0; y < size[1]; y++) {
                    for (int x = 0; x < size[0]; x++) {
                        double green = colors instanceof IndexColorModel || colors.getNumComponents() > 2
                                ? Rgb.linear(theirs.getRGB(x, y) >> 8 & 0xFF)
                                : Rgb.linear(255.0 * raster.getSample(x, y, 0) / ((1 << colors.getComponentSize(0)) - 1));
                        assertThat((double) read.green(x, y)).as("column %d, row %d, %s", x, y, isInterlaced).isCloseTo(green, offset(1e-7));
                    }
                }
            }
        }
    }

    private static BufferedImage noise(ImageTypeSpecifier type, int width, int height) {
        BufferedImage picture = type.createBufferedImage(width, height);
        Random random = new Random(3);
        WritableRaster raster = picture.getRaster();
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                for (int band = 0; band < raster.getNumBands(); band++) {
                    raster.setSample(x, y, band, random.nextInt(1 << raster.getSampleModel().getSampleSize(band)));
                }
            }
        }
        return picture;
    }

    private static byte[] written(BufferedImage picture, boolean isInterlaced) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            ImageWriteParam settings = writer.getDefaultWriteParam();
            settings.setProgressiveMode(isInterlaced ? ImageWriteParam.MODE_DEFAULT : ImageWriteParam.MODE_DISABLED);
            writer.setOutput(out);
            writer.write(null, new IIOImage(picture, null, null), settings);
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }

    private static byte[] written(Image image, int bits) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Png.write(image, bits, Origin.UNTOLD, bytes);
        return bytes.toByteArray();
    }

    /** What a short render must not pay for. */
    @Test
    void ourOwnFormatsNeedNothingOfTheDesktop(@TempDir Path folder) throws Exception {
        OtherProcess.output("--limit-modules=java.base", WithoutDesktop.class.getName(), folder.toString());
        assertThat(folder.toFile().list()).containsExactlyInAnyOrderElementsOf(WithoutDesktop.NAMES);
        for (String name : WithoutDesktop.NAMES) {
            assertThat(ImageFiles.read(folder.resolve(name)).width()).isEqualTo(40);
        }
    }
}
