package cz.paprsek.cli.process;

/** The user asked for something that cannot be done as asked. The message says what and why, in one line. */
public final class WrongUsage extends RuntimeException {
    private static final long serialVersionUID = 1;

    public WrongUsage(String message) {
        super(message);
    }
}
