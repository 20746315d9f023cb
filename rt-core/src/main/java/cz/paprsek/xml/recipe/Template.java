package cz.paprsek.xml.recipe;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.FormulaException;
import cz.paprsek.formula.Term;
import cz.paprsek.text.Numbers;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** A value with formulas in braces: {@code 0 {h/2} 0}. */
final class Template {
    /** Of a value that is written out, in characters: parameters within parameters make endless ones of a few lines. */
    private static final int LONGEST = 100_000;

    private final List<Piece> pieces;

    /**
     * A text, or a formula.
     *
     * @param at where in the value the text begins, or the formula behind its brace
     */
    private record Piece(String text, Optional<Formula> formula, int at) {}

    private Template(List<Piece> pieces) {
        this.pieces = pieces;
    }

    /** A value cannot be had. */
    static final class Misplaced extends RuntimeException {
        private static final long serialVersionUID = 1;
        private final int at;

        /** @param at where in the value, in characters from 0 */
        Misplaced(int at, String message) {
            super(message, null, false, false);
            this.at = at;
        }

        int at() {
            return at;
        }
    }

    static boolean isIn(String value) {
        return value.indexOf('{') >= 0;
    }

    /** @throws Misplaced if it has no end, or a formula is none */
    static Template of(String value) {
        List<Piece> pieces = new ArrayList<>();
        int at = 0;
        while (at < value.length()) {
            int open = value.indexOf('{', at);
            if (open < 0 || open > at) {
                pieces.add(new Piece(value.substring(at, open < 0 ? value.length() : open), Optional.empty(), at));
            }
            if (open < 0) {
                break;
            }
            int close = value.indexOf('}', open);
            if (close < 0) {
                throw new Misplaced(open, "the formula that begins here has no \"}\" at its end");
            }
            try {
                pieces.add(new Piece("", Optional.of(Formula.of(value.substring(open + 1, close))), open + 1));
            } catch (FormulaException wrong) {
                throw new Misplaced(open + wrong.column(), String.valueOf(wrong.getMessage()));
            }
            at = close + 1;
        }
        return new Template(pieces);
    }

    /** @throws Misplaced if a formula has no value */
    String value(Names names) {
        StringBuilder value = new StringBuilder();
        for (Piece piece : pieces) {
            String next = piece.formula().isEmpty() ? piece.text() : value(piece.formula().get(), piece.at(), names);
            if (piece.formula().isPresent() && value.length() + next.length() > LONGEST) {
                throw new Misplaced(piece.at(), "with what its formulas come to, this is longer than the " + LONGEST + " characters that it may have");
            }
            value.append(next);
        }
        return value.toString();
    }

    /** What its formulas need. */
    Set<String> names() {
        return pieces.stream().flatMap(piece -> piece.formula().stream()).flatMap(formula -> formula.names().stream()).collect(Collectors.toSet());
    }

    private static String value(Formula formula, int at, Names names) {
        try {
            Optional<String> word = formula.term() instanceof Term.Name name ? names.word(name.name()) : Optional.empty();
            if (word.isPresent()) {
                return word.get();
            }
            // −0 would be another number than 0, and look like a mistake.
            return Numbers.text(formula.value(names) + 0.0);
        } catch (FormulaException without) {
            throw new Misplaced(at + without.column() - 1, String.valueOf(without.getMessage()));
        } catch (IllegalArgumentException without) {
            throw new Misplaced(at, String.valueOf(without.getMessage()));
        }
    }
}
