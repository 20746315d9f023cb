package cz.paprsek.fx.view.find;

import java.text.Normalizer;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Something that is found by its name.
 *
 * @param where the menu it stands in, or what kind of thing it is
 * @param keys what does it without looking for it; empty for none
 * @param possible whether it can be done now
 */
public record Findable(String name, String where, String keys, boolean possible, Runnable action) {
    private static final Pattern MARKS = Pattern.compile("\\p{M}+");
    private static final Pattern BLANKS = Pattern.compile("\\s+");

    /**
     * Those in which every word of a question stands: what is called so first, then what begins so, and what cannot be done last. Neither case nor
     * accents matter.
     */
    public static List<Findable> matching(List<Findable> all, String question) {
        List<String> words = Stream.of(BLANKS.split(plain(question.strip()))).filter(word -> !word.isEmpty()).toList();
        return all.stream().filter(one -> one.rank(words) != Rank.NO)
                .sorted(Comparator.<Findable>comparingInt(one -> one.possible ? 0 : 1).thenComparing(one -> one.rank(words))).toList();
    }

    private enum Rank { IS, BEGINS, WORDS, INSIDE, NO }

    private Rank rank(List<String> words) {
        String text = plain(name);
        String whole = text + " " + plain(where);
        if (!words.stream().allMatch(whole::contains)) {
            return Rank.NO;
        }
        boolean begins = words.isEmpty() || text.startsWith(words.get(0));
        boolean beginsWords = words.stream().allMatch(word -> (" " + whole).contains(" " + word));
        return text.equals(String.join(" ", words)) ? Rank.IS : begins ? Rank.BEGINS : beginsWords ? Rank.WORDS : Rank.INSIDE;
    }

    private static String plain(String text) {
        return MARKS.matcher(Normalizer.normalize(text, Normalizer.Form.NFD)).replaceAll("").toLowerCase(Locale.ROOT);
    }
}
