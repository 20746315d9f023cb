package cz.paprsek.cli.input;

import java.util.LinkedHashMap;
import java.util.Map;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** What scenes are made of beside their files: values of parameters other than they say, and the files that they name. */
public final class ParameterWishes {
    /** Those that scenes say. */
    public static final ParameterWishes NONE = new ParameterWishes();

    @Mixin
    private Pictures pictures;

    @Option(names = "-D", paramLabel = "NAME=VALUE", description =
            "Another value for a parameter of the scene: a number, a formula in braces, or a text such as the name of a colour; 'paprsek info' lists them. May be given several times.")
    private Map<String, String> values = new LinkedHashMap<>();

    /** As picocli makes them. */
    public ParameterWishes() {
        this(new Pictures());
    }

    /** The scenes' own values, and files from elsewhere. */
    ParameterWishes(Pictures pictures) {
        this.pictures = pictures;
    }

    /** Values of parameters, by name. */
    public Map<String, String> values() {
        return Map.copyOf(values);
    }

    /** Where the files come from that scenes name. */
    public Pictures pictures() {
        return pictures;
    }

    /** The same files, but the scenes' own values. */
    ParameterWishes withoutValues() {
        return new ParameterWishes(pictures);
    }

    /** Whether there are values of parameters. */
    public boolean areSaid() {
        return !values.isEmpty();
    }
}
