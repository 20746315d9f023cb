package cz.paprsek.lesson;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.FormulaException;
import cz.paprsek.lesson.Lesson.Part;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;

/**
 * A question that is answered with a number, or with several.
 *
 * @param asked what
 * @param answer the right numbers, or where they are found
 * @param tolerance how far each number may be from the right one
 * @param hint how to begin
 * @param why how the answer comes about, told when it has been given
 * @param slips answers that are often given in its place
 */
public record Question(Said asked, Answer answer, double tolerance, Said hint, Said why, List<Slip> slips) implements Part {
    public Question {
        Objects.requireNonNull(asked, "asked");
        Objects.requireNonNull(answer, "answer");
        Objects.requireNonNull(hint, "hint");
        Objects.requireNonNull(why, "why");
        slips = List.copyOf(slips);
    }

    /** Where the right numbers come from. */
    public sealed interface Answer permits Given, Found {}

    /** They are said. */
    public record Given(List<Double> numbers) implements Answer {
        public Given {
            numbers = List.copyOf(numbers);
        }
    }

    /**
     * They are those of the explanation of a pixel of the lesson's scene.
     *
     * @param column of the pixel, from 0 at the left
     * @param row from 0 at the top
     * @param ray the name of the ray it is about, such as {@code E} or {@code ER}
     * @param light which light it is about, from 1
     */
    public record Found(Figure figure, int column, int row, String ray, int light) implements Answer {
        public Found {
            Objects.requireNonNull(figure, "figure");
            Objects.requireNonNull(ray, "ray");
        }
    }

    /** A wrong answer that many give. */
    public record Slip(List<Double> numbers, Said told) {
        public Slip {
            numbers = List.copyOf(numbers);
            Objects.requireNonNull(told, "told");
        }
    }

    /** How many numbers make an answer. */
    public int numbers() {
        return answer instanceof Given given ? given.numbers().size() : ((Found) answer).figure().numbers();
    }

    /**
     * What there is to say of an answer.
     *
     * @param right the right numbers
     */
    public Mark mark(String typed, List<Double> right) {
        List<Double> numbers;
        try {
            numbers = numbers(typed, right.size());
        } catch (FormulaException unreadable) {
            return new Mark(Verdict.UNREADABLE, Optional.empty(), String.valueOf(unreadable.getMessage()));
        }
        if (numbers.size() != right.size()) {
            return new Mark(Verdict.UNREADABLE, Optional.empty(), "");
        }
        if (isNear(numbers, right)) {
            return new Mark(Verdict.RIGHT, Optional.of(why), "");
        }
        return new Mark(Verdict.WRONG, slips.stream().filter(slip -> isNear(numbers, slip.numbers())).map(Slip::told).findFirst(), "");
    }

    /** Whether each number is as near as it must be to the one in its place. */
    boolean isNear(List<Double> numbers, List<Double> others) {
        if (numbers.size() != others.size()) {
            return false;
        }
        for (int i = 0; i < numbers.size(); i++) {
            if (!(Math.abs(numbers.get(i) - others.get(i)) <= tolerance)) {
                return false;
            }
        }
        return true;
    }

    /** One is a formula, which may have blanks; of several there is one between blanks or semicolons each. Degrees and such may have their sign. */
    private static List<Double> numbers(String typed, int wanted) {
        String plain = typed.strip().toLowerCase(Locale.ROOT).replaceAll("^\\((.*)\\)$", wanted > 1 ? "$1" : "($1)");
        String[] pieces = wanted == 1 ? new String[] {plain} : plain.split(plain.contains(";") ? "\\s*;\\s*" : "\\s*,\\s+|\\s+");
        List<Double> numbers = new ArrayList<>();
        for (String piece : pieces) {
            numbers.add(Formula.value(piece.replaceAll("[°\\s]+$", "")));
        }
        return numbers;
    }

    /** What an answer is. */
    public enum Verdict { RIGHT, WRONG, UNREADABLE }

    /**
     * What there is to say of an answer.
     *
     * @param told why it is right, or what was probably done wrong
     * @param fault why it cannot be read, in English; empty if there are more or fewer numbers than asked for
     */
    public record Mark(Verdict verdict, Optional<Said> told, String fault) {
        public Mark {
            Objects.requireNonNull(verdict, "verdict");
            Objects.requireNonNull(told, "told");
            Objects.requireNonNull(fault, "fault");
        }
    }
}
