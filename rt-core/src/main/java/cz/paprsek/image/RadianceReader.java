package cz.paprsek.image;

import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.io.BinaryInput;
import cz.paprsek.io.PlainText;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads Radiance pictures, plain and shortened in either way, rows from the top or the bottom. Light is divided by the exposures that the head
 * tells of. Mantissas are taken as they are, as most programs do, so that black and white stay what they are; Radiance itself and POV-Ray add
 * half a step to each.
 *
 * @source Radiance's color.c and the manual page of getinfo
 */
final class RadianceReader {
    private static final String MAGIC = "#?";
    private static final int LONGEST_LINE = 2_000;
    private static final int MOST_LINES = 1_000;
    private static final Pattern SIZE = Pattern.compile("([-+])Y (\\d{1,9}) \\+X (\\d{1,9})");

    private final BinaryInput input;

    private RadianceReader(BinaryInput input) {
        this.input = input;
    }

    static boolean canRead(byte[] start) {
        return start.length > 2 && start[0] == MAGIC.charAt(0) && start[1] == MAGIC.charAt(1);
    }

    static StoredImage read(BinaryInput input) throws IOException {
        return new RadianceReader(input).read();
    }

    private StoredImage read() throws IOException {
        double exposure = head();
        String line = input.textUpTo('\n', LONGEST_LINE);
        Matcher size = SIZE.matcher(line);
        if (!size.matches()) {
            throw new IOException("the head should end in a size as -Y 600 +X 800, but ends in \"" + PlainText.of(line, 40) + "\"");
        }
        int height = Integer.parseInt(size.group(2));
        int width = Integer.parseInt(size.group(3));
        // However alike its pixels are, no row takes less.
        input.require("a picture of " + width + " × " + height + " pixels", input.position() + 4L * height);
        Image image = ReadLimits.blank(width, height);
        byte[] row = new byte[4 * width];
        for (int i = 0; i < height; i++) {
            readRow(row, i);
            int y = size.group(1).equals("-") ? i : height - 1 - i;
            for (int x = 0; x < width; x++) {
                int exponent = row[4 * x + 3] & 0xFF;
                double unit = exponent == 0 ? 0 : Math.scalb(1 / exposure, exponent - 136);
                image.set(x, y, (row[4 * x] & 0xFF) * unit, (row[4 * x + 1] & 0xFF) * unit, (row[4 * x + 2] & 0xFF) * unit);
            }
        }
        return new StoredImage(image, Precision.SHARED_EXPONENT, false);
    }

    /** Reads up to the empty line; gives the product of all exposures. */
    private double head() throws IOException {
        double exposure = 1;
        for (int i = 0; i < MOST_LINES; i++) {
            String line = input.textUpTo('\n', LONGEST_LINE).strip();
            if (line.isEmpty()) {
                return exposure;
            }
            if (line.startsWith("FORMAT=") && !line.equals("FORMAT=32-bit_rle_rgbe")) {
                throw new IOException("the light should be in 32-bit_rle_rgbe, but is in \"" + PlainText.of(line.substring(7), 40) + "\"");
            }
            if (line.startsWith("EXPOSURE=")) {
                exposure *= number(line.substring(9).strip());
            }
        }
        throw new IOException("the head has more than " + MOST_LINES + " lines");
    }

    private static double number(String text) throws IOException {
        double value = Numbers.parsed(text).orElse(0);
        if (value > 1e-30 && value < 1e30) {
            return value;
        }
        throw new IOException("the exposure should be a number above 0, but is \"" + PlainText.of(text, 40) + "\"");
    }

    private void readRow(byte[] row, int number) throws IOException {
        int width = row.length / 4;
        byte[] start = input.bytes(4);
        if (start[0] != 2 || start[1] != 2 || start[2] < 0 || width < Radiance.SHORTEST || width > Radiance.LONGEST) {
            readOld(start, row, number);
            return;
        }
        if ((start[2] << 8 | (start[3] & 0xFF)) != width) {
            throw damaged(number);
        }
        for (int channel = 0; channel < 4; channel++) {
            for (int x = 0; x < width;) {
                int code = input.u8();
                int length = code > 128 ? code - 128 : code;
                if (length == 0 || length > width - x) {
                    throw damaged(number);
                }
                int value = code > 128 ? input.u8() : 0;
                for (int end = x + length; x < end; x++) {
                    row[4 * x + channel] = (byte) (code > 128 ? value : input.u8());
                }
            }
        }
    }

    /** Pixels one by one; one of three 1s says how often the one before it is repeated, several in a row in digits of 256. */
    private void readOld(byte[] start, byte[] row, int number) throws IOException {
        byte[] pixel = start;
        int shift = 0;
        int at = 0;
        while (true) {
            if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1 && at > 0) {
                long count = (long) (pixel[3] & 0xFF) << shift;
                if (count > (row.length - at) / 4 || shift > 16) {
                    throw damaged(number);
                }
                byte[] last = Arrays.copyOfRange(row, at - 4, at);
                for (int end = at + 4 * (int) count; at < end; at += 4) {
                    System.arraycopy(last, 0, row, at, 4);
                }
                shift += 8;
            } else {
                System.arraycopy(pixel, 0, row, at, 4);
                at += 4;
                shift = 0;
            }
            if (at == row.length) {
                return;
            }
            pixel = input.bytes(4);
        }
    }

    private IOException damaged(int row) {
        return new IOException("the picture is damaged: row " + row + ", before byte " + input.position() + ", is not of its width");
    }
}
