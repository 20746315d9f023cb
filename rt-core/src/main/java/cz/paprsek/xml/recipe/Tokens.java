package cz.paprsek.xml.recipe;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The numbers of a value one by one, with their formulas, and what is between them: one less.
 *
 * @param texts as they are written, at least one
 */
record Tokens(List<String> texts, List<String> between) {
    private static final String RANGE = "..";

    static Tokens of(String raw) {
        List<String> texts = new ArrayList<>();
        List<String> between = new ArrayList<>();
        StringBuilder token = new StringBuilder();
        boolean isFormula = false;
        String value = raw.strip();
        for (int at = 0; at < value.length(); at++) {
            char c = value.charAt(at);
            isFormula = c == '{' || (isFormula && c != '}');
            boolean isRange = value.startsWith(RANGE, at);
            if (isFormula || !(Character.isWhitespace(c) || isRange)) {
                token.append(c);
                continue;
            }
            texts.add(token.toString());
            between.add(isRange ? RANGE : " ");
            token.setLength(0);
            while (isRange ? at + 1 < value.length() && value.charAt(at + 1) == '.' : Character.isWhitespace(value.charAt(at + 1))) {
                at++;
            }
        }
        texts.add(token.toString());
        return new Tokens(texts, between);
    }

    /** One that stands for several, as a scale alike along all axes, written so many times. */
    Tokens spread(Tokens like) {
        return texts.size() == 1 && like.texts.size() > 1 ? new Tokens(Collections.nCopies(like.texts.size(), texts.get(0)), like.between) : this;
    }

    /**
     * What is to be written where a value has changed: each number that has stayed as it is written here, the others as they are now.
     *
     * @param before what this came to
     */
    String changed(Tokens before, Tokens now) {
        Tokens own = spread(before.spread(now));
        Tokens old = before.spread(now);
        Tokens fresh = now.spread(own);
        if (own.texts.size() != old.texts.size() || own.texts.size() != fresh.texts.size() || !own.between.equals(fresh.between)) {
            return now.text();
        }
        List<String> kept = new ArrayList<>();
        for (int i = 0; i < fresh.texts.size(); i++) {
            kept.add(old.texts.get(i).equals(fresh.texts.get(i)) ? own.texts.get(i) : fresh.texts.get(i));
        }
        return new Tokens(kept, fresh.between).text();
    }

    String text() {
        StringBuilder text = new StringBuilder(texts.get(0));
        for (int i = 1; i < texts.size(); i++) {
            text.append(between.get(i - 1)).append(texts.get(i));
        }
        return text.toString();
    }
}
