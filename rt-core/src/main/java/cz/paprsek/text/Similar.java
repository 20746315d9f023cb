package cz.paprsek.text;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** Finds the known name that a misspelt one was probably meant to be. */
public final class Similar {
    private Similar() {}

    /** Longer names, and longer lists of them, are not searched: it would take longer than anybody waits for advice. */
    private static final int LONGEST = 60;
    private static final int MOST_KNOWN = 1000;
    /** So many names are told at most, which fill two lines; of more, so many. */
    private static final int MOST_TOLD = 32;
    private static final int FIRST_TOLD = 12;

    /** The known name nearest to {@code name}, if one is near enough to be a slip of the fingers, or is {@code name} with a word more. */
    public static Optional<String> nearest(String name, Collection<String> known) {
        if (name.length() > LONGEST || known.size() > MOST_KNOWN) {
            return Optional.empty();
        }
        int most = Math.max(1, name.length() / 3);
        Optional<String> slip = known.stream()
                .filter(candidate -> Math.abs(candidate.length() - name.length()) <= most && distance(name, candidate) <= most && hasMore(name, candidate))
                .min(Comparator.comparingInt((String candidate) -> distance(name, candidate)).thenComparing(c -> c));
        return slip.or(() -> known.stream().filter(candidate -> List.of(candidate.split("-", -1)).contains(name)).min(Comparator.naturalOrder()));
    }

    /** Of a name of one letter with another one nothing is left. */
    private static boolean hasMore(String name, String candidate) {
        return distance(name, candidate) < Math.max(name.length(), candidate.length()) && !candidate.isBlank();
    }

    /** {@code ; did you mean "…"?}, or nothing. */
    public static String suggestion(String name, Collection<String> known) {
        return nearest(name, known).map(found -> "; did you mean \"" + found + "\"?").orElse("");
    }

    /**
     * What to say behind the complaint that a name is not one of those known: {@code ; did you mean "…"?} if one is near, else {@code ; there are a, b, c},
     * of many the first ones only: {@code ; there are a, b, c and 50 more}.
     *
     * @param known in the order in which they are told, at least one
     */
    public static String choice(String name, Collection<String> known) {
        return nearest(name, known).map(found -> "; did you mean \"" + found + "\"?").orElseGet(() -> "; there are " + listed(known));
    }

    /** As {@code a, b, c}, or of many {@code a, b, c and 50 more}. */
    public static String listed(Collection<String> known) {
        boolean isLong = known.size() > MOST_TOLD;
        return known.stream().limit(isLong ? FIRST_TOLD : MOST_TOLD).collect(Collectors.joining(", ")) + (isLong ? " and " + (known.size() - FIRST_TOLD) + " more" : "");
    }

    /** Insertions, deletions, replacements and swaps of neighbours that turn one word into the other, letter case ignored. */
    private static int distance(String first, String second) {
        String a = first.toLowerCase(Locale.ROOT);
        String b = second.toLowerCase(Locale.ROOT);
        int[][] cost = new int[a.length() + 1][b.length() + 1];
        for (int i = 0; i <= a.length(); i++) {
            for (int j = 0; j <= b.length(); j++) {
                cost[i][j] = i == 0 || j == 0 ? i + j
                        : Math.min(Math.min(cost[i - 1][j], cost[i][j - 1]) + 1,
                                cost[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1));
                if (i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1)) {
                    cost[i][j] = Math.min(cost[i][j], cost[i - 2][j - 2] + 1);
                }
            }
        }
        return cost[a.length()][b.length()];
    }
}
