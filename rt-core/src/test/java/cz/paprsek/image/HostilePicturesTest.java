package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures that mean harm, read by a process of 64 megabytes: each is refused in one line. */
@Timeout(value = 2, unit = TimeUnit.MINUTES)
class HostilePicturesTest {
    @TempDir
    private Path folder;

    /** Reads the pictures whose names it is given, and says what came of each. */
    public static void main(String[] files) {
        for (String file : files) {
            try {
                System.out.println(file + ": read, " + ImageFiles.read(Path.of(file)).width() + " columns");
            } catch (IOException e) {
                System.out.println(e.getMessage());
            }
        }
    }

    private static String answer(Path file) throws Exception {
        String output = new String(OtherProcess.output("-Xmx64m", HostilePicturesTest.class.getName(), file.toString()), StandardCharsets.UTF_8).strip();
        assertThat(output).startsWith(file + ": ").doesNotContain("\n", "Exception");
        return output.substring(file.toString().length() + 2);
    }

    @Test
    void headsOfABillionPixelsAreRefused() throws Exception {
        assertThat(answer(write("a.png", png(32_000, 32_000, 8, 2, zeros(1000))))).contains("32000 × 32000 pixels does not fit into a file of");
        assertThat(answer(write("b.png", png(1 << 30, 1 << 30, 1, 0, zeros(1000))))).contains("does not fit into a file");
        assertThat(answer(write("a.ppm", text("P6 32000 32000 255\n")))).contains("does not fit into a file of 19 bytes");
        assertThat(answer(write("a.hdr", text("#?RADIANCE\n\n-Y 999999999 +X 1\n")))).contains("does not fit into a file of");
        byte[] exr = Files.readAllBytes(Path.of("src/test/resources/exr/zip-half.exr"));
        assertThat(answer(write("a.exr", withWindow(exr, 31_999, 31_999)))).contains("32000 × 32000 pixels does not fit into a file of");
        assertThat(answer(write("b.exr", withWindow(exr, Integer.MAX_VALUE, 0)))).contains("cannot have 2147483648 × 1 pixels");
        byte[] jpeg = written(ImageFormat.JPG);
        int frame = 0;
        while ((jpeg[frame] & 0xFF) != 0xFF || (jpeg[frame + 1] & 0xFF) != 0xC0) {
            frame++;
        }
        jpeg[frame + 5] = jpeg[frame + 6] = jpeg[frame + 7] = jpeg[frame + 8] = 0x7F;
        assertThat(answer(write("a.jpg", jpeg))).contains("32639 × 32639 pixels does not fit into a file of");
    }

    /** A hundred and sixty kilobytes hold a hundred and sixty million bytes of nothing. */
    @Test
    void bombsAreRefusedForWantOfMemory() throws Exception {
        assertThat(answer(write("a.png", png(7000, 7000, 8, 2, zeros(7000 * 21_001)))))
                .isEqualTo("not enough memory for this picture; give Java more with -Xmx");
        assertThat(answer(write("grey.png", png(30_000, 30_000, 1, 0, zeros(30_000 * 3_751))))).contains("larger than the 268435456 pixels that are read");
    }

    /** What is left of a stream after the picture is not unpacked. */
    @Test
    void aBombBehindThePictureDoesNotGoOff() throws Exception {
        assertThat(answer(write("a.png", png(10, 10, 8, 2, zeros(200_000_000))))).isEqualTo("read, 10 columns");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '!', value = {
        "head -c 8 %s; yes                          ! should be a part with a name of four letters",
        "head -c 33 %s; while true; do printf '\\0\\0\\0\\0teXt\\0\\0\\0\\0'; done ! larger than the 3000000 bytes that are read",
        "printf 'P6\\n#'; yes x | tr -d '\\n'        ! a line or name of more than 100000 characters",
        "printf 'P6 '; yes 1 | tr -d '\\n'           ! should have a number",
        "printf '#?RADIANCE\\n'; yes x              ! the head has more than 1000 lines",
        "printf '\\166\\057\\061\\001\\002\\0\\0\\0'; yes ! a line or name of more than 255 characters",
        "printf '\\377\\330'; yes                    ! larger than the 3000000 bytes that are read",
        "yes                                        ! this is not a picture of a kind that can be read",
        "cat /dev/zero                              ! this is not a picture of a kind that can be read",
    })
    void pipesWithoutAnEndAreRefused(String command, String sentence) throws Exception {
        Path good = write("good.png", written(ImageFormat.PNG));
        Path pipe = folder.resolve("pipe");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
        Process writer = new ProcessBuilder("sh", "-c", "(" + String.format(Locale.ROOT, command, good) + ") > " + pipe)
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
        try {
            String output = new String(OtherProcess.output("-Xmx64m", "-Dpaprsek.largest-file=3000000", HostilePicturesTest.class.getName(), pipe.toString()),
                    StandardCharsets.UTF_8).strip();
            assertThat(output).startsWith(pipe + ": ").contains(sentence).doesNotContain("\n");
        } finally {
            writer.descendants().forEach(ProcessHandle::destroyForcibly);
            writer.destroyForcibly();
        }
    }

    @Test
    void aJpegOfAThousandScansIsRefused() throws Exception {
        byte[] jpeg = written(ImageFormat.JPG);
        ByteArrayOutputStream scans = new ByteArrayOutputStream();
        scans.write(jpeg, 0, 2);
        for (int i = 0; i < 1000; i++) {
            scans.write(new byte[] {(byte) 0xFF, (byte) 0xDA, 0, 8, 1, 1, 0, 0, 63, 0});
        }
        assertThat(answer(write("a.jpg", scans.toByteArray()))).contains("in more than 200 scans");
    }

    private static byte[] written(ImageFormat format) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageFiles.write(new Image(8, 8), bytes, format);
        return bytes.toByteArray();
    }

    private Path write(String name, byte[] content) throws IOException {
        return Files.write(folder.resolve(name), content);
    }

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static byte[] withWindow(byte[] exr, int right, int bottom) {
        byte[] bad = exr.clone();
        int at = new String(bad, StandardCharsets.ISO_8859_1).indexOf("dataWindow\0box2i\0") + 17 + 4 + 8;
        for (int i = 0; i < 4; i++) {
            bad[at + i] = (byte) (right >> (8 * i));
            bad[at + 4 + i] = (byte) (bottom >> (8 * i));
        }
        return bad;
    }

    private static byte[] zeros(int count) {
        Deflater deflater = new Deflater(9);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        byte[] nothing = new byte[1 << 16];
        byte[] out = new byte[1 << 16];
        for (int left = count; left > 0 || !deflater.finished();) {
            if (left > 0 && deflater.needsInput()) {
                deflater.setInput(nothing, 0, Math.min(left, nothing.length));
                left -= Math.min(left, nothing.length);
            }
            if (left == 0) {
                deflater.finish();
            }
            packed.write(out, 0, deflater.deflate(out));
        }
        deflater.end();
        return packed.toByteArray();
    }

    private static byte[] png(int width, int height, int bits, int color, byte[] packed) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
        ByteArrayOutputStream head = new ByteArrayOutputStream();
        DataOutputStream data = new DataOutputStream(head);
        data.writeInt(width);
        data.writeInt(height);
        data.write(new byte[] {(byte) bits, (byte) color, 0, 0, 0});
        chunk(bytes, "IHDR", head.toByteArray());
        chunk(bytes, "IDAT", packed);
        chunk(bytes, "IEND", new byte[0]);
        return bytes.toByteArray();
    }

    private static void chunk(ByteArrayOutputStream bytes, String type, byte[] content) throws IOException {
        DataOutputStream data = new DataOutputStream(bytes);
        data.writeInt(content.length);
        data.writeBytes(type);
        data.write(content);
        CRC32 crc = new CRC32();
        crc.update(text(type));
        crc.update(content);
        data.writeInt((int) crc.getValue());
    }
}
