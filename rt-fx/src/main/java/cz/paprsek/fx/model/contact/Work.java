package cz.paprsek.fx.model.contact;

/** How many times a surface may be asked where a line meets it while one step of the hand is answered. What is left then is not looked at in this step. */
final class Work {
    /** So many of simple bodies take a few thousandths of a second. */
    static final int MOST = 4000;

    private long asked;
    private long last;

    void begin() {
        last = asked + MOST;
    }

    void ask() {
        asked++;
    }

    boolean isOver() {
        return asked >= last;
    }

    /** In all steps together. */
    long asked() {
        return asked;
    }
}
