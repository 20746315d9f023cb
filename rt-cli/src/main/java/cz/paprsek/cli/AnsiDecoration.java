package cz.paprsek.cli;

import cz.paprsek.io.PlainText;
import cz.paprsek.material.Rgb;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.Step.Topic;
import java.util.Locale;
import java.util.Map;

/**
 * A tree in the colours of a terminal. What comes out of a file is made harmless before colours are added.
 *
 * @param trueColor whether the terminal knows 16 million colours, not just 256
 */
record AnsiDecoration(boolean trueColor) implements Decoration {
    private static final String BOLD = "1";
    private static final String DIM = "2";
    private static final String GREEN = "32";
    private static final String YELLOW = "33";
    private static final String BLUE = "34";
    private static final String CYAN = "36";
    private static final Map<Topic, String> TOPICS = Map.of(Topic.AMBIENT, BLUE, Topic.LIGHT, YELLOW, Topic.SHADOW, YELLOW,
            Topic.REFLECTION, CYAN, Topic.REFRACTION, GREEN, Topic.SUM, BOLD);

    static AnsiDecoration ofSystem() {
        String support = System.getenv().getOrDefault("COLORTERM", "");
        return new AnsiDecoration(support.contains("truecolor") || support.contains("24bit"));
    }

    @Override
    public String headline(TracedRay.Kind kind, String text) {
        String color = switch (kind) {
            case PRIMARY -> YELLOW;
            case REFLECTED -> CYAN;
            case REFRACTED -> GREEN;
        };
        return in(BOLD + ";" + color, text);
    }

    @Override
    public String branch(String text) {
        return in(DIM, text);
    }

    @Override
    public String name(Topic topic, String text) {
        return in(TOPICS.getOrDefault(topic, ""), text);
    }

    @Override
    public String formula(String text) {
        return PlainText.of(text, Integer.MAX_VALUE);
    }

    @Override
    public String numbers(String text) {
        return in(DIM, text);
    }

    @Override
    public String result(Topic topic, String text) {
        return in(topic == Topic.SUM ? BOLD : TOPICS.getOrDefault(topic, ""), text);
    }

    @Override
    public String patch(LinearRgb light) {
        Rgb rgb = light.shown();
        int red = (int) Math.rint(rgb.red());
        int green = (int) Math.rint(rgb.green());
        int blue = (int) Math.rint(rgb.blue());
        String color = trueColor ? String.format(Locale.ROOT, "48;2;%d;%d;%d", red, green, blue)
                : "48;5;" + (16 + 36 * sixth(red) + 6 * sixth(green) + sixth(blue));
        return "\u001b[" + color + "m      \u001b[0m";
    }

    /** The nearest of the six levels 0, 95, 135, 175, 215, 255 that terminals of 256 colours have. */
    private static int sixth(int channel) {
        return channel < 48 ? 0 : channel < 115 ? 1 : (channel - 35) / 40;
    }

    private static String in(String code, String text) {
        String safe = PlainText.of(text, Integer.MAX_VALUE);
        return code.isEmpty() || safe.isBlank() ? safe : "\u001b[" + code + "m" + safe + "\u001b[0m";
    }
}
