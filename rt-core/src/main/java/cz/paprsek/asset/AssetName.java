package cz.paprsek.asset;

import cz.paprsek.io.PlainText;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.regex.Pattern;

/** Which names assets may have: those that mean the same file below the scene's folder on every system, and nothing else on any. */
final class AssetName {
    private static final int LONGEST = 1000;
    private static final Pattern DEVICE = Pattern.compile("(con|prn|aux|nul|com\\d|lpt\\d)(\\..*)?");

    private AssetName() {}

    /** What a name must not be, and what to say of it. */
    private record Rule(Predicate<String> isBroken, String sentence) {}

    private static final List<Rule> OF_THE_WHOLE = List.of(
            new Rule(String::isBlank, "the name of a file is empty"),
            new Rule(name -> name.length() > LONGEST, "the name of a file is longer than " + LONGEST + " characters"),
            new Rule(name -> !name.codePoints().allMatch(PlainText::isPlain), "the name of a file has characters that do not show"),
            new Rule(name -> name.contains("\\"), "write / between folders: what \\ means differs from system to system"),
            new Rule(name -> name.contains(":"), "only files beside the scene can be read, by their relative name: no addresses, no drives"),
            new Rule(name -> name.startsWith("/"), "only files beside the scene can be read, by their relative name: this one is absolute"),
            new Rule(name -> name.endsWith("/"), "this is the name of a folder, not of a file"));

    private static final List<Rule> OF_EACH_PART = List.of(
            new Rule(String::isEmpty, "there is no name between two /"),
            new Rule(".."::equals, "only files in the scene's folder and below can be read, and .. leads out"),
            new Rule(part -> part.endsWith(".") || part.endsWith(" "), "no name may end with a dot or blank: some systems drop it"),
            new Rule(part -> DEVICE.matcher(part.toLowerCase(Locale.ROOT)).matches(), "this is the name of a device on Windows"));

    /**
     * The one way to write a name: parts between single slashes, without those that are a dot.
     *
     * @throws IOException with a sentence, if there can be no such asset
     */
    static String normal(String name) throws IOException {
        check(OF_THE_WHOLE, name, name);
        List<String> parts = new ArrayList<>(List.of(name.split("/", -1)));
        parts.removeIf("."::equals);
        for (String part : parts) {
            check(OF_EACH_PART, part, name);
        }
        String normal = String.join("/", parts);
        check(OF_THE_WHOLE, normal, name);
        return normal;
    }

    private static void check(List<Rule> rules, String text, String name) throws IOException {
        for (Rule rule : rules) {
            if (rule.isBroken().test(text)) {
                throw new IOException(Assets.quoted(name) + ": " + rule.sentence());
            }
        }
    }
}
