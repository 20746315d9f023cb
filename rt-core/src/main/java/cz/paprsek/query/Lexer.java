package cz.paprsek.query;

import cz.paprsek.query.Token.Kind;
import cz.paprsek.text.Numbers;
import java.util.ArrayList;
import java.util.List;

/** Takes a filter apart into words. Column names may have hyphens and dots in them; there is no minus to mistake them for. */
final class Lexer {
    private static final List<String> SYMBOLS = List.of("<=", ">=", "!=", "<>", "==", "=", "<", ">", "(", ")", ",");

    private final String text;
    private final List<Token> tokens = new ArrayList<>();
    private int at;

    private Lexer(String text) {
        this.text = text;
    }

    static List<Token> tokens(String text) throws FilterException {
        Lexer lexer = new Lexer(text);
        while (lexer.at < text.length()) {
            lexer.next();
        }
        lexer.tokens.add(new Token(Kind.END, "", text.length() + 1));
        return lexer.tokens;
    }

    private void next() throws FilterException {
        char c = text.charAt(at);
        if (Character.isWhitespace(c)) {
            at++;
        } else if (c == '"' || c == '\'') {
            quoted(c);
        } else if (Character.isLetter(c) || c == '_') {
            take(Kind.WORD, endOf(at, false));
        } else if (Character.isDigit(c) || c == '.' || c == '-' || c == '+') {
            take(Kind.NUMBER, endOf(at, true));
        } else {
            symbol();
        }
    }

    /** Where the word that begins here ends. A sign belongs to a number at its beginning and after its exponent's e. */
    private int endOf(int start, boolean isNumber) {
        int end = start + 1;
        while (end < text.length()) {
            char c = text.charAt(end);
            boolean isSign = c == '-' || (c == '+' && isNumber);
            boolean afterExponent = Character.toLowerCase(text.charAt(end - 1)) == 'e';
            if (!(Character.isLetterOrDigit(c) || c == '_' || c == '.' || (isSign && (!isNumber || afterExponent)))) {
                break;
            }
            end++;
        }
        return end;
    }

    private void take(Kind kind, int end) throws FilterException {
        Token token = new Token(kind, text.substring(at, end), at + 1);
        if (kind == Kind.NUMBER) {
            number(token);
        }
        tokens.add(token);
        at = end;
    }

    /** The number that a token is. */
    static double number(Token token) throws FilterException {
        return Numbers.parsed(token.text()).orElseThrow(() -> new FilterException(token.position(), token.shown() + " is not a number"));
    }

    private void quoted(char quote) throws FilterException {
        StringBuilder meaning = new StringBuilder();
        int i = at + 1;
        while (i < text.length() && (text.charAt(i) != quote || text.startsWith(String.valueOf(quote), i + 1))) {
            i += text.charAt(i) == quote ? 1 : 0;
            meaning.append(text.charAt(i));
            i++;
        }
        if (i >= text.length()) {
            throw new FilterException(at + 1, "this text has no end; close it with " + quote);
        }
        tokens.add(new Token(Kind.TEXT, meaning.toString(), at + 1));
        at = i + 1;
    }

    private void symbol() throws FilterException {
        for (String symbol : SYMBOLS) {
            if (text.startsWith(symbol, at)) {
                take(Kind.SYMBOL, at + symbol.length());
                return;
            }
        }
        String found = new String(Character.toChars(text.codePointAt(at)));
        throw new FilterException(at + 1, "\"" + found + "\" means nothing in a filter" + advice(found));
    }

    private static String advice(String found) {
        return switch (found) {
            case "&" -> "; write and";
            case "|" -> "; write or";
            case "!" -> "; write not, or != between two values";
            case "“", "”", "„" -> "; put text in \" or '";
            case "%" -> "; put the pattern in \" or '";
            default -> "";
        };
    }
}
