package cz.paprsek.cli.input;

import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;

/** Names of scenes made fit for files on every system: the same for a scene whichever others are asked for. */
public final class FileNames {
    private static final int LONGEST = 80;
    private static final Pattern UNFIT = Pattern.compile("[^\\p{L}\\p{M}\\p{N}._()+-]+");
    /** Windows keeps these for devices. */
    private static final Pattern DEVICE = Pattern.compile("(?i)(con|prn|aux|nul|com\\d|lpt\\d)(\\..*)?");

    private FileNames() {}

    /** For every name one that is fit for a file, no two alike even where case does not count. */
    public static Map<String, String> of(Collection<String> names) {
        Map<String, String> fit = new LinkedHashMap<>();
        Set<String> taken = new HashSet<>();
        for (String name : names) {
            String base = fit(name);
            String unique = base;
            for (int i = 2; !taken.add(unique.toLowerCase(Locale.ROOT)); i++) {
                unique = base + "-" + i;
            }
            fit.put(name, unique);
        }
        return fit;
    }

    private static String fit(String name) {
        String plain = UNFIT.matcher(name).replaceAll("-").replaceAll("^[-.]+|[-.]+$", "");
        String shorter = plain.substring(0, plain.offsetByCodePoints(0, Math.min(LONGEST, plain.codePointCount(0, plain.length()))));
        return shorter.isEmpty() ? "scene" : DEVICE.matcher(shorter).matches() ? "scene-" + shorter : shorter;
    }
}
