package cz.paprsek.query;

import cz.paprsek.query.Token.Kind;
import cz.paprsek.text.Similar;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/**
 * From words to a condition, by recursive descent:
 *
 * <pre>
 * or         = and { "or" and }
 * and        = not { "and" not }
 * not        = { "not" } ( "(" or ")" | "exists" related | comparison )
 * comparison = term ( sign term | [ "not" ] "like" text | [ "not" ] "in" "(" term { "," term } ")" )
 * term       = column | number | text | "count" related
 * related    = "(" table [ "where" or ] ")"
 * </pre>
 */
final class FilterParser<R> {
    private static final Set<String> RESERVED = Set.of("and", "or", "not", "like", "in", "where");

    private final Tokens tokens;
    private final Table<R> table;

    FilterParser(Tokens tokens, Table<R> table) {
        this.tokens = tokens;
        this.table = table;
    }

    Predicate<R> whole() throws FilterException {
        Predicate<R> condition = or();
        if (tokens.peek().kind() != Kind.END) {
            throw tokens.unexpected("\"and\", \"or\" or the end");
        }
        return condition;
    }

    private Predicate<R> or() throws FilterException {
        List<Predicate<R>> any = new ArrayList<>(List.of(and()));
        while (tokens.skip("or")) {
            any.add(and());
        }
        return any.size() == 1 ? any.get(0) : row -> {
            for (Predicate<R> one : any) {
                if (one.test(row)) {
                    return true;
                }
            }
            return false;
        };
    }

    private Predicate<R> and() throws FilterException {
        List<Predicate<R>> all = new ArrayList<>(List.of(not()));
        while (tokens.skip("and")) {
            all.add(not());
        }
        return all.size() == 1 ? all.get(0) : row -> {
            for (Predicate<R> one : all) {
                if (!one.test(row)) {
                    return false;
                }
            }
            return true;
        };
    }

    private Predicate<R> not() throws FilterException {
        boolean isNegated = false;
        while (tokens.skip("not")) {
            isNegated = !isNegated;
        }
        return negated(isNegated, condition());
    }

    private static <R> Predicate<R> negated(boolean isNegated, Predicate<R> condition) {
        return isNegated ? condition.negate() : condition;
    }

    private Predicate<R> condition() throws FilterException {
        if (tokens.peek().is("(")) {
            tokens.next();
            tokens.open();
            Predicate<R> inner = or();
            tokens.close();
            tokens.expect(")", "to close the parenthesis");
            return inner;
        }
        if (tokens.peek().is("exists") && tokens.second().is("(")) {
            Related<R> related = related();
            return row -> related.count(row, 1) > 0;
        }
        return comparison(term());
    }

    private Predicate<R> comparison(Term<R> left) throws FilterException {
        Token token = tokens.next();
        if (token.is("!=") || token.is("<>")) {
            return compared(left, Comparison.EQUAL, term(left)).negate();
        }
        Comparison comparison = Comparison.of(token).orElse(null);
        if (comparison != null) {
            return compared(left, comparison, term(left));
        }
        boolean isNegated = token.is("not");
        Token word = isNegated ? tokens.next() : token;
        if (word.is("like")) {
            return negated(isNegated, like(left));
        }
        if (word.is("in")) {
            return negated(isNegated, in(left));
        }
        throw new FilterException(word.position(), "expected = != < <= > >= like or in after " + left.name() + ", but found " + word.shown());
    }

    private static <R> Predicate<R> compared(Term<R> left, Comparison comparison, Term<R> right) throws FilterException {
        Term<R> a = left.isFixed() ? left.toMatch(right, comparison) : left;
        Term<R> b = left.isFixed() ? right : right.toMatch(left, comparison);
        return row -> a.any(row, x -> b.any(row, y -> comparison.holds(x, y)));
    }

    private Predicate<R> like(Term<R> left) throws FilterException {
        if (left.type() != Column.Type.TEXT) {
            throw new FilterException(left.token().position(), left.name() + " is " + left.type().words() + "; only text can be like something");
        }
        if (tokens.peek().kind() != Kind.TEXT) {
            throw tokens.unexpected("a pattern in quotes, such as \"gl%\"");
        }
        LikePattern pattern = new LikePattern(tokens.next().text());
        return row -> left.any(row, value -> pattern.matches(value.text()));
    }

    private Predicate<R> in(Term<R> left) throws FilterException {
        tokens.expect("(", "after in");
        List<Term<R>> list = new ArrayList<>();
        do {
            list.add(term(left).toMatch(left, Comparison.EQUAL));
        } while (tokens.skip(","));
        tokens.expect(")", "or \",\" in the list");
        return row -> left.any(row, x -> list.stream().anyMatch(term -> term.any(row, y -> Comparison.EQUAL.holds(x, y))));
    }

    /** What is compared with another term. */
    private Term<R> term(Term<R> other) throws FilterException {
        Token token = tokens.peek();
        if (other.type() == Column.Type.TEXT && !other.isFixed() && token.kind() == Kind.WORD && !tokens.second().is("(")
                && RESERVED.stream().noneMatch(token::is) && table.column(token.text()).isEmpty()) {
            throw new FilterException(token.position(), other.name() + " is text, and texts need quotes: \"" + token.text() + "\"");
        }
        return term();
    }

    private Term<R> term() throws FilterException {
        Token token = tokens.peek();
        if (token.is("count") && tokens.second().is("(")) {
            Related<R> related = related();
            return new Term<>(token, "count", Column.Type.NUMBER, false,
                    (row, test) -> test.test(new Value.Scalar(related.count(row, Long.MAX_VALUE))));
        }
        if (token.kind() == Kind.SYMBOL || token.kind() == Kind.END || (token.kind() == Kind.WORD && RESERVED.stream().anyMatch(token::is))) {
            throw tokens.unexpected("a column, a number or text in quotes");
        }
        tokens.next();
        return switch (token.kind()) {
            case NUMBER -> Term.fixed(token, Column.Type.NUMBER, new Value.Scalar(Lexer.number(token)));
            case TEXT -> Term.fixed(token, Column.Type.TEXT, new Value.Text(token.text()));
            default -> Term.of(token, table.column(token.text()).orElseThrow(() -> noColumn(token)));
        };
    }

    private FilterException noColumn(Token token) {
        String name = token.text();
        int dot = name.indexOf('.');
        Column<R> whole = dot < 0 ? null : table.column(name.substring(0, dot)).orElse(null);
        if (whole != null) {
            return new FilterException(token.position(), whole.name() + " is " + whole.type().words() + " and has no part \"" + name.substring(dot + 1)
                    + "\"" + (whole.type().parts().isEmpty() ? "" : "; it has " + String.join(", ", whole.type().parts())));
        }
        return new FilterException(token.position(), "there is no column \"" + name + "\" in " + table.name() + Similar.choice(name, table.names()));
    }

    private Related<R> related() throws FilterException {
        Token word = tokens.next();
        tokens.expect("(", "after " + word.text());
        if (table.related().isEmpty()) {
            throw new FilterException(word.position(), word.text() + "(...) asks about a whole scene, but this filter is for the rows of " + table.name());
        }
        Token name = tokens.next();
        Relation<R, ?> relation = table.relation(name.text()).filter(found -> name.kind() == Kind.WORD).orElseThrow(() -> noTable(word, name));
        Related<R> related = related(relation);
        tokens.expect(")", "after the table");
        return related;
    }

    private <C> Related<R> related(Relation<R, C> relation) throws FilterException {
        if (!tokens.skip("where")) {
            return (row, most) -> relation.rows().apply(row).limit(most).count();
        }
        tokens.open();
        Predicate<C> condition = new FilterParser<>(tokens, relation.table()).or();
        tokens.close();
        return (row, most) -> relation.rows().apply(row).filter(condition).limit(most).count();
    }

    private FilterException noTable(Token word, Token name) {
        List<String> known = table.related().stream().map(relation -> relation.table().name()).toList();
        return new FilterException(name.position(), word.text() + " wants the name of a table, but found " + name.shown()
                + Similar.choice(name.text(), known));
    }

    /** Related rows that are asked for. */
    @FunctionalInterface
    private interface Related<R> {
        /** How many there are for a row, counted no further than need be. */
        long count(R row, long most);
    }
}
