package cz.paprsek.cli.process;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.Charset;

/**
 * Where messages go: to standard error, unless the launcher has put what Java itself says out of the way there, and named the place where it
 * has kept standard error, {@code /dev/fd/3}.
 */
public final class Messages {
    private static final String PLACE = "paprsek.messages";

    private Messages() {}

    /** Makes {@link System#err} what it was for the launcher. To be called before anything is said. */
    public static void restore() {
        String place = System.getProperty(PLACE);
        if (place != null) {
            try {
                System.setErr(new PrintStream(new FileOutputStream(place, true), true, Charset.defaultCharset()));
            } catch (IOException e) {
                System.out.println("paprsek: cannot write messages to " + place + ": " + e.getMessage());
            }
        }
    }

    /** The number of the stream that messages go to. */
    static int descriptor() {
        return System.getProperty(PLACE) == null ? 2 : 3;
    }
}
