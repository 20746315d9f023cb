package cz.paprsek.cli;

import cz.paprsek.cli.process.Terminal;
import java.nio.charset.CharsetEncoder;
import java.util.List;
import java.util.Map;

/** Spells mathematics so that the terminal can show it. */
final class Letters {
    private static final Map<Character, String> SPELT = Map.ofEntries(
            Map.entry('│', "|"), Map.entry('├', "+"), Map.entry('└', "+"), Map.entry('─', "-"), Map.entry('›', ">"),
            Map.entry('·', "*"), Map.entry('−', "-"), Map.entry('°', " deg"), Map.entry('θ', "theta"), Map.entry('η', "eta"),
            Map.entry('₁', "1"), Map.entry('₂', "2"), Map.entry('ⁿ', "^n"), Map.entry('∞', "infinity"),
            Map.entry('½', "1/2"), Map.entry('√', "sqrt "), Map.entry('Σ', "sum"), Map.entry('Π', "product"), Map.entry('α', "alpha"), Map.entry('⌊', "floor("),
            Map.entry('⌋', ")"), Map.entry('…', "..."), Map.entry('ᵀ', "^T"), Map.entry('≥', ">="), Map.entry('≤', "<="), Map.entry('×', "x"));
    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";

    private Letters() {}

    /** The text in the letters that standard output can show. */
    static String fit(String text) {
        return fit(text, Terminal.charset().newEncoder());
    }

    static String fit(String text, CharsetEncoder encoder) {
        if (encoder.canEncode(text) && List.of('θ', '│', '⁰').stream().allMatch(encoder::canEncode)) {
            return text;
        }
        StringBuilder spelt = new StringBuilder();
        boolean raised = false;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            int digit = RAISED.indexOf(c);
            spelt.append(digit < 0 ? SPELT.getOrDefault(c, String.valueOf(c)) : (raised ? "" : "^") + "0123456789-".charAt(digit));
            raised = digit >= 0;
        }
        return spelt.toString();
    }
}
