package cz.paprsek.image.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.film.FilmWriter.Format;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.NodeList;

/** Films, read by others than the program: the platform's readers of GIF and PNG, and arithmetic. */
class FilmWriterTest {
    /** Of noise in some colours, the same for the same number. */
    private static Image picture(int width, int height, int number, int colors) {
        Random random = new Random(number);
        Image image = new Image(width, height);
        for (int i = 0; i < width * height; i++) {
            int k = random.nextInt(colors);
            image.set(i % width, i / width, (k % 7) / 6.0, (k / 7 % 7) / 6.0, (k / 49 % 9) / 8.0);
        }
        return image;
    }

    /** From black to white and from blue to red. */
    private static Image slope(int width, int height) {
        Image image = new Image(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double share = (double) x / (width - 1);
                image.set(x, y, share * y / height, share * share, share * (1 - (double) y / height));
            }
        }
        return image;
    }

    private static byte[] film(Format format, double fps, Image... images) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        FilmWriter film = new FilmWriter(format, images[0].width(), images[0].height(), fps, images.length, ImageOptions.DEFAULT, out);
        for (Image image : images) {
            film.add(image);
        }
        film.end();
        return out.toByteArray();
    }

    private static ImageReader reader(String format, byte[] bytes) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName(format);
        ImageReader reader = readers.next();
        reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(bytes)));
        return reader;
    }

    private static void isSame(BufferedImage read, Image image, int tolerance) {
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                int a = read.getRGB(x, y);
                int b = image.argb(x, y);
                for (int shift = 0; shift < 24; shift += 8) {
                    assertThat(Math.abs((a >> shift & 0xFF) - (b >> shift & 0xFF))).as("%d, %d: %x for %x", x, y, a, b).isLessThanOrEqualTo(tolerance);
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 1", "7, 5, 2", "31, 40, 3", "200, 150, 256", "90, 70, 17", "255, 3, 16"})
    void aGifOfFewColoursHasThemExactly(int width, int height, int colors) throws IOException {
        Image[] images = IntStream.range(0, 3).mapToObj(i -> picture(width, height, i, colors)).toArray(Image[]::new);
        ImageReader reader = reader("gif", film(Format.GIF, 25, images));
        assertThat(reader.getNumImages(true)).isEqualTo(3);
        for (int i = 0; i < 3; i++) {
            isSame(reader.read(i), images[i], 0);
        }
    }

    @Test
    void aGifOfManyColoursIsNearThem() throws IOException {
        Image image = slope(300, 200);
        byte[] bytes = film(Format.GIF, 10, image, picture(300, 200, 5, 441), image);
        ImageReader reader = reader("gif", bytes);
        BufferedImage read = reader.read(0);
        isSame(read, image, 40);
        isSame(reader.read(2), image, 40);
        long sum = 0;
        for (int i = 0; i < 300 * 200; i++) {
            sum += (read.getRGB(i % 300, i / 300) & 0xFF) - (image.argb(i % 300, i / 300) & 0xFF);
            i += 7;
        }
        assertThat(Math.abs(sum / 7500.0)).as("on average").isLessThan(3);
        assertThat(film(Format.GIF, 10, image, picture(300, 200, 5, 441), image)).isEqualTo(bytes);
    }

    @ParameterizedTest
    @CsvSource({"25, 4 4 4 4 4 4", "50, 2 2 2 2 2 2", "30, 3 4 3 3 4 3", "24, 4 4 5 4 4 4", "12, 8 9 8 8 9 8"})
    void delaysOfAGifAddUpToTheTime(double fps, String delays) throws IOException {
        ImageReader reader = reader("gif", film(Format.GIF, fps, IntStream.range(0, 6).mapToObj(i -> picture(2, 2, i, 2)).toArray(Image[]::new)));
        List<String> found = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            NodeList control = ((IIOMetadataNode) reader.getImageMetadata(i).getAsTree("javax_imageio_gif_image_1.0")).getElementsByTagName("GraphicControlExtension");
            found.add(((IIOMetadataNode) control.item(0)).getAttribute("delayTime"));
        }
        assertThat(String.join(" ", found)).isEqualTo(delays);
    }

    @Test
    void aGifThatIsTooFastIsRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> film(Format.GIF, 60, new Image(1, 1))).withMessage("gif shows 50 pictures a second at most, not 60; apng and y4m show more");
    }

    /** A part of a PNG file. */
    private static final class Chunk {
        private final String type;
        private final byte[] content;

        Chunk(String type, byte[] content) {
            this.type = type;
            this.content = content;
        }

        String type() {
            return type;
        }
    }

    private static List<Chunk> chunks(byte[] file) {
        ByteBuffer in = ByteBuffer.wrap(file);
        assertThat(in.getLong()).isEqualTo(0x89504E470D0A1A0AL);
        List<Chunk> chunks = new ArrayList<>();
        while (in.hasRemaining()) {
            byte[] content = new byte[in.getInt()];
            byte[] type = new byte[4];
            in.get(type).get(content);
            CRC32 crc = new CRC32();
            crc.update(type);
            crc.update(content);
            assertThat(in.getInt()).isEqualTo((int) crc.getValue());
            chunks.add(new Chunk(new String(type, StandardCharsets.US_ASCII), content));
        }
        return chunks;
    }

    private static void put(ByteArrayOutputStream out, String type, byte[] content) {
        CRC32 crc = new CRC32();
        crc.update(type.getBytes(StandardCharsets.US_ASCII));
        crc.update(content);
        out.writeBytes(ByteBuffer.allocate(12 + content.length).putInt(content.length).put(type.getBytes(StandardCharsets.US_ASCII)).put(content).putInt((int) crc.getValue()).array());
    }

    /** Each picture of an animated PNG as a PNG by itself, as the specification says. */
    private static List<byte[]> apart(List<Chunk> chunks) {
        List<byte[]> pictures = new ArrayList<>();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        int sequence = 0;
        for (Chunk chunk : chunks) {
            ByteBuffer content = ByteBuffer.wrap(chunk.content);
            if (chunk.type.equals("fcTL") || chunk.type.equals("fdAT")) {
                assertThat(content.getInt()).isEqualTo(sequence++);
            }
            if (chunk.type.equals("fcTL") || chunk.type.equals("IEND")) {
                if (out.size() > 0) {
                    put(out, "IEND", new byte[0]);
                    pictures.add(out.toByteArray());
                }
                out = new ByteArrayOutputStream();
                out.writeBytes(ByteBuffer.allocate(8).putLong(0x89504E470D0A1A0AL).array());
                put(out, "IHDR", chunks.get(0).content);
            } else if (chunk.type.equals("fdAT") || chunk.type.equals("IDAT")) {
                byte[] data = new byte[content.remaining()];
                content.get(data);
                put(out, "IDAT", data);
            }
        }
        return pictures;
    }

    @Test
    void anApngHasAllPicturesInOrder() throws IOException {
        Image[] images = {picture(40, 30, 1, 400), picture(40, 30, 2, 400), slope(40, 30)};
        byte[] file = film(Format.APNG, 29.97, images);
        isSame(ImageIO.read(new ByteArrayInputStream(file)), images[0], 0);
        List<Chunk> chunks = chunks(file);
        assertThat(chunks.stream().map(Chunk::type).distinct()).containsExactly("IHDR", "sRGB", "acTL", "fcTL", "IDAT", "fdAT", "IEND");
        assertThat(ByteBuffer.wrap(chunks.get(2).content).getInt()).isEqualTo(3);
        for (Chunk control : chunks.stream().filter(chunk -> chunk.type.equals("fcTL")).toList()) {
            ByteBuffer in = ByteBuffer.wrap(control.content);
            in.getInt();
            assertThat(List.of(in.getInt(), in.getInt(), in.getInt(), in.getInt(), (int) in.getShort(), (int) in.getShort(), (int) in.getShort())).containsExactly(40, 30, 0, 0, 100, 2997, 0);
        }
        List<byte[]> pictures = apart(chunks);
        assertThat(pictures).hasSize(3);
        for (int i = 0; i < 3; i++) {
            isSame(ImageIO.read(new ByteArrayInputStream(pictures.get(i))), images[i], 0);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"25 25:1", "29.97 2997:100", "12.5 25:2", "23.976023976023978 24000:1001", "0.5 1:2", "1000 1000:1"})
    void aY4mSaysHowManyPicturesASecondThereAre(String rate) throws IOException {
        String[] words = rate.split(" ", -1);
        assertThat(new String(film(Format.Y4M, Double.parseDouble(words[0]), new Image(3, 2)), StandardCharsets.ISO_8859_1))
                .startsWith("YUV4MPEG2 W3 H2 F" + words[1] + " Ip A1:1 C444\nFRAME\n").hasSize("YUV4MPEG2 W3 H2 F".length() + words[1].length() + " Ip A1:1 C444\nFRAME\n".length() + 3 * 6);
    }

    @Test
    void theColoursOfAY4mAreThoseOfTheStandard() throws IOException {
        Map<Integer, List<Integer>> known = Map.of(0x000000, List.of(16, 128, 128), 0xFFFFFF, List.of(235, 128, 128), 0xFF0000, List.of(81, 90, 240),
                0x00FF00, List.of(145, 54, 34), 0x0000FF, List.of(41, 240, 110), 0xFFFF00, List.of(210, 16, 146));
        known.forEach((rgb, yuv) -> {
            Image image = new Image(1, 1);
            image.set(0, 0, (rgb >> 16 & 0xFF) / 255.0, (rgb >> 8 & 0xFF) / 255.0, (rgb & 0xFF) / 255.0);
            try {
                byte[] file = film(Format.Y4M, 25, image);
                assertThat(List.of(file[file.length - 3] & 0xFF, file[file.length - 2] & 0xFF, file[file.length - 1] & 0xFF)).isEqualTo(yuv);
            } catch (IOException e) {
                throw new AssertionError(e);
            }
        });
    }

    @Test
    void picturesOfOtherSizesAndTooManyAreRefused() throws IOException {
        FilmWriter film = new FilmWriter(Format.GIF, 4, 4, 25, 1, ImageOptions.DEFAULT, new ByteArrayOutputStream());
        assertThatIllegalArgumentException().isThrownBy(() -> film.add(new Image(4, 5))).withMessage("all pictures of a film must be of 4x4 pixels, but here is one of 4x5");
        assertThatIllegalArgumentException().isThrownBy(() -> film.add(Image.ofTransparent(4, 4))).withMessageStartingWith("the pictures of a film have no opacity");
        film.add(new Image(4, 4));
        assertThatIllegalArgumentException().isThrownBy(() -> film.add(new Image(4, 4))).withMessage("a film of 1 pictures cannot have more");
    }
}
