package cz.paprsek.xml.recipe;

import cz.paprsek.text.Numbers;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Adds to places as they are written. */
final class Aside {
    private static final Pattern FORMULA = Pattern.compile("([+-]?)\\{([^{}]*)}");

    /** What binds less than a sum does. */
    private static final Pattern LOOSE = Pattern.compile("(?U)[?<>=!&|≤≥≠]|\\b(and|or|not)\\b");

    private Aside() {}

    /** Three numbers or formulas with another first one, so much larger; empty if they are not three, or the first is neither. */
    static Optional<String> of(String written, double aside) {
        String[] place = written.strip().split("\\s+(?![^{]*})", -1);
        if (place.length != 3) {
            return Optional.empty();
        }
        String more = " + " + Numbers.text(aside) + "}";
        Matcher formula = FORMULA.matcher(place[0]);
        Optional<String> x = formula.matches() ? Optional.of("{" + whole(formula.group(1), formula.group(2)) + more)
                : Numbers.parsed(place[0]).stream().mapToObj(number -> Numbers.text(number + aside)).findFirst();
        return x.map(first -> first + " " + place[1] + " " + place[2]);
    }

    private static String whole(String sign, String formula) {
        String safe = sign.equals("-") || LOOSE.matcher(formula).find() ? "(" + formula + ")" : formula;
        return sign.equals("-") ? "-" + safe : safe;
    }
}
