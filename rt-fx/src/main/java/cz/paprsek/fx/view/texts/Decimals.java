package cz.paprsek.fx.view.texts;

import java.util.regex.Pattern;

/** Numbers among other things that stand in a field as they do in a file: they alone have the decimal sign of the language. */
public final class Decimals {
    private static final Pattern NUMBER = Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");

    private Decimals() {}

    /** Whether it is a number as files have it. */
    public static boolean isNumber(String written) {
        return NUMBER.matcher(written).matches();
    }

    /** What a file has, as it is shown. */
    public static String shown(String written, Texts texts) {
        return isNumber(written) ? texts.number(written) : written;
    }

    /** What has been typed, as files have it: a number with a comma with a point. */
    public static String written(String typed) {
        String points = typed.replace(',', '.');
        return isNumber(points) ? points : typed;
    }
}
