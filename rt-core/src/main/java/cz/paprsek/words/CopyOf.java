package cz.paprsek.words;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Which copy of what is repeated a body is. Those with a name are told apart, which ends with the number of the copy, from 0, in brackets.
 *
 * @param number from 1
 * @param count how many there are
 */
public record CopyOf(int number, int count) {
    private static final Pattern NUMBERED = Pattern.compile("(.*)\\[(\\d{1,9})]");

    /** Of repeats within each other the outermost first; empty for what is no copy. */
    public static List<CopyOf> of(Scene scene, BodyAt at) {
        List<CopyOf> found = new ArrayList<>();
        String text = scene.recipe().text();
        if (!text.contains("<repeat")) {
            return found;
        }
        Matcher own = NUMBERED.matcher(at.in(scene).name());
        while (own.matches() && !isWritten(own.group(), text)) {
            found.add(0, new CopyOf(Integer.parseInt(own.group(2)) + 1, count(scene, at, own.group(1) + "[")));
            own = NUMBERED.matcher(own.group(1));
        }
        return found;
    }

    /** Whether somebody gave that name by hand, brackets and all: then it says nothing of copies. */
    private static boolean isWritten(String name, String text) {
        return text.contains("\"" + name + "\"") || text.contains("'" + name + "'");
    }

    private static int count(Scene scene, BodyAt at, String beginning) {
        List<String> siblings = at.depth() == 0 ? scene.objects().stream().map(one -> one.name()).toList()
                : at.parent().in(scene).operands().stream().map(one -> one.name()).toList();
        int most = 0;
        for (String name : siblings) {
            int end = name.startsWith(beginning) ? name.indexOf(']', beginning.length()) : -1;
            Matcher copy = NUMBERED.matcher(name.substring(0, end + 1));
            if (copy.matches() && copy.group(1).length() + 1 == beginning.length()) {
                most = Math.max(most, Integer.parseInt(copy.group(2)) + 1);
            }
        }
        return most;
    }

    /** As in {@code copy 5 of 24}. */
    String text(Words words) {
        return words.of("copy", number, count);
    }
}
