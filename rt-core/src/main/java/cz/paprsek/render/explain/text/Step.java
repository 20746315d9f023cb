package cz.paprsek.render.explain.text;

import cz.paprsek.words.Words;
import java.util.Objects;

/**
 * One line of a worked exercise, read as <i>formula = numbers = result</i>.
 *
 * @param topic what the line is about
 * @param name what is computed, in a word or two; empty for a line that goes on with what the one before began
 * @param formula in symbols; a few words in a line that states something and computes nothing
 * @param numbers the formula with numbers in place of symbols; empty if there is nothing to put in
 * @param result what comes out; empty in a line that only states something
 */
public record Step(Topic topic, String name, String formula, String numbers, String result) {
    public Step {
        Objects.requireNonNull(topic, "topic");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(formula, "formula");
        Objects.requireNonNull(numbers, "numbers");
        Objects.requireNonNull(result, "result");
    }

    /** What a line is about. */
    public enum Topic { RAY, POINT, AMBIENT, LIGHT, SHADOW, REFLECTION, REFRACTION, SUM }

    /** A line that states something and computes nothing. */
    static Step saying(Topic topic, String name, String words) {
        return new Step(topic, name, words, "", "");
    }

    /** With numbers as they are written in a language. */
    Step in(Words words) {
        return new Step(topic, name, words.figures(formula), words.figures(numbers), words.figures(result));
    }

    /** The formula, the numbers and the result, those that there are, with equals signs between. */
    public String equation() {
        return formula + (numbers.isEmpty() ? "" : " = " + numbers) + (result.isEmpty() ? "" : " = " + result);
    }
}
