package cz.paprsek.cli.value;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.io.Failures;
import cz.paprsek.text.Numbers;
import cz.paprsek.text.Similar;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
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
        return Numbers.parsed(word).orElseThrow(() -> new TypeConversionException("expected a number, but found '" + word + "'"
                + (word.matches("[-+]?\\d+,\\d+") ? "; a point stands before decimals: " + word.replace(',', '.') : "")));
    }

    /**
     * The constant of an enumeration whose name the word is, in any case.
     *
     * @throws TypeConversionException if there is none
     */
    public static <E extends Enum<E>> E constant(Class<E> type, String word) {
        List<E> constants = List.copyOf(EnumSet.allOf(type));
        return constants.stream().filter(one -> one.name().equalsIgnoreCase(word)).findFirst()
                .orElseThrow(() -> unknown(word, constants.stream().map(Enum::name).toList()));
    }

    /** What is said of a word that is none of those there are: which was meant, if it is like one or begins only one. */
    static TypeConversionException unknown(String word, List<String> names) {
        List<String> begun = names.stream().filter(name -> name.startsWith(word)).toList();
        return new TypeConversionException("expected one of " + Similar.listed(names) + ", but found '" + word + "'"
                + Similar.suggestion(begun.size() == 1 ? begun.get(0) : word, names));
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
            throw new WrongUsage("'" + word + "' is not a valid file name: " + Failures.noName(e));
        }
    }
}
