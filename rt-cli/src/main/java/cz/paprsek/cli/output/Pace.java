package cz.paprsek.cli.output;

/**
 * How long the rest of a picture takes, told from how long its pixels have taken lately. Tiles are traced all over the picture, so that any
 * stretch of time has seen its cheap and its costly parts. Pixels that an earlier render has left say nothing about speed.
 */
final class Pace {
    private final long total;
    private long done;
    private long found;
    /** Of pixels that end when they are near enough, the share of those that have; below 0 of others. */
    private double settled = -1;
    /** Two earlier moments: seconds, and pixels traced by then. What lies behind the older one, half of the time at most, is forgotten. */
    private double olderSeconds;
    private long olderTraced;
    private double newerSeconds;
    private long newerTraced;

    /** @param total how many pixels there are */
    Pace(long total) {
        this.total = total;
    }

    /** So many pixels were there already. */
    void found(long pixels) {
        done += pixels;
        found += pixels;
    }

    /** So many pixels have been traced, and this moment is so many seconds after the beginning. */
    void traced(long pixels, double seconds) {
        done += pixels;
        if (seconds >= 2 * newerSeconds) {
            olderSeconds = newerSeconds;
            olderTraced = newerTraced;
            newerSeconds = seconds;
            newerTraced = done - found;
        }
    }

    /** Such a share of the pixels, 0–1, is near enough; when the others will be nobody knows. */
    void settled(double share) {
        settled = Math.max(settled, share);
    }

    /** The share of the picture that is there, 0–1. */
    double share() {
        return settled >= 0 ? settled : (double) done / total;
    }

    /** Pixels traced a second, lately; not a number if pixels end when they are near enough. */
    double pixelsPerSecond(double seconds) {
        if (settled >= 0) {
            return Double.NaN;
        }
        return (done - found - olderTraced) / Math.max(seconds - olderSeconds, 1e-9);
    }

    /** Not a number as long as nothing can be said. */
    double secondsLeft(double seconds) {
        double speed = pixelsPerSecond(seconds);
        return speed > 0 ? (total - done) / speed : done == total ? 0 : Double.NaN;
    }
}
