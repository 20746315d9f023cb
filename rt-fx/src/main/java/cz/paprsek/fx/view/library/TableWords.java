package cz.paprsek.fx.view.library;

import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.query.Column;
import cz.paprsek.query.Value;
import cz.paprsek.text.Numbers;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What tables, their columns and what stands in them are called in the language of the window. Filters, and what is exported, have the words of files. */
final class TableWords {
    /** The part of a path that has no name: its kind and number. */
    private static final Pattern NUMBERED = Pattern.compile("([a-z-]+)#(\\d+)");
    /** Of a number that is computed no more are shown. */
    private static final MathContext DIGITS = new MathContext(6);

    private final Texts texts;

    TableWords(Texts texts) {
        this.texts = texts;
    }

    /** What a table is called, by its name. */
    String table(String name) {
        return capital(text("library.word." + name).or(() -> text("kind." + name)).or(() -> text("element." + name)).orElse(name));
    }

    /** What a column is called, by its name. */
    String column(String name) {
        return capital(text("library.word." + name).orElseGet(() -> texts.attribute(name)));
    }

    /** What stands in a cell, in one line. */
    String cell(Column<?> column, Value value) {
        if (value instanceof Value.Range range) {
            Value.Range shown = range.shown();
            return texts.of("library.range", number(shown.least()), number(shown.most()), word(shown.pattern()));
        }
        if (value instanceof Value.Scalar one) {
            return number(one.value());
        }
        if (value instanceof Value.Triple three) {
            return number(three.numbers().x()) + " " + number(three.numbers().y()) + " " + number(three.numbers().z());
        }
        String written = value.text().strip().replace('\n', ' ');
        return switch (column.name()) {
            case "path" -> Arrays.stream(written.split("/", -1)).map(this::step).collect(Collectors.joining("/"));
            case "kind", "pattern", "projection", "integrator", "filter", "sampler", "tone", "fresnel", "sky" -> word(written);
            case "hidden", "smooth", "thin", "visible" -> text("library.word." + written).orElse(written);
            default -> written;
        };
    }

    private String step(String written) {
        Matcher numbered = NUMBERED.matcher(written);
        return numbered.matches() ? word(numbered.group(1)) + " " + numbered.group(2) : written;
    }

    private String word(String written) {
        return Stream.of("kind.", "alternative.", "element.").flatMap(beginning -> text(beginning + written).stream()).findFirst().orElse(written);
    }

    private String number(double value) {
        return texts.number(Numbers.text(Double.isFinite(value) ? new BigDecimal(value).round(DIGITS).doubleValue() : value));
    }

    private Optional<String> text(String key) {
        return texts.has(key) ? Optional.of(texts.of(key)) : Optional.empty();
    }

    private static String capital(String text) {
        return text.substring(0, 1).toUpperCase(Locale.ROOT) + text.substring(1);
    }
}
