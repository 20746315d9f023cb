package cz.paprsek.image;

import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.io.PlainText;
import cz.paprsek.material.Rgb;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.OptionalDouble;

/** Reads brightness as text: one image row a line, values separated by blanks. */
final class BrightnessReader {
    private static final int LONGEST_SHOWN = 40;

    private BrightnessReader() {}

    /** Whole numbers 0–255, sRGB-encoded. */
    static StoredImage encoded(byte[] file) throws IOException {
        return new StoredImage(read(file, true), Precision.EIGHT_BIT, true);
    }

    /** Luminance in linear light. */
    static StoredImage linear(byte[] file) throws IOException {
        return new StoredImage(read(file, false), Precision.FLOAT, true);
    }

    private static Image read(byte[] file, boolean isEncoded) throws IOException {
        List<String> rows = new String(file, StandardCharsets.US_ASCII).lines().filter(line -> !line.isBlank()).toList();
        if (rows.isEmpty()) {
            throw new IOException("the picture is empty");
        }
        Image image = new Image(words(rows.get(0)).length, rows.size());
        for (int y = 0; y < rows.size(); y++) {
            String[] words = words(rows.get(y));
            if (words.length != image.width()) {
                throw new IOException("row " + (y + 1) + " has " + words.length + " values, but row 1 has " + image.width());
            }
            for (int x = 0; x < words.length; x++) {
                double value = number(words[x], y, isEncoded);
                double light = isEncoded ? Rgb.linear(value) : value;
                image.set(x, y, light, light, light);
            }
        }
        return image;
    }

    private static String[] words(String row) {
        return row.strip().split("\\s+");
    }

    private static double number(String word, int y, boolean isEncoded) throws IOException {
        OptionalDouble value = Numbers.parsed(word);
        if (value.isPresent() && (!isEncoded || (value.getAsDouble() >= 0 && value.getAsDouble() <= 255))) {
            return value.getAsDouble();
        }
        throw new IOException("row " + (y + 1) + " should have " + (isEncoded ? "numbers 0-255" : "numbers") + ", but has \"" + PlainText.of(word, LONGEST_SHOWN) + "\"");
    }
}
