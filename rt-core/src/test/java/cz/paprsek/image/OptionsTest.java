package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.material.Rgb.Tone;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Objects;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.w3c.dom.Element;

class OptionsTest {
    private static final Origin ORIGIN = new Origin("Koule ěščř 球", "sha256 0123", "Paprsek 7", "40x30, depth 5\nsecond line");

    private static Image grey(double light) {
        Image image = new Image(9, 2);
        for (int i = 0; i < 18; i++) {
            image.set(i % 9, i / 9, light, light, light);
        }
        return image;
    }

    @Test
    void aStopDoublesTheLight(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("a.pfm");
        ImageFiles.write(grey(0.2), file, ImageFormat.PFM, ImageOptions.DEFAULT.withExposure(1));
        assertThat(ImageFiles.read(file).green(8, 1)).isEqualTo(2 * (float) 0.2);
        ImageFiles.write(grey(0.2), file, ImageFormat.PFM, ImageOptions.DEFAULT.withExposure(-0.5));
        assertThat((double) ImageFiles.read(file).green(8, 1)).isCloseTo(0.2 / Math.sqrt(2), offset(1e-7));
        assertThatThrownBy(() -> ImageOptions.DEFAULT.withExposure(Double.NaN)).hasMessageContaining("exposure must be a number from -100 to 100");
    }

    /** Values of Hable's curve, worked out by hand from his formula: ((x(0.15x+0.05)+0.004)/(x(0.15x+0.5)+0.06) − 1/15), x = 2·light, over that at 11.2. */
    @Test
    void filmicIsTheCurveOfItsSource() {
        assertThat(Tone.FILMIC.of(0)).isCloseTo(0, offset(1e-15));
        assertThat(Tone.FILMIC.of(-3)).isCloseTo(0, offset(1e-15));
        assertThat(Tone.FILMIC.of(0.5)).isCloseTo((0.204 / 0.71 - 1 / 15.0) / (19.380 / 24.476 - 1 / 15.0), offset(1e-12));
        assertThat(Tone.FILMIC.of(1)).isCloseTo((0.704 / 1.66 - 1 / 15.0) / (19.380 / 24.476 - 1 / 15.0), offset(1e-12));
        assertThat(Tone.FILMIC.of(5.6)).isCloseTo(1, offset(1e-12));
        assertThat(Tone.FILMIC.of(1e30)).isEqualTo(1);
        for (double light = 0; light < 5.5; light += 0.01) {
            assertThat(Tone.FILMIC.of(light + 0.01)).isGreaterThan(Tone.FILMIC.of(light));
        }
    }

    @ParameterizedTest
    @EnumSource
    void whatIsToldOfAPictureChangesNoPixel(ImageFormat format, @TempDir Path folder) throws IOException {
        Path told = folder.resolve("told." + format.extension());
        Path untold = folder.resolve("untold." + format.extension());
        ImageFiles.write(grey(0.3), told, format, ImageOptions.DEFAULT.withOrigin(ORIGIN));
        ImageFiles.write(grey(0.3), untold, format);
        assertThat(ImageComparison.of(ImageFiles.readStored(told), ImageFiles.readStored(untold), 0).largest()).isZero();
        String bytes = Files.readString(told, StandardCharsets.ISO_8859_1);
        switch (format) {
            case BMP, PFM, TXT, RAW -> assertThat(told).hasSameBinaryContentAs(untold);
            default -> assertThat(bytes).contains("sha256 0123", "Paprsek 7", "40x30, depth 5");
        }
    }

    @Test
    void thePlatformFindsTheTextsOfAPng() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageFiles.write(grey(0.3), bytes, ImageFormat.PNG, ImageOptions.DEFAULT.withOrigin(ORIGIN));
        try (ImageInputStream stream = ImageIO.createImageInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
            ImageReader reader = readers.next();
            reader.setInput(stream);
            Element root = (Element) reader.getImageMetadata(0).getAsTree("javax_imageio_png_1.0");
            Element title = (Element) Objects.requireNonNull(root.getElementsByTagName("iTXtEntry").item(0));
            assertThat(title.getAttribute("keyword")).isEqualTo("Title");
            assertThat(title.getAttribute("text")).isEqualTo("Koule ěščř 球");
            assertThat(root.getElementsByTagName("tEXtEntry").getLength()).isEqualTo(3);
            reader.dispose();
        }
    }

    @Test
    void bitsThatAFormatCannotHaveAreRefused(@TempDir Path folder) {
        assertThatThrownBy(() -> ImageFiles.write(grey(1), folder.resolve("a.png"), ImageFormat.PNG, ImageOptions.DEFAULT.withBits(12)))
                .hasMessage("png has 8 or 16 bits per channel, not 12");
        assertThatThrownBy(() -> ImageFiles.write(grey(1), folder.resolve("a.jpg"), ImageFormat.JPG, ImageOptions.DEFAULT.withBits(16)))
                .hasMessage("jpg has 8 bits per channel, not 16");
    }
}
