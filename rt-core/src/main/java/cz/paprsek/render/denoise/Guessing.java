package cz.paprsek.render.denoise;

/** Tells how sure a first guess is: by how far apart are what both halves have led to, and by what noise there was. Scratch of one worker. */
final class Guessing implements Stage.Step {
    /** One pixel tells little of that: so many around it do. */
    private static final int REACH = 2;
    /** A guess is wrong, too, where both halves agree: by this share of the variance of the noise, and of the square of the light. */
    private static final double NOISE = 0.3;
    private static final double EXACT = 1e-6;

    private final Noisy noisy;
    private final Noisy guess;

    /** @param guess is given its spread */
    Guessing(Noisy noisy, Noisy guess) {
        this.noisy = noisy;
        this.guess = guess;
    }

    @Override
    public void at(int left, int top) {
        for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
            for (int y = top; y < Math.min(guess.height, top + Window.HEIGHT); y++) {
                for (int x = left; x < Math.min(guess.width, left + Window.WIDTH); x++) {
                    int pixel = y * guess.width + x;
                    double mean = ((double) guess.light[0][channel][pixel] + guess.light[1][channel][pixel]) / 2;
                    guess.spread[channel][pixel] = (float) (apart(channel, x, y) + NOISE * noisy.spread[channel][pixel] + EXACT * mean * mean);
                }
            }
        }
    }

    /** The variance of either half, of which the square of their difference is twice that in the mean. */
    private double apart(int channel, int x, int y) {
        double sum = 0;
        int count = 0;
        for (int row = Math.max(0, y - REACH); row <= Math.min(guess.height - 1, y + REACH); row++) {
            for (int column = Math.max(0, x - REACH); column <= Math.min(guess.width - 1, x + REACH); column++) {
                int pixel = row * guess.width + column;
                double d = (double) guess.light[0][channel][pixel] - guess.light[1][channel][pixel];
                sum += d * d;
                count++;
            }
        }
        return sum / (2 * count);
    }
}
