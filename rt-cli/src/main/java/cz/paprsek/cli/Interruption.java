package cz.paprsek.cli;

/** Whether the user wants the process to end. */
final class Interruption {
    private volatile boolean requested;
    private volatile boolean closed;

    /** Asks whatever runs to stop; without effect once the work is done. */
    void request() {
        requested |= !closed;
    }

    boolean isRequested() {
        return requested;
    }

    /** The work is done: nothing is left to interrupt. */
    void close() {
        closed = true;
    }
}
