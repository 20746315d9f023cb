package cz.paprsek.cli;

/** What the process answers to the shell. */
final class ExitCode {
    static final int DONE = 0;
    static final int FAILED = 1;
    static final int USAGE = 2;
    static final int BAD_SCENE = 3;
    static final int INTERRUPTED = 130;

    private ExitCode() {}
}
