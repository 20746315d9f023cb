package cz.paprsek.xml.mistake;

import cz.paprsek.text.Numbers;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Numbers and colours as other languages and programs write them: what the value would be here. */
final class OtherNotations {
    private static final String NUMBER = "[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?";
    private static final Pattern WITH_COMMA = Pattern.compile("[-+]?\\d+(,\\d+)?");
    private static final Pattern THOUSANDS = Pattern.compile("\\d{1,3}([,.' _]\\d{3})+");
    private static final Pattern HEX = Pattern.compile("(?i)(?:#|0x|\\$)?([0-9a-f]{6})([0-9a-f]{2})?");
    private static final Pattern PERCENT = Pattern.compile("(" + NUMBER + ")\\s*%");
    private static final Pattern UNIT = Pattern.compile("(" + NUMBER + ")\\s*(mm|cm|dm|m|km|in|ft|px|pt|deg|rad|°|f)", Pattern.UNICODE_CASE);

    /** Nobody writes more than this by mistake, in characters. */
    private static final int LONGEST = 100;

    private OtherNotations() {}

    /**
     * What to write instead, as the end of a sentence; empty if that cannot be told.
     *
     * @param expected what the schema says of the type
     */
    static Optional<String> advice(String type, String expected, String value) {
        String plain = value.strip();
        return plain.length() > LONGEST ? Optional.empty() : Stream.of(hex(type, plain), thousands(expected, plain), decimalCommas(expected, plain), separators(type, expected, plain),
                percent(expected, plain), units(expected, plain)).flatMap(Optional::stream).findFirst();
    }

    static boolean isNumber(String word) {
        return word.matches(NUMBER);
    }

    private static Optional<String> hex(String type, String value) {
        Matcher hex = HEX.matcher(value);
        return type.equals("color") && hex.matches() ? Optional.of("write \"#" + hex.group(1) + "\""
                + (hex.group(2) == null ? "" : ", a colour has no transparency of its own")) : Optional.empty();
    }

    private static Optional<String> thousands(String expected, String value) {
        return expected.startsWith("a whole number") && THOUSANDS.matcher(value).matches()
                ? Optional.of("write \"" + value.replaceAll("\\D", "") + "\"") : Optional.empty();
    }

    private static Optional<String> decimalCommas(String expected, String value) {
        String[] words = value.split("\\s+");
        return value.contains(",") && fits(expected, words.length) && !expected.startsWith("a whole number")
                && Arrays.stream(words).allMatch(word -> WITH_COMMA.matcher(word).matches() || isNumber(word))
                ? Optional.of("a point stands before decimals: \"" + value.replace(',', '.') + "\"") : Optional.empty();
    }

    private static Optional<String> separators(String type, String expected, String value) {
        String bare = value.replaceFirst("^[A-Za-z]*\\s*[<(\\[{]?\\s*(?=[-+.\\d])", "").replaceFirst("\\s*[>)\\]}]$", "");
        List<String> words = List.of(bare.split("\\s*[,;]\\s*|\\s+"));
        boolean isOurs = bare.equals(value) && !value.matches(".*[,;].*");
        if (isOurs || !fits(expected, words.size()) || !words.stream().allMatch(OtherNotations::isNumber)) {
            return Optional.empty();
        }
        boolean isOfOne = type.equals("color") && value.matches("(?i)rgb\\s.*|.*<.*") && words.stream().allMatch(word -> Double.parseDouble(word) <= 1);
        String numbers = String.join(" ", isOfOne ? words.stream().map(word -> Numbers.text(Math.rint(255_000 * Double.parseDouble(word)) / 1000)).toList() : words);
        return Optional.of((isOfOne ? "colours go up to 255: " : words.size() == 1 ? "write " : "only blanks stand between numbers: ") + '"' + numbers + '"');
    }

    private static Optional<String> percent(String expected, String value) {
        Matcher percent = PERCENT.matcher(value);
        return expected.endsWith("from 0 to 1") && percent.matches()
                ? Optional.of("write \"" + Numbers.text(Math.rint(1e4 * Double.parseDouble(percent.group(1))) / 1e6) + "\"") : Optional.empty();
    }

    private static Optional<String> units(String expected, String value) {
        String bare = UNIT.matcher(value).replaceAll("$1");
        return !bare.equals(value) && Arrays.stream(bare.split("\\s+")).allMatch(OtherNotations::isNumber)
                ? Optional.of("numbers have no units here" + (fits(expected, bare.split("\\s+").length) ? ": \"" + bare + "\"" : "")) : Optional.empty();
    }

    private static boolean fits(String expected, int count) {
        return expected.startsWith("three ") ? count == 3 : expected.startsWith("two ") ? count == 2 : count == 1 || (expected.startsWith("one ") && count == 3);
    }
}
