package cz.paprsek.teach;

/** How many rays a pixel may take: where each makes two, a few levels more are thousands. */
final class Allowance {
    private int left;

    Allowance(int rays) {
        left = rays;
    }

    static Allowance unlimited() {
        return new Allowance(Integer.MAX_VALUE);
    }

    /** Takes one; false if none is left. */
    boolean take() {
        left -= left >= 0 ? 1 : 0;
        return left >= 0;
    }

    /** Whether more were asked for than there were. */
    boolean isExceeded() {
        return left < 0;
    }
}
