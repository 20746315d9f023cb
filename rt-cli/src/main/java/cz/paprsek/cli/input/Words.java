package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import picocli.CommandLine.TypeConversionException;

/** Single words of a command line made into values, and what is said of those that are none. */
public final class Words {
    private Words() {}

    /** @throws TypeConversionException if the word is no whole number, or too large */
    public static int wholeNumber(String word) {
        try {
            return Math.toIntExact(Long.parseLong(word));
        } catch (ArithmeticException large) {
            throw new TypeConversionException(word + " is too large");
        } catch (NumberFormatException notWhole) {
            throw new TypeConversionException("expected a whole number, but found '" + word + "'");
        }
    }

    /** @throws TypeConversionException if the word is no number */
    public static double number(String word) {
        try {
            double value = Double.parseDouble(word);
            if (!Double.isNaN(value)) {
                return value;
            }
        } catch (NumberFormatException notANumber) {
            // Answered below.
        }
        throw new TypeConversionException("expected a number, but found '" + word + "'"
                + (word.matches("[-+]?\\d+,\\d+") ? "; a point stands before decimals: " + word.replace(',', '.') : ""));
    }

    /** @throws TypeConversionException if no file can have that name */
    public static Path file(String word) {
        try {
            return path(word);
        } catch (WrongUsage refused) {
            throw new TypeConversionException(refused.getMessage());
        }
    }

    /** @throws WrongUsage if no file can have that name */
    public static Path path(String word) {
        if (word.isEmpty()) {
            throw new WrongUsage("an empty name stands where a file's should");
        }
        if (word.matches("(?i)(https?|ftp|file)://.*")) {
            throw new WrongUsage("'" + word + "' is an address, and nothing is fetched; give the path of a file");
        }
        try {
            return Path.of(word);
        } catch (InvalidPathException e) {
            throw new WrongUsage("'" + word + "' is not a valid file name: " + (isUnspeakable(e) ? unspeakable() : e.getReason()));
        }
    }

    private static boolean isUnspeakable(InvalidPathException e) {
        return e.getReason().contains("unmappable") || e.getReason().contains("Malformed");
    }

    /** What to do about letters that the system's settings have no code for. */
    private static String unspeakable() {
        return "the locale (" + System.getProperty("sun.jnu.encoding", "unknown") + ") has no code for its letters; LC_ALL=C.UTF-8 has";
    }
}
