package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RadianceTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(ints = {1, 7, 8, 129, 1000})
    void lightReadsBackWithinHalfAStepOfTheBrightestChannel(int width) throws IOException {
        Image image = new Image(width, 20);
        Random random = new Random(2);
        for (int i = 0; i < 20 * width; i++) {
            double bright = Math.scalb(1.0, random.nextInt(60) - 30);
            image.set(i % width, i / width, i % 4 < 2 ? 0.5 : bright * random.nextDouble(), i / 9 % 3, -0.1 + bright * random.nextDouble());
        }
        Path file = folder.resolve("a.hdr");
        ImageFiles.write(image, file);
        Image back = ImageFiles.read(file);
        for (int y = 0; y < 20; y++) {
            for (int x = 0; x < width; x++) {
                double most = Math.max(image.red(x, y), Math.max(image.green(x, y), image.blue(x, y)));
                assertThat((double) back.red(x, y)).isCloseTo(Math.max(0, image.red(x, y)), offset(most / 256 + 1e-30));
                assertThat((double) back.blue(x, y)).isCloseTo(Math.max(0, image.blue(x, y)), offset(most / 256 + 1e-30));
            }
        }
    }

    @Test
    void theLargestAndTheOddestLightHasItsPlace() throws IOException {
        Image image = new Image(4, 1);
        image.set(0, 0, Float.MAX_VALUE, 1, Double.POSITIVE_INFINITY);
        image.set(1, 0, Double.NaN, 1, 0);
        image.set(2, 0, 1e-45, 0, 0);
        image.set(3, 0, 255.9 / 256, 0, 0);
        ImageFiles.write(image, folder.resolve("a.hdr"));
        Image back = ImageFiles.read(folder.resolve("a.hdr"));
        assertThat(back.red(0, 0)).isGreaterThan(1e38f);
        assertThat(back.green(1, 0)).isEqualTo(1);
        assertThat(back.red(2, 0)).isZero();
        assertThat(back.red(3, 0)).as("rounds up to the next power").isEqualTo(1);
    }

    @Test
    void bytesAreThoseOfTheSpecification() throws IOException {
        Image image = new Image(2, 1);
        image.set(0, 0, 1, 0.5, 0.25);
        image.set(1, 0, 3, 0, 0);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageFiles.write(image, out, ImageFormat.HDR);
        assertThat(out.toString(StandardCharsets.ISO_8859_1)).isEqualTo("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + "\200\100\40\201" + "\300\0\0\202");
    }

    @Test
    void exposuresOldRunsAndRowsFromBelowAreUnderstood() throws IOException {
        // Two rows of three: a pixel repeated twice by the old way of counting; the first row is the lowest.
        write("#?RGBE\nEXPOSURE=2\n# a comment\nEXPOSURE= 0.25\nFORMAT=32-bit_rle_rgbe\n\n+Y 2 +X 3\n" + "\200\100\0\201" + "\1\1\1\2" + "\200\0\0\200".repeat(3));
        Image read = ImageFiles.read(folder.resolve("a.hdr"));
        assertThat(read.red(2, 1)).as("1 divided by 2 · 0.25").isEqualTo(2);
        assertThat(read.green(0, 1)).isEqualTo(1);
        assertThat(read.red(1, 0)).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "FORMAT=32-bit_rle_xyze__-Y 1 +X 1_abcd      | should be in 32-bit_rle_rgbe, but is in \"32-bit_rle_xyze\"",
        "EXPOSURE=0__-Y 1 +X 1_abcd                  | the exposure should be a number above 0, but is \"0\"",
        "_-Y 1 -X 1_abcd                             | should end in a size as -Y 600 +X 800, but ends in \"-Y 1 -X 1\"",
        "_-Y 999999999 +X 999999999_abcd             | does not fit into a file of 42 bytes",
        "_-Y 1 +X 65537_abcd                         | from 1 to 65536 rows and columns, but this has 65537 × 1 pixels",
        "_-Y 1 +X 0_abcd                             | but this has 0 × 1 pixels",
        "_-Y 1 +X 5_abcd                             | the file is cut off after 26 bytes",
    })
    void whatIsNotSuchAPictureIsRefused(String content, String sentence) throws IOException {
        write("#?RADIANCE\n" + content.replace('_', '\n').replace("rle\n", "rle_").replace("bit\n", "bit_"));
        assertThatThrownBy(() -> ImageFiles.read(folder.resolve("a.hdr"))).isInstanceOf(IOException.class)
                .hasMessageStartingWith(folder.resolve("a.hdr") + ": ").hasMessageContaining(sentence).hasMessageNotContaining("\n");
    }

    private void write(String content) throws IOException {
        Files.write(folder.resolve("a.hdr"), content.getBytes(StandardCharsets.ISO_8859_1));
    }
}
