package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.Rgb;
import cz.paprsek.material.Rgb.Tone;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures of which parts are transparent, as others read them. */
class OpacityTest {
    @TempDir
    private Path folder = Path.of("");

    /** Nothing; light 0.4 on half a pixel; white on all of one. */
    private static Image picture() {
        Image image = Image.ofTransparent(3, 1);
        image.set(1, 0, 0.2, 0.1, 0, 0.5);
        image.set(2, 0, 1, 1, 1);
        return image;
    }

    private static int srgb(double light, int last) {
        return (int) Math.rint(Rgb.ofLinear(light, light, light).red() / 255 * last);
    }

    @Test
    void pngHasTheColourOfWhatCoversBesideHowMuchItCovers() throws IOException {
        Path file = folder.resolve("a.png");
        ImageFiles.write(picture(), file);
        BufferedImage read = ImageIO.read(file.toFile());
        assertThat(read.getRGB(0, 0)).isZero();
        assertThat(read.getRGB(1, 0)).isEqualTo(128 << 24 | srgb(0.4, 255) << 16 | srgb(0.2, 255) << 8);
        assertThat(read.getRGB(2, 0)).isEqualTo(-1);
    }

    @Test
    void soItDoesInSixteenBits() throws IOException {
        Path file = folder.resolve("a.png");
        ImageFiles.write(picture(), file, ImageOptions.DEFAULT.withBits(16));
        int[] pixel = ImageIO.read(file.toFile()).getRaster().getPixel(1, 0, new int[4]);
        assertThat(pixel).containsExactly(srgb(0.4, 65_535), srgb(0.2, 65_535), 0, 32_768);
    }

    @Test
    void exrHasTheLightOfTheCoveredPart() throws IOException {
        Path file = folder.resolve("a.exr");
        ImageFiles.write(picture(), file, ImageOptions.DEFAULT.withBits(32));
        Layers read = ImageFiles.readLayers(file);
        assertThat(read.names()).containsExactly("A", "B", "G", "R");
        assertThat(read.at("R", 1, 0)).isEqualTo(0.2f);
        assertThat(read.at("A", 1, 0)).isEqualTo(0.5f);
        assertThat(read.at("A", 0, 0)).isZero();
    }

    @Test
    void exposureAndToneAreThoseOfWhatCovers() throws IOException {
        Path file = folder.resolve("a.exr");
        ImageOptions how = ImageOptions.shown(1, Tone.FILMIC).withBits(32);
        ImageFiles.write(picture(), file, how);
        Layers read = ImageFiles.readLayers(file);
        assertThat((double) read.at("R", 1, 0)).isCloseTo(0.5 * Tone.FILMIC.of(2 * 0.4), within(1e-6));
        assertThat(read.at("A", 1, 0)).isEqualTo(0.5f);
        assertThat(how.shown(picture()).applyAsInt(1, 0) >>> 24).isEqualTo(128);
        assertThat(how.shown(picture()).applyAsInt(1, 0) >> 16 & 255).isEqualTo(srgb(Tone.FILMIC.of(0.8), 255));
    }

    @Test
    void otherFormatsSayThatTheyHaveNone() {
        Path file = folder.resolve("a.jpg");
        assertThatThrownBy(() -> ImageFiles.write(picture(), file)).hasMessage("jpg has no opacity, which this picture has; png and exr have");
        assertThat(file).doesNotExist();
        assertThatThrownBy(() -> new Image(1, 1).set(0, 0, 1, 1, 1, 0.5)).hasMessage("this picture has no opacity");
    }

    @Test
    void layersStandBesideThePictureWithTheirOwnDigits() throws IOException {
        Path file = folder.resolve("a.exr");
        Layers further = Layers.ofSize(3, 1).with("depth.Z", new float[] {1.0000001f, 70_000, 3}).with("albedo.R", new float[] {0.1f, 0, 1});
        ImageFiles.write(picture(), further, file, ImageOptions.DEFAULT);
        Layers read = ImageFiles.readLayers(file);
        assertThat(read.names()).containsExactlyInAnyOrder("R", "G", "B", "A", "depth.Z", "albedo.R");
        assertThat(read.at("depth.Z", 0, 0)).isEqualTo(1.0000001f);
        assertThat(read.at("depth.Z", 1, 0)).as("more than a half can be").isEqualTo(70_000);
        assertThat(read.at("albedo.R", 0, 0)).as("light is in halves").isNotEqualTo(0.1f).isCloseTo(0.1f, within(1e-4f));
        assertThatThrownBy(() -> ImageFiles.write(new Image(2, 1), further, file, ImageOptions.DEFAULT)).hasMessageContaining("do not fit");
        assertThatThrownBy(() -> ImageFiles.write(picture(), Layers.ofSize(3, 1).with("R", new float[3]), file, ImageOptions.DEFAULT)).hasMessageContaining("more than a letter");
    }

    @Test
    void uncompressedIsTheSamePictureInAFileAsLargeAsItIs() throws IOException {
        Image grey = new Image(100, 100);
        Path packed = folder.resolve("a.exr");
        Path plain = folder.resolve("b.exr");
        ImageFiles.write(grey, packed);
        ImageFiles.write(grey, plain, ImageOptions.DEFAULT.withoutCompression());
        assertThat(plain.toFile().length()).isGreaterThan(60_000).isGreaterThan(10 * packed.toFile().length());
        assertThat(ImageComparison.of(ImageFiles.readStored(packed), ImageFiles.readStored(plain), 0).largest()).isZero();
    }
}
