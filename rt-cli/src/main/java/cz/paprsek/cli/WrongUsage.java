package cz.paprsek.cli;

/** The user asked for something that cannot be done as asked. The message says what and why, in one line. */
final class WrongUsage extends RuntimeException {
    private static final long serialVersionUID = 1;

    WrongUsage(String message) {
        super(message);
    }
}
