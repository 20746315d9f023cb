package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.height.HeightField;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Heights are the numbers of a file, however those stand for light. */
class HeightPictureTest {
    private static final int[] EIGHT = {0, 1, 2, 64, 128, 255};
    private static final int[] SIXTEEN = {0, 1, 257, 12_345, 40_000, 65_535};

    private static void chunk(ByteArrayOutputStream out, String type, byte[] content) {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 sum = new CRC32();
        sum.update(name);
        sum.update(content);
        out.writeBytes(ByteBuffer.allocate(4).putInt(content.length).array());
        out.writeBytes(name);
        out.writeBytes(content);
        out.writeBytes(ByteBuffer.allocate(4).putInt((int) sum.getValue()).array());
    }

    /** Grey, three columns and two rows; a gamma of 0 is not told. */
    private static byte[] png(int bits, int gamma, int[] numbers) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
        chunk(out, "IHDR", ByteBuffer.allocate(13).putInt(3).putInt(2).put((byte) bits).put(new byte[4]).array());
        if (gamma != 0) {
            chunk(out, "gAMA", ByteBuffer.allocate(4).putInt(gamma).array());
        }
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream rows = new DeflaterOutputStream(packed)) {
            for (int i = 0; i < numbers.length; i++) {
                if (i % 3 == 0) {
                    rows.write(0);
                }
                rows.write(bits == 16 ? new byte[] {(byte) (numbers[i] >> 8), (byte) numbers[i]} : new byte[] {(byte) numbers[i]});
            }
        }
        chunk(out, "IDAT", packed.toByteArray());
        chunk(out, "IEND", new byte[0]);
        return out.toByteArray();
    }

    private static byte[] pgm(String comment, int last, int[] numbers) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(("P5\n" + comment + "3 2\n" + last + "\n").getBytes(StandardCharsets.US_ASCII));
        for (int number : numbers) {
            out.writeBytes(last > 255 ? new byte[] {(byte) (number >> 8), (byte) number} : new byte[] {(byte) number});
        }
        return out.toByteArray();
    }

    private static HeightField.Content read(byte[] picture) throws IOException {
        return MeshFiles.heights("a.picture", Assets.of(Map.of("a.picture", picture)));
    }

    private static HeightField.Content heights(int[] numbers, int last) {
        return HeightField.Content.of(3, 2, (column, row) -> numbers[3 * row + column], 1.0 / last);
    }

    /** None, sRGB's, of light itself, of old Macs, and others. */
    @ParameterizedTest
    @ValueSource(ints = {0, 45_455, 100_000, 55_556, 50_000, 20_000, 250_000})
    void numbersOfPngsStandAsTheyAre(int gamma) throws IOException {
        assertThat(read(png(8, gamma, EIGHT))).isEqualTo(heights(EIGHT, 255));
        assertThat(read(png(16, gamma, SIXTEEN))).isEqualTo(heights(SIXTEEN, 65_535));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "# linear light\n", "# Software: POV-Ray\n"})
    void numbersOfMapsStandAsTheyAre(String comment) throws IOException {
        assertThat(read(pgm(comment, 255, EIGHT))).isEqualTo(heights(EIGHT, 255));
        assertThat(read(pgm(comment, 65_535, SIXTEEN))).isEqualTo(heights(SIXTEEN, 65_535));
    }

    @Test
    void aGammaThatLosesNumbersIsRefused() {
        assertThatThrownBy(() -> read(png(8, 1000, EIGHT))).isInstanceOf(IOException.class)
                .hasMessage("\"a.picture\": for heights, a picture's gamma must be from 1/7 to 10, but is 0.01; save it without");
    }

    @Test
    void theLimitIsThatOfTheAssets() throws IOException {
        byte[] picture = pgm("", 255, EIGHT);
        Assets assets = Assets.of(Map.of("a.pgm", picture));
        assertThat(MeshFiles.heights("a.pgm", assets.withLimits(picture.length, 1000))).isEqualTo(heights(EIGHT, 255));
        assertThatThrownBy(() -> MeshFiles.heights("a.pgm", assets.withLimits(picture.length - 1, 1000)))
                .hasMessage("\"a.pgm\": is larger than the " + (picture.length - 1) + " bytes that a picture may have here");
    }

    /** Numbers without an end, times an extent. */
    @Test
    void whatIsTooHighIsToldWithItsPlace() throws Exception {
        ByteBuffer map = ByteBuffer.allocate(16);
        for (int i = 0; i < 4; i++) {
            map.putFloat(1e30f);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes("Pf\n2 2\n1.0\n".getBytes(StandardCharsets.US_ASCII));
        out.writeBytes(map.array());
        Assets assets = Assets.of(Map.of("a.pfm", out.toByteArray()));
        Scene scene = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 5 9' target='0 0 0'/><height-field file='a.pfm' extent='1 1e20 1'/></scene>");
        List<String> told = new ArrayList<>();
        MeshFiles.read(scene, assets, (place, problem) -> told.add(place.index() + ": " + problem.getMessage()));
        assertThat(told).hasSize(1);
        assertThat(told.get(0)).startsWith("0: \"a.pfm\": height-field height must be a number from 1.0E-45 to 1.0E45, but is 1.0000000150474662E50");
    }
}
