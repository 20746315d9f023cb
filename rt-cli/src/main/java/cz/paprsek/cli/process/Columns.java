package cz.paprsek.cli.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** How wide things are on the terminal. */
public final class Columns {
    /** As wide as every terminal is, where its width cannot be learnt. */
    public static final int USUAL = 80;

    private static final Path TERMINAL = Path.of("/dev/tty");
    private static final long PATIENCE_MILLIS = 500;
    /** The lowest of the characters that East Asian scripts make two columns wide. */
    private static final int WIDE = 0x1100;

    private Columns() {}

    /** The width of the process's terminal now: it may have changed. Java cannot tell, so another program is asked. */
    public static int ofTerminal() {
        if (!Files.isReadable(TERMINAL)) {
            return USUAL;
        }
        try {
            Process stty = new ProcessBuilder("stty", "size").redirectInput(TERMINAL.toFile())
                    .redirectError(ProcessBuilder.Redirect.DISCARD).start();
            stty.getOutputStream().close();
            String[] size = new String(stty.getInputStream().readAllBytes(), StandardCharsets.US_ASCII).strip().split(" ", -1);
            int columns = stty.waitFor(PATIENCE_MILLIS, TimeUnit.MILLISECONDS) && size.length == 2 ? Integer.parseInt(size[1]) : 0;
            return columns > 0 ? columns : USUAL;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return USUAL;
        } catch (IOException | NumberFormatException unknown) {
            return USUAL;
        }
    }

    /** How many columns a text takes. */
    public static int of(String text) {
        return text.codePoints().map(Columns::of).sum();
    }

    /** A text in lines of so many columns at most, broken at spaces; what has none stays whole. */
    public static List<String> lines(String text, int columns) {
        List<String> lines = new ArrayList<>();
        StringBuilder line = new StringBuilder();
        for (String word : text.split(" ", -1)) {
            if (!line.isEmpty() && of(line.toString()) + 1 + of(word) > columns) {
                lines.add(line.toString());
                line.setLength(0);
            }
            line.append(line.isEmpty() ? "" : " ").append(word);
        }
        lines.add(line.toString());
        return lines;
    }

    /** The end of a text that fits into so many columns, with dots where something is missing. */
    public static String end(String text, int columns) {
        if (of(text) <= columns) {
            return text;
        }
        String end = text;
        while (!end.isEmpty() && of(end) + 3 > columns) {
            end = end.substring(end.offsetByCodePoints(0, 1));
        }
        return ("..." + end).substring(0, Math.min(3 + end.length(), Math.max(0, columns)));
    }

    private static int of(int character) {
        return switch (Character.getType(character)) {
            case Character.NON_SPACING_MARK, Character.ENCLOSING_MARK -> 0;
            default -> character >= WIDE && (Character.isIdeographic(character) || isWide(Character.UnicodeScript.of(character))
                    || (character >= 0x1F300 && character < 0x20000)) ? 2 : 1;
        };
    }

    private static boolean isWide(Character.UnicodeScript script) {
        return switch (script) {
            case HAN, HANGUL, HIRAGANA, KATAKANA, BOPOMOFO, YI -> true;
            default -> false;
        };
    }
}
