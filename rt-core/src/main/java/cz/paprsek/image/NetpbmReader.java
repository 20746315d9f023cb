package cz.paprsek.image;

import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.material.Rgb;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Reads binary portable maps: PF and Pf as linear light, P5 and P6 as sRGB, as everybody writes them. P5 and P6 are linear light if a comment of
 * the head says so, as in what is written here; if the file is called so ({@code .ppm16}), as those were that said nothing; and, of 16 bits, if the
 * comment says that POV-Ray wrote them, which does not tell: it does so with a file gamma of 1 when it is to be compared with.
 *
 * @source Netpbm, ppm(5), pgm(5); Debevec, PFM
 */
final class NetpbmReader {
    private static final String POV_RAY = " Software: POV-Ray";

    private final ByteBuffer bytes;
    private boolean isLinear;
    private boolean isByPovRay;

    private NetpbmReader(byte[] file, boolean isLinear) {
        bytes = ByteBuffer.wrap(file);
        this.isLinear = isLinear;
    }

    static boolean canRead(byte[] file) {
        return file.length > 2 && file[0] == 'P' && "56Ff".indexOf(file[1]) >= 0 && file[2] <= ' ';
    }

    /** @param isLinear whether it is linear light for certain, whatever the head says */
    static StoredImage read(byte[] file, boolean isLinear) throws IOException {
        return new NetpbmReader(file, isLinear).read();
    }

    private StoredImage read() throws IOException {
        String magic = word();
        int width = whole("width", 1 << 16);
        int height = whole("height", 1 << 16);
        boolean isGrey = magic.equals("P5") || magic.equals("Pf");
        long values = (long) width * height * (isGrey ? 1 : 3);
        if (magic.startsWith("P5") || magic.startsWith("P6")) {
            int last = whole("largest value", 65_535);
            int size = last < 256 ? 1 : 2;
            checkLength(values * size);
            double[] light = light(last, isLinear || (isByPovRay && size == 2));
            Image image = fill(width, height, isGrey, false, () -> light[Math.min(last, size == 1 ? bytes.get() & 0xFF : bytes.getShort() & 0xFFFF)]);
            return new StoredImage(image, size == 1 ? Precision.EIGHT_BIT : Precision.SIXTEEN_BIT, isGrey);
        }
        double scale = number(word());
        bytes.order(scale < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        checkLength(values * 4);
        return new StoredImage(fill(width, height, isGrey, true, () -> bytes.getFloat()), Precision.FLOAT, isGrey);
    }

    private static double[] light(int last, boolean isLinear) {
        double[] light = new double[last + 1];
        for (int i = 0; i <= last; i++) {
            light[i] = isLinear ? i / (double) last : Rgb.linear(i * 255.0 / last);
        }
        return light;
    }

    private interface Value {
        double next();
    }

    private static Image fill(int width, int height, boolean isGrey, boolean fromBelow, Value value) {
        Image image = new Image(width, height);
        for (int row = 0; row < height; row++) {
            for (int x = 0; x < width; x++) {
                double red = value.next();
                double green = isGrey ? red : value.next();
                double blue = isGrey ? red : value.next();
                image.set(x, fromBelow ? height - 1 - row : row, red, green, blue);
            }
        }
        return image;
    }

    private void checkLength(long expected) throws IOException {
        if (bytes.remaining() < expected) {
            throw new IOException("the picture is cut off: it should have " + expected + " bytes after its head, but has " + bytes.remaining());
        }
    }

    private int whole(String what, int most) throws IOException {
        double value = number(word());
        if (value < 1 || value > most || value != Math.rint(value)) {
            throw new IOException("the picture's " + what + " must be a whole number from 1 to " + most);
        }
        return (int) value;
    }

    private static double number(String word) throws IOException {
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException e) {
            throw new IOException("the picture's head should have a number where it has \"" + word + "\"", e);
        }
    }

    /** The next word of the head, and the one blank after it; comments run from # to the end of the line. */
    private String word() throws IOException {
        StringBuilder word = new StringBuilder();
        while (bytes.hasRemaining() && word.length() < 32) {
            int c = bytes.get();
            if (c == '#' && word.length() == 0) {
                heed(restOfLine());
            } else if (c > ' ') {
                word.append(new String(new byte[] {(byte) c}, StandardCharsets.ISO_8859_1));
            } else if (word.length() > 0) {
                return word.toString();
            }
        }
        throw new IOException("the picture's head is cut off");
    }

    private String restOfLine() {
        int start = bytes.position();
        int end = start;
        while (bytes.hasRemaining() && bytes.get() != '\n') {
            end++;
        }
        return new String(bytes.array(), start, end - start, StandardCharsets.ISO_8859_1);
    }

    private void heed(String comment) {
        isLinear |= comment.strip().equals(Netpbm.LINEAR);
        isByPovRay |= comment.startsWith(POV_RAY);
    }
}
