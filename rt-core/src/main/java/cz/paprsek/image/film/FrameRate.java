package cz.paprsek.image.film;

/**
 * Pictures a second as a ratio of whole numbers below 65 536.
 *
 * @param frames so many
 * @param seconds in so many
 */
record FrameRate(int frames, int seconds) {
    private static final int MOST = 65_535;
    /** That of 29.97 pictures a second, which are 30000/1001, is one of those that are in use. */
    private static final int MOST_SECONDS = 1001;
    private static final double ROUNDING = 1e-9;

    /** The simplest ratio that is the number, or the nearest there is. */
    static FrameRate of(double fps) {
        FrameRate nearest = new FrameRate((int) Math.max(1, Math.rint(fps)), 1);
        for (int seconds = 1; seconds <= MOST_SECONDS && fps * seconds <= MOST; seconds++) {
            double frames = Math.rint(fps * seconds);
            FrameRate rate = new FrameRate((int) Math.max(1, frames), seconds);
            if (Math.abs(fps * seconds - frames) < ROUNDING * frames) {
                return rate;
            }
            nearest = Math.abs(rate.value() - fps) < Math.abs(nearest.value() - fps) ? rate : nearest;
        }
        return nearest;
    }

    private double value() {
        return (double) frames / seconds;
    }
}
