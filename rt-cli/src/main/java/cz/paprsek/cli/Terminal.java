package cz.paprsek.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Whether somebody is watching. */
final class Terminal {
    private static final Path STANDARD_ERROR = Path.of("/proc/self/fd/2");

    private Terminal() {}

    /** Whether standard error leads to a terminal. Java tells this of input and output together only; where the system tells more, that counts. */
    @SuppressWarnings("SystemConsoleNull") // from JDK 22 on the answer is always yes, which costs a bar among other output, no more
    static boolean showsErrors() {
        try {
            return Files.isSymbolicLink(STANDARD_ERROR)
                    ? Files.readSymbolicLink(STANDARD_ERROR).toString().matches("/dev/(tty|pts/|console).*")
                    : System.console() != null;
        } catch (IOException e) {
            return false;
        }
    }
}
