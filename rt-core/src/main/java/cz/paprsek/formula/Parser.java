package cz.paprsek.formula;

import cz.paprsek.text.Similar;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads a formula by one method for each rank of operations, of those that bind less first. */
final class Parser {
    static final String PI = "pi";
    /** How deep it may be nested: far deeper than anybody writes, and safe for whoever walks through it. */
    private static final int DEEPEST = 50;
    private static final int QUOTED = 40;

    /** Ranks of operations between two terms, those that bind least first; longer words first where one begins another. */
    private static final List<List<Map.Entry<String, Function>>> RANKS = List.of(
            List.of(Map.entry("||", Function.OR), Map.entry("or", Function.OR)),
            List.of(Map.entry("&&", Function.AND), Map.entry("and", Function.AND)),
            List.of(Map.entry("==", Function.EQUAL), Map.entry("!=", Function.UNEQUAL), Map.entry("≠", Function.UNEQUAL)),
            List.of(Map.entry("<=", Function.AT_MOST), Map.entry("≤", Function.AT_MOST), Map.entry("<", Function.LESS),
                    Map.entry(">=", Function.AT_LEAST), Map.entry("≥", Function.AT_LEAST), Map.entry(">", Function.GREATER)),
            List.of(Map.entry("+", Function.PLUS), Map.entry("-", Function.MINUS), Map.entry("−", Function.MINUS)),
            List.of(Map.entry("*", Function.TIMES), Map.entry("×", Function.TIMES), Map.entry("·", Function.TIMES),
                    Map.entry("/", Function.DIVIDE), Map.entry("÷", Function.DIVIDE), Map.entry("%", Function.REMAINDER)));

    private final String text;
    private int at;
    private int depth;
    /** How many function calls are around: within one, a comma stands between its terms. */
    private int calls;

    Parser(String text) {
        this.text = text;
    }

    Term whole() {
        if (text.length() > Formula.LONGEST) {
            throw new FormulaException(Formula.LONGEST, "a formula must have at most " + Formula.LONGEST + " characters, but has " + text.length());
        }
        skipBlanks();
        Term term = choice();
        if (at < text.length()) {
            throw unexpected("the end or an operation");
        }
        return term;
    }

    private Term choice() {
        deeper();
        Term condition = between(0);
        int column = at + 1;
        if (accept("?")) {
            Term then = choice();
            if (!accept(":")) {
                throw unexpected("\":\" and what is to be had otherwise");
            }
            condition = new Term.Call(Function.IF, List.of(condition, then, choice()), column);
        }
        depth--;
        return condition;
    }

    private Term between(int rank) {
        if (rank == RANKS.size()) {
            return signed();
        }
        Term term = between(rank + 1);
        while (true) {
            int column = at + 1;
            Optional<Function> operation = RANKS.get(rank).stream().filter(one -> accept(one.getKey())).findFirst().map(Map.Entry::getValue);
            if (operation.isEmpty()) {
                return term;
            }
            term = new Term.Call(operation.get(), List.of(term, between(rank + 1)), column);
        }
    }

    private Term signed() {
        deeper();
        int column = at + 1;
        Term term = accept("-") || accept("−") ? new Term.Call(Function.NEGATE, List.of(signed()), column)
                : accept("+") ? signed()
                : accept("not") || (!text.startsWith("!=", at) && accept("!")) ? new Term.Call(Function.NOT, List.of(signed()), column) : power();
        depth--;
        return term;
    }

    private Term power() {
        Term base = operand();
        int column = at + 1;
        return accept("^") ? new Term.Call(Function.POWER, List.of(base, signed()), column) : base;
    }

    private Term operand() {
        int start = at;
        if (accept("(")) {
            int outside = calls;
            calls = 0;
            Term inside = choice();
            calls = outside;
            close();
            return inside;
        }
        while (at < text.length() && (isLetter(at) || (at > start && isDigit(at)))) {
            at++;
        }
        return start < at ? named(text.substring(start, at), start + 1) : number();
    }

    private Term named(String word, int column) {
        skipBlanks();
        if (at < text.length() && text.charAt(at) == '(') {
            return call(word, column);
        }
        return word.equals(PI) || word.equals("π") ? new Term.Constant(Math.PI, column) : new Term.Name(word, column);
    }

    private Term call(String word, int column) {
        Function function = Function.called(word).orElseThrow(() ->
                new FormulaException(column, "there is no function \"" + shortened(word) + "\"" + Similar.suggestion(word, Function.words())));
        accept("(");
        calls++;
        List<Term> terms = new ArrayList<>();
        do {
            terms.add(choice());
        } while (accept(",") || accept(";"));
        calls--;
        close();
        if (function == Function.RAND && terms.size() == 1) {
            terms.add(new Term.Constant(0, column));
        }
        boolean isOfAny = function == Function.MIN || function == Function.MAX;
        if (isOfAny ? terms.size() < 2 : terms.size() != function.terms()) {
            throw new FormulaException(column, word + " takes " + (isOfAny ? "two terms or more" : function.terms() == 1 ? "one term" : function.terms() + " terms")
                    + " in its parentheses, but has " + terms.size());
        }
        Term term = isOfAny ? terms.get(0) : new Term.Call(function, terms, column);
        for (int i = 1; isOfAny && i < terms.size(); i++) {
            term = new Term.Call(function, List.of(term, terms.get(i)), column);
        }
        return term;
    }

    private void close() {
        if (!accept(")")) {
            throw unexpected("\")\"" + (calls > 0 ? " or a comma" : ""));
        }
    }

    private Term number() {
        int start = at;
        digits();
        if (at < text.length() && (text.charAt(at) == '.' || isDecimalComma())) {
            at++;
            digits();
        }
        if (at < text.length() && at > start && (text.charAt(at) == 'e' || text.charAt(at) == 'E')) {
            at++;
            if (at < text.length() && (text.charAt(at) == '-' || text.charAt(at) == '+')) {
                at++;
            }
            digits();
        }
        try {
            double value = Double.parseDouble(text.substring(start, at).replace(',', '.'));
            if (!Double.isFinite(value)) {
                throw new FormulaException(start + 1, '"' + shortened(text.substring(start, at)) + "\" has no finite value");
            }
            skipBlanks();
            accept("°");
            return new Term.Constant(value, start + 1);
        } catch (NumberFormatException none) {
            at = start;
            throw unexpected("a number, a name or \"(\"");
        }
    }

    private boolean isDecimalComma() {
        return calls == 0 && text.charAt(at) == ',' && at > 0 && isDigit(at - 1) && at + 1 < text.length() && isDigit(at + 1);
    }

    private void digits() {
        while (at < text.length() && isDigit(at)) {
            at++;
        }
    }

    private boolean isDigit(int place) {
        return text.charAt(place) >= '0' && text.charAt(place) <= '9';
    }

    private boolean isLetter(int place) {
        return Character.isLetter(text.charAt(place)) || text.charAt(place) == '_';
    }

    /** Whether this stands here, and not only the beginning of a longer word; then it is behind us. */
    private boolean accept(String word) {
        int end = at + word.length();
        boolean isWord = Character.isLetter(word.charAt(0)) && end < text.length() && (isLetter(end) || isDigit(end));
        if (!text.startsWith(word, at) || isWord) {
            return false;
        }
        at = end;
        skipBlanks();
        return true;
    }

    private void skipBlanks() {
        while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
            at++;
        }
    }

    private void deeper() {
        if (++depth > 2 * DEEPEST) {
            throw new FormulaException(at + 1, "a formula must not be nested deeper than " + DEEPEST + " levels");
        }
    }

    private FormulaException unexpected(String expected) {
        String found = at < text.length() ? "\"" + shortened(text.substring(at)) + "\" was found" : text.isBlank() ? "nothing is there" : "the formula ends";
        return new FormulaException(at + 1, expected + " must stand here, but " + found);
    }

    private static String shortened(String text) {
        return text.length() > QUOTED ? text.substring(0, QUOTED - 1) + "…" : text;
    }
}
