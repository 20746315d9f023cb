package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Pictures of all formats, each damaged in four hundred ways (or as many as the system property {@code paprsek.damages} says): every one is read,
 * or refused in one line, and nothing else happens.
 */
class DamagedPicturesTest {
    private static final int WAYS = Integer.getInteger("paprsek.damages", 400);
    private static final Path RECORDED = Path.of("src/test/resources/exr");
    @TempDir
    private Path folder;

    static Stream<Arguments> pictures() throws IOException {
        Stream.Builder<Arguments> pictures = Stream.builder();
        for (ImageFormat format : ImageFormat.values()) {
            pictures.add(Arguments.of(format.extension(), "whole", written(format, ImageOptions.DEFAULT)));
        }
        pictures.add(Arguments.of("png", "16 bits", written(ImageFormat.PNG, ImageOptions.DEFAULT.withBits(16))));
        pictures.add(Arguments.of("exr", "32 bits", written(ImageFormat.EXR, ImageOptions.DEFAULT.withBits(32))));
        pictures.add(Arguments.of("jpg", "in several scans", progressive()));
        for (String name : new String[] {"rle-half", "zips-float", "layers"}) {
            pictures.add(Arguments.of("exr", name, Files.readAllBytes(RECORDED.resolve(name + ".exr"))));
        }
        return pictures.build();
    }

    /** As many cameras' and the web's are. */
    private static byte[] progressive() throws IOException {
        BufferedImage image = new BufferedImage(40, 30, BufferedImage.TYPE_INT_RGB);
        Random random = new Random(1);
        for (int i = 0; i < 40 * 30; i++) {
            image.setRGB(i % 40, i / 40, random.nextInt(1 << 24));
        }
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            ImageWriteParam settings = writer.getDefaultWriteParam();
            settings.setProgressiveMode(ImageWriteParam.MODE_DEFAULT);
            writer.setOutput(stream);
            writer.write(null, new IIOImage(image, null, null), settings);
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }

    private static byte[] written(ImageFormat format, ImageOptions options) throws IOException {
        Image image = new Image(40, 30);
        Random random = new Random(1);
        for (int i = 0; i < 40 * 30; i++) {
            image.set(i % 40, i / 40, i % 7 < 4 ? 0.5 : random.nextDouble(), i / 1200.0, 2 * random.nextDouble());
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageFiles.write(image, bytes, format, options);
        return bytes.toByteArray();
    }

    @ParameterizedTest(name = "{0}, {1}")
    @MethodSource("pictures")
    @Timeout(value = 10, unit = TimeUnit.MINUTES)
    void aDamagedPictureIsReadOrRefused(String ending, String what, byte[] good) {
        AtomicInteger refused = new AtomicInteger();
        AtomicLong slowest = new AtomicLong();
        IntStream.range(0, WAYS).parallel().forEach(seed -> {
            Path file = folder.resolve(seed + "." + ending);
            long begin = System.nanoTime();
            try {
                Files.write(file, damaged(good, new Random(seed), ending.equals("png") && seed % 2 == 0));
                assertThat(ImageFiles.readStored(file).image().width()).isPositive();
                // As a scene has it.
                assertThat(Assets.in(folder).picture(String.valueOf(file.getFileName())).image().width()).isPositive();
            } catch (IOException e) {
                refused.incrementAndGet();
                assertThat(e.getMessage()).as("seed %d", seed).startsWith(file + ": ").matches("[^\\p{Cc}\\p{Cf}]+").doesNotContain("null", "Exception");
            } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
                throw new AssertionError("seed " + seed + ": " + e, e);
            }
            slowest.accumulateAndGet(System.nanoTime() - begin, Math::max);
        });
        System.out.printf("%s, %s: %d damaged copies, %d refused, the slowest took %d ms%n", ending, what, WAYS, refused.get(), slowest.get() / 1_000_000);
        assertThat(refused.get()).as("the damage is felt").isPositive().isLessThan(WAYS);
    }

    private static byte[] damaged(byte[] good, Random random, boolean isPngMended) {
        byte[] bad = good.clone();
        // Heads decide most: half of the damage is done there.
        int end = random.nextBoolean() ? Math.min(good.length, 64) : good.length;
        for (int i = random.nextInt(4); i >= 0; i--) {
            int at = random.nextInt(end);
            switch (random.nextInt(6)) {
                case 0 -> bad[at] ^= (byte) (1 << random.nextInt(8));
                case 1 -> bad[at] = (byte) (random.nextBoolean() ? 0xFF : 0x7F);
                case 2 -> Arrays.fill(bad, at, Math.min(bad.length, at + 1 + random.nextInt(8)), (byte) 0);
                case 3 -> bad = i == 0 ? Arrays.copyOf(bad, at + 1) : bad;
                case 4 -> {
                    int from = random.nextInt(good.length);
                    System.arraycopy(good, from, bad, at, Math.max(0, Math.min(20, Math.min(good.length - from, bad.length - at))));
                }
                default -> bad[at] = (byte) random.nextInt();
            }
            end = Math.min(end, bad.length);
        }
        if (isPngMended) {
            mend(bad);
        }
        return bad;
    }

    /** With right checksums the damage gets farther. */
    private static void mend(byte[] png) {
        int at = 8;
        while (at + 12 <= png.length) {
            int length = ((png[at] & 0xFF) << 24) | ((png[at + 1] & 0xFF) << 16) | ((png[at + 2] & 0xFF) << 8) | (png[at + 3] & 0xFF);
            if (length < 0 || length > png.length - at - 12) {
                return;
            }
            CRC32 crc = new CRC32();
            crc.update(png, at + 4, length + 4);
            for (int i = 0; i < 4; i++) {
                png[at + 8 + length + i] = (byte) (crc.getValue() >> (24 - 8 * i));
            }
            at += 12 + length;
        }
    }
}
