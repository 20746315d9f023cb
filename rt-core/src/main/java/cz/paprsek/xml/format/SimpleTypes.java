package cz.paprsek.xml.format;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.attribute.Range;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The simple types of the schema: what {@link Kind} says of values. Those of the schema's own are few: of what lists and unions are made. */
final class SimpleTypes {
    private static final int LONGEST_WORD = 200;

    private final SchemaText text;
    private final Stream<Class<?>> enumerations;

    SimpleTypes(SchemaText text, Stream<Class<?>> enumerations) {
        this.text = text;
        this.enumerations = enumerations;
    }

    /** The name of an attribute's. */
    static String name(Described one) {
        return one.says().value() == Kind.WORD ? name(one.type()) : one.says().value().type();
    }

    /** {@code projection} for the enumeration {@code Projection}. */
    private static String name(Class<?> enumeration) {
        String name = enumeration.getSimpleName();
        return name.substring(0, 1).toLowerCase(Locale.ROOT) + name.substring(1);
    }

    void write() {
        Set<String> done = new HashSet<>();
        for (Kind kind : Kind.values()) {
            if (kind != Kind.WORD && done.add(kind.type())) {
                write(kind);
            }
        }
        enumerations.forEach(this::words);
    }

    private void write(Kind kind) {
        switch (kind.form()) {
            case NUMBER -> type(kind, () -> number(kind));
            case WHOLE -> type(kind, () -> bounded("xs:int", kind.range()));
            case FROM_TO -> fromTo(kind);
            case VECTOR -> type(kind, () -> list(kind == Kind.POSITIVE_VECTOR ? Kind.POSITIVE.type() : Kind.NUMBER.type(), 3));
            case PAIR -> type(kind, () -> list(kind == Kind.POSITIVE_PAIR ? Kind.POSITIVE.type() : Kind.NUMBER.type(), 2));
            case SCALE -> scale(kind);
            case COLOR -> color(kind);
            // Control characters are refused when the scene is made of the file: a pattern would make reading twice as long.
            case TEXT -> type(kind, () -> lengths("xs:string", (int) kind.least(), (int) kind.most()));
            case WORDS -> {
                type("word", "a word of at most " + LONGEST_WORD + " characters", () -> lengths("xs:token", 1, LONGEST_WORD));
                type(kind, () -> text.leaf("list", "itemType", "s:word"));
            }
            case FLAG -> type(kind, () -> enumeration(List.of("true", "false")));
            case WORD -> throw new IllegalStateException("every enumeration has a type of its own");
        }
    }

    private void words(Class<?> enumeration) {
        List<String> words = List.copyOf(Described.words(enumeration).keySet());
        String most = String.join(", ", words.subList(0, words.size() - 1));
        type(name(enumeration), most.isEmpty() ? words.get(0) : most + " or " + words.get(words.size() - 1), () -> enumeration(words));
    }

    /** The bounds keep out INF and NaN. A pattern would as well, but makes reading twice as long, and a number of a million digits take minutes. */
    private void number(Kind kind) {
        if (kind == Kind.NUMBER) {
            text.open("restriction", "base", "xs:double").leaf("minInclusive", "value", text(-Double.MAX_VALUE))
                    .leaf("maxInclusive", "value", text(Double.MAX_VALUE)).close("restriction");
        } else {
            bounded("s:" + Kind.NUMBER.type(), kind.range());
        }
    }

    private void bounded(String base, Range range) {
        text.open("restriction", "base", base);
        if (Double.isFinite(range.least())) {
            text.leaf(range.takesLeast() ? "minInclusive" : "minExclusive", "value", text(range.least()));
        }
        if (Double.isFinite(range.most())) {
            text.leaf(range.takesMost() ? "maxInclusive" : "maxExclusive", "value", text(range.most()));
        }
        text.close("restriction");
    }

    private void fromTo(Kind kind) {
        String most = text(kind.range().most());
        // A power of ten.
        String number = "0*([1-9][0-9]{0," + (most.length() - 2) + "}|" + most + ")";
        type("perSide", "a whole number from 1 to " + most, () -> bounded("xs:int", kind.range()));
        type("fromTo", "two whole numbers from 1 to " + most + " such as 2..8", () -> patterns(Stream.of(number + "\\.\\." + number)));
        type(kind, () -> text.leaf("union", "memberTypes", "s:perSide s:fromTo"));
    }

    private void scale(Kind kind) {
        if (kind == Kind.POSITIVE_SCALE) {
            type(kind, () -> text.leaf("union", "memberTypes", "s:" + Kind.POSITIVE.type() + " s:" + Kind.POSITIVE_VECTOR.type()));
            return;
        }
        type("negative", "a finite number below 0", () -> bounded("s:" + Kind.NUMBER.type(), new Range(Double.NEGATIVE_INFINITY, false, 0, false)));
        type("factor", "a finite number other than 0", () -> text.leaf("union", "memberTypes", "s:positive s:negative"));
        type("factors", "three finite numbers, none of them 0", () -> list("factor", 3));
        type(kind, () -> text.leaf("union", "memberTypes", "s:factor s:factors"));
    }

    private void color(Kind kind) {
        Range range = kind.range();
        String bounds = text(range.least()) + " to " + text(range.most());
        type("channel", "a number from " + bounds, () -> bounded("s:" + Kind.NUMBER.type(), range));
        type("channels", "three numbers from " + bounds + ", red green blue", () -> list("channel", 3));
        type("hexadecimal", "a colour such as #ff8000 or #f80", () -> patterns(Stream.of("#[0-9a-fA-F]{3}", "#[0-9a-fA-F]{6}")));
        type("colorName", "the name of a colour on the web", () -> enumeration(ColorWords.names()));
        type("colorNameInAnyCase", "the name of a colour on the web, in letters of any case",
                () -> patterns(ColorWords.names().stream().map(SimpleTypes::inAnyCase)));
        type(kind, () -> text.leaf("union", "memberTypes", "s:channels s:colorName s:colorNameInAnyCase s:hexadecimal"));
    }

    private static String inAnyCase(String name) {
        return name.chars().mapToObj(c -> "[" + (char) Character.toUpperCase(c) + (char) c + "]").collect(Collectors.joining());
    }

    private void patterns(Stream<String> patterns) {
        text.open("restriction", "base", "xs:token");
        patterns.forEach(pattern -> text.leaf("pattern", "value", pattern));
        text.close("restriction");
    }

    private void enumeration(Iterable<String> words) {
        text.open("restriction", "base", "xs:token");
        words.forEach(word -> text.leaf("enumeration", "value", word));
        text.close("restriction");
    }

    private void list(String item, int length) {
        text.open("restriction").open("simpleType").leaf("list", "itemType", "s:" + item).close("simpleType");
        text.leaf("length", "value", String.valueOf(length)).close("restriction");
    }

    private void lengths(String base, int least, int most) {
        text.open("restriction", "base", base).leaf("minLength", "value", String.valueOf(least));
        text.leaf("maxLength", "value", String.valueOf(most)).close("restriction");
    }


    private void type(Kind kind, Runnable content) {
        type(kind.type(), kind.words(), content);
    }

    private void type(String name, String words, Runnable content) {
        text.open("simpleType", "name", name).documentation(words);
        content.run();
        text.close("simpleType");
    }

    private static String text(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9 ? String.valueOf((long) value) : String.valueOf(value);
    }
}
