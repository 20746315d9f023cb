package cz.paprsek.words;

import cz.paprsek.math.Require;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Sentences that tell what is wrong, in another language. They are made in English, where the mistake is found; a table has their patterns,
 * a line in English with {0}, {1} … for what differs, and a line in the other language. What stands for these is looked up in turn, but for {=0}.
 * A sentence is in the other language as a whole or not at all: a pattern counts only if there are words for all that stands in it, but for names and numbers.
 */
final class Sentences {
    private static final Pattern HOLE = Pattern.compile("\\{(=?)(\\d)}");
    /** So deep do sentences hold others. */
    private static final int DEEPEST = 4;

    /** What a thing and its attribute are called: {@code torus major-radius}. */
    private static final Pattern THING = Pattern.compile("[a-z][a-z-]*( [a-z][a-z-]*){0,2}");

    /** What is the same in every language: what is quoted, elements, and files with their folders. */
    private static final Pattern NAMED = Pattern.compile("\"[^\"]*\"|</?[^<>]*>|^(?=[^,;\"]*$)(\\S*[/\\\\]\\S.*|.*\\.\\p{Alpha}\\p{Alnum}{0,7})$");
    /** What English sentences are made of. */
    private static final Pattern GRAMMAR = Pattern.compile("(?U)\\b(the|is|must|but|has|of|not|there|are|be|which|than|or|and|it|with|for|this|its|from|needs|that|here|line|byte)\\b");
    private static final Pattern PLAIN_WORD = Pattern.compile("(?<!\\S)[(]?\\p{Ll}{2,}[,;:.)]*(?!\\S)");

    private final List<Form> forms = new ArrayList<>();
    private final Function<String, Optional<String>> word;

    private record Form(Pattern english, String other, int letters) {}

    /**
     * @param table its name beside this class
     * @param word what an element or attribute is called in the other language, by its name in files
     */
    Sentences(String table, Function<String, Optional<String>> word) {
        this.word = word;
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(
                Objects.requireNonNull(Sentences.class.getResourceAsStream(table), table), StandardCharsets.UTF_8))) {
            for (String english = lines.readLine(); english != null; english = lines.readLine()) {
                if (!english.isBlank() && !english.startsWith("#")) {
                    String other = lines.readLine();
                    Require.that(other != null && !other.isBlank(), table + " has no other words for \"" + english + "\"");
                    forms.add(form(english, Objects.requireNonNull(other)));
                }
            }
        } catch (IOException e) {
            throw new IllegalStateException(table + " cannot be read", e);
        }
        // What says more is tried first.
        forms.sort(Comparator.comparingInt(Form::letters).reversed());
    }

    private static Form form(String english, String other) {
        StringBuilder pattern = new StringBuilder();
        Matcher hole = HOLE.matcher(english);
        int from = 0;
        int letters = english.length();
        while (hole.find()) {
            pattern.append(Pattern.quote(english.substring(from, hole.start()))).append("(?<n").append(hole.group(2)).append(">.+?)");
            from = hole.end();
            letters -= 3;
        }
        return new Form(Pattern.compile(pattern + Pattern.quote(english.substring(from)), Pattern.DOTALL), other, letters);
    }

    /** The sentence in the other language; as it is if no pattern is like it. */
    String of(String english) {
        return of(english, 0).orElse(english);
    }

    /** What is named in English or as in files, in the other language; as it is if there is no word for it. */
    String name(String english) {
        return of(english, 1).orElse(english);
    }

    private Optional<String> of(String english, int depth) {
        for (Form form : forms) {
            Matcher matcher = form.english.matcher(english);
            if (depth < DEEPEST && matcher.matches()) {
                Optional<String> other = filled(form, matcher, depth);
                if (other.isPresent()) {
                    return other;
                }
            }
        }
        return depth > 0 && THING.matcher(english).matches() ? thing(english) : Optional.empty();
    }

    /** Empty if some of what stands in it would be left in English. */
    private Optional<String> filled(Form form, Matcher matcher, int depth) {
        StringBuilder other = new StringBuilder();
        Matcher hole = HOLE.matcher(form.other);
        while (hole.find()) {
            String found = matcher.group("n" + hole.group(2));
            boolean isKept = !hole.group(1).isEmpty();
            Optional<String> part = isKept ? Optional.empty() : of(found, depth + 1);
            if (part.isEmpty() && (isKept ? GRAMMAR : PLAIN_WORD).matcher(NAMED.matcher(found).replaceAll("")).find()) {
                return Optional.empty();
            }
            hole.appendReplacement(other, Matcher.quoteReplacement(part.orElse(found)));
        }
        return Optional.of(hole.appendTail(other).toString());
    }

    private Optional<String> thing(String english) {
        List<Optional<String>> words = Arrays.stream(english.split(" ")).map(word).toList();
        return words.stream().allMatch(Optional::isPresent) ? Optional.of(words.stream().flatMap(Optional::stream).collect(Collectors.joining(", "))) : Optional.empty();
    }
}
