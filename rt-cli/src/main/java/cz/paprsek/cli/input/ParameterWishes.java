package cz.paprsek.cli.input;

import java.util.LinkedHashMap;
import java.util.Map;
import picocli.CommandLine.Option;

/** What the user wants parameters of scenes to be, otherwise than the scenes say. */
public final class ParameterWishes {
    /** Those that scenes say. */
    public static final ParameterWishes NONE = new ParameterWishes();

    @Option(names = "-D", paramLabel = "NAME=VALUE", description =
            "Another value for a parameter of the scene: a number, a formula in braces, or a text such as the name of a colour; 'paprsek info' lists them. May be given several times.")
    private Map<String, String> values = new LinkedHashMap<>();

    /** By name. */
    public Map<String, String> values() {
        return Map.copyOf(values);
    }

    public boolean areSaid() {
        return !values.isEmpty();
    }
}
