package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.Rgb;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URISyntaxException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import javax.imageio.ImageIO;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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

    @ParameterizedTest
    @EnumSource
    void aFullDiskIsCalledSo(ImageFormat format) {
        OutputStream full = new OutputStream() {
            @Override
            public void write(int value) throws IOException {
                throw new IOException("No space left on device");
            }
        };
        assertThatThrownBy(() -> ImageFiles.write(sample(), full, format)).isInstanceOf(IOException.class).hasMessage("No space left on device");
    }

    @ParameterizedTest
    @EnumSource
    void noPictureIsSmallerThanForetold(ImageFormat format) throws IOException {
        Image image = sample();
        assertThat((long) bytes(format).length).isGreaterThanOrEqualTo(format.leastBytes(image.width(), image.height()));
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

    @ParameterizedTest
    @EnumSource(ImageFormat.class)
    void everyFormatReadsBackAsPreciselyAsItTellsLight(ImageFormat format, @TempDir Path folder) throws IOException {
        Path file = folder.resolve("a." + format.extension());
        Image image = new Image(17, 11);
        for (int i = 0; i < 17 * 11; i++) {
            image.set(i % 17, i / 17, i / 187.0, format == ImageFormat.JPG ? i / 187.0 : 1 - i / 200.0, format == ImageFormat.JPG ? i / 187.0 : i * i / 4e4);
        }
        ImageFiles.write(image, file);
        StoredImage back = ImageFiles.readStored(file);
        double step = switch (back.precision()) {
            case EIGHT_BIT -> 0.0046 * (format == ImageFormat.JPG ? 3 : 1);
            case SIXTEEN_BIT -> 0.51 / 65535;
            case HALF -> 0x1p-12;
            case SHARED_EXPONENT -> 0x1p-8;
            case FLOAT -> 1e-7;
        };
        assertThat(back.isGrey()).isEqualTo(List.of(ImageFormat.PGM, ImageFormat.TXT, ImageFormat.RAW).contains(format));
        for (int y = 0; y < 11; y++) {
            for (int x = 0; x < 17; x++) {
                double luminance = 0.2126 * image.red(x, y) + 0.7152 * image.green(x, y) + 0.0722 * image.blue(x, y);
                assertThat((double) back.image().red(x, y)).isCloseTo(back.isGrey() ? luminance : image.red(x, y), within(step));
                assertThat((double) back.image().green(x, y)).isCloseTo(back.isGrey() ? luminance : image.green(x, y), within(step));
                assertThat((double) back.image().blue(x, y)).isCloseTo(back.isGrey() ? luminance : image.blue(x, y), within(step));
            }
        }
    }

    @Test
    void sixteenBitPngOfLinearLightIsReadAsItSays(@TempDir Path folder) throws IOException {
        // 2 × 1 pixels, written by POV-Ray 3.7 with a file gamma of 1: 0.25, 0.5, 1 and 0, 0.125, 0.75.
        Path file = Files.write(folder.resolve("a.png"), Base64.getDecoder().decode(LINEAR_PNG));
        StoredImage read = ImageFiles.readStored(file);
        assertThat(read.precision()).isEqualTo(StoredImage.Precision.SIXTEEN_BIT);
        assertThat(new float[] {read.image().red(0, 0), read.image().green(0, 0), read.image().blue(0, 0)})
                .containsExactly(new float[] {0.25f, 0.5f, 1}, offset(1e-5f));
        assertThat(new float[] {read.image().red(1, 0), read.image().green(1, 0), read.image().blue(1, 0)})
                .containsExactly(new float[] {0, 0.125f, 0.75f}, offset(1e-5f));
    }

    @Test
    void portableMapsOfOthersAreRead(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("a.ppm");
        Files.write(file, "P6 # made by hand\n1\n#\n 1 15\n\17\0\7".getBytes(StandardCharsets.ISO_8859_1));
        assertThat(ImageFiles.read(file).red(0, 0)).isEqualTo(1);
        assertThat((double) ImageFiles.read(file).blue(0, 0)).isCloseTo(Rgb.linear(119), within(1e-6));
        ByteBuffer big = ByteBuffer.allocate(8);
        Files.write(file, concat("Pf\n1 2\n1.0\n".getBytes(StandardCharsets.US_ASCII), big.putFloat(2.5f).putFloat(-1).array()));
        assertThat(ImageFiles.read(file).green(0, 0)).as("the top row comes last").isEqualTo(-1);
        assertThat(ImageFiles.read(file).blue(0, 1)).isEqualTo(2.5f);
    }

    @Test
    void sixteenBitMapsOfOthersAreSrgbLikeTheirPng() throws Exception {
        // One picture; the second was written by ImageMagick 6.9 from the first.
        StoredImage png = ImageFiles.readStored(resource("srgb16.png"));
        StoredImage map = ImageFiles.readStored(resource("srgb16.ppm"));
        ImageComparison comparison = ImageComparison.of(png, map, 0);
        assertThat(comparison.unit()).isEqualTo(ImageComparison.Unit.LINEAR);
        assertThat(comparison.largest()).isZero();
    }

    private static Path resource(String name) throws URISyntaxException {
        return Path.of(Objects.requireNonNull(ImageFilesTest.class.getResource(name), name).toURI());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "a.ppm   | P6\\n1 1\\n                                                         | false",
        "a.ppm   | P6\\n# linear light\\n1 1\\n                                         | true",
        "a.ppm   | P6\\n# made by hand\\n#linear light\\n#\\n1 1\\n                       | true",
        "a.ppm   | P6\\n# not linear light\\n1 1\\n                                     | false",
        "a.ppm16 | P6\\n1 1\\n                                                         | true",
        "a.ppm   | P6\\n# Software: POV-Ray 3.7.0.10.unofficial\\n# Compiler: g++\\n1 1\\n | true",
        "a.ppm   | P6\\n#Render Date: 2026-11-27 21:17:54Z\\n#Compiler: g++\\n1 1\\n       | false",
    })
    void aSixteenBitMapIsLinearIfItSaysSo(String name, String head, boolean isLinear, @TempDir Path folder) throws IOException {
        Path file = Files.write(folder.resolve(name), concat(head.replace("\\n", "\n") + "65535\n", 0x80, 0, 0x40, 0, 0, 0));
        Image read = ImageFiles.read(file);
        double half = 0x8000 / 65_535.0;
        assertThat((double) read.red(0, 0)).isCloseTo(isLinear ? half : Rgb.linear(255 * half), within(1e-7));
    }

    @Test
    void ofPovRaysEightBitsNothingIsAssumedAndOfOursTheCommentCounts(@TempDir Path folder) throws IOException {
        Path file = Files.write(folder.resolve("a.ppm"), concat("P6\n# Software: POV-Ray 3.7\n1 1\n255\n", 188, 0, 0));
        assertThat((double) ImageFiles.read(file).red(0, 0)).isCloseTo(Rgb.linear(188), within(1e-7));
        // A converter that halves the bits keeps comment and values.
        Files.write(file, concat("P6\n# linear light\n1 1\n255\n", 188, 0, 0));
        assertThat((double) ImageFiles.read(file).red(0, 0)).isCloseTo(188 / 255.0, within(1e-7));
    }

    @ParameterizedTest
    @ValueSource(strings = {"x.gif", "x.PNGG", "x.", "a.png.xyz", "x.xml"})
    void anEndingThatIsNoFormatIsRefusedWithThoseThereAre(String name, @TempDir Path folder) {
        Path file = folder.resolve(name);
        assertThatThrownBy(() -> ImageFiles.write(sample(), file)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage(file + ": there is no picture format \"" + name.substring(name.lastIndexOf('.') + 1)
                        + "\" here; the ending should be one of png, jpg, bmp, tif, ppm, pgm, pfm, txt, lum, ppm16, hdr, exr");
        assertThat(folder).isEmptyDirectory();
    }

    @ParameterizedTest
    @ValueSource(strings = {"picture", ".png", "folder.xml/picture"})
    void withoutAnEndingItIsPng(String name, @TempDir Path folder) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        ImageFiles.write(sample(), file);
        assertThat(Files.readAllBytes(file)).startsWith(0x89, 'P', 'N', 'G');
    }

    @ParameterizedTest
    @CsvSource({"-1, 0", "3, 0", "0, -1", "0, 2", "3, -1", "2147483647, 2147483647", "-2147483648, 1", "1431655766, 0"})
    void aPixelThatIsNotThereIsRefusedWhereverItIsNamed(int x, int y) {
        Image image = sample();
        List<ThrowingCallable> calls = List.of(() -> image.red(x, y), () -> image.green(x, y), () -> image.blue(x, y), () -> image.argb(x, y),
                () -> image.set(x, y, 1, 1, 1));
        for (ThrowingCallable call : calls) {
            assertThatThrownBy(call).isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("pixel " + x + "," + y + " must lie inside the picture of 3 × 2 pixels");
        }
        assertThat(image.toArgb()).isEqualTo(sample().toArgb());
    }

    @Test
    void aWriteThatIsInterruptedLeavesTheOldFileWhole(@TempDir Path folder) throws IOException {
        Path old = Files.writeString(folder.resolve("a.png"), "old");
        Thread.currentThread().interrupt();
        try {
            assertThatThrownBy(() -> ImageFiles.write(sample(), old)).isInstanceOf(IOException.class).hasMessageContaining(old.toString());
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
        assertThat(old).hasContent("old");
        assertThat(folder.toFile().list()).containsExactly("a.png");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "a.ppm | P6 2 2 255 abc         | a picture of 2 × 2 pixels does not fit into a file of 14 bytes: it is cut off or damaged",
        "a.ppm | P6 2 x 255 abc         | should have a number where it has \"x\"",
        "a.ppm | P6 2 0 255 abc         | the picture's height must be a whole number from 1 to 65536",
        "a.ppm | P6 65536 65536 255 abc | cut off",
        "a.ppm | P6 65                  | the file is cut off after 5 bytes",
        "a.png | hello                  | not a picture of a kind that can be read",
        "a.png | ''                     | not a picture of a kind that can be read",
        "a.txt | 1 2 x                  | row 1 should have numbers 0-255, but has \"x\"",
        "a.txt | 1 2 256                | but has \"256\"",
        "a.lum | ''                     | the picture is empty",
    })
    void whatIsNotAPictureIsRefusedInOneLine(String name, String content, String sentence, @TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve(name), content);
        assertThatThrownBy(() -> ImageFiles.read(file)).isInstanceOf(IOException.class)
                .hasMessageStartingWith(file + ": ").hasMessageContaining(sentence).hasMessageNotContaining("\n");
    }

    @Test
    void damagedPngIsRefusedOrReadButNeverAnythingElse(@TempDir Path folder) throws IOException {
        byte[] good = Base64.getDecoder().decode(LINEAR_PNG);
        Random random = new Random(4);
        Path file = folder.resolve("a.png");
        for (int i = 0; i < 300; i++) {
            byte[] bad = Arrays.copyOf(good, i % 3 == 0 ? random.nextInt(good.length) : good.length);
            for (int k = 0; k < 3 && bad.length > 0; k++) {
                bad[random.nextInt(bad.length)] = (byte) random.nextInt();
            }
            Files.write(file, bad);
            try {
                assertThat(ImageFiles.read(file).width()).isPositive();
            } catch (IOException refused) {
                assertThat(refused).hasMessageStartingWith(file + ": ");
            }
        }
    }

    private static byte[] concat(byte[] a, byte[] b) {
        byte[] both = Arrays.copyOf(a, a.length + b.length);
        System.arraycopy(b, 0, both, a.length, b.length);
        return both;
    }

    private static final String LINEAR_PNG =
            "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABEAIAAAAr0DSeAAAABGdBTUEAAYagMeiWXwAAAANzQklUEBAQWKO9JwAAAAlvRkZzAAAAAAAAAAAA2i"
            + "q2zgAAAAd0SU1FB+oLGRMQDQvZyIUAAAAkdEVYdFNvZnR3YXJlAFBPVi1SYXkgMy43LjAuMTAudW5vZmZpY2lhbHF05FkAAABWdEVYdENvbW1l"
            + "bnQAUmVuZGVyIERhdGU6IDIwMjYtMTEtMjUgMTk6MTY6MTNaClBsYXRmb3JtOiB4ODZfNjQtcGMtbGludXgtZ251CkNvbXBpbGVyOiBnKysKxn"
            + "GFsAAAABVJREFUCJljcGBoYPj/n4FBgWH/fwAZ+wSd3NPGewAAAABJRU5ErkJggg==";
}
