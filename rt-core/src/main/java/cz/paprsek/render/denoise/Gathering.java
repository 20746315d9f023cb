package cz.paprsek.render.denoise;

import cz.paprsek.render.film.Film;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.show.Guides;

/** Takes from the film what was kept of its pixels. Scratch of one worker. */
final class Gathering implements Stage.Step {
    private static final int HALF = Sampler.SCRAMBLES / 2;

    private final Film film;
    private final Noisy out;
    private final float[] kept;
    private final PassSums sums;
    private final double[][] groups = new double[Noisy.CHANNELS][Sampler.SCRAMBLES];

    /** @param kept how many numbers of a pixel are kept: the sums of its light first, its guides last */
    Gathering(Film film, Passes paths, int kept, Noisy out) {
        this.film = film;
        this.out = out;
        this.kept = new float[kept];
        this.sums = paths.newSums();
    }

    @Override
    public void at(int left, int top) {
        for (int y = top; y < Math.min(out.height, top + Window.HEIGHT); y++) {
            for (int x = left; x < Math.min(out.width, left + Window.WIDTH); x++) {
                film.kept(film.left() + x, film.top() + y, kept);
                sums.load(kept, 0);
                light(y * out.width + x);
                guides(y * out.width + x, sums.count() / 2.0);
            }
        }
    }

    private void light(int pixel) {
        for (int i = 0; i < Sampler.SCRAMBLES; i++) {
            sums.sequence(i);
            groups[0][i] = sums.red;
            groups[1][i] = sums.green;
            groups[2][i] = sums.blue;
        }
        for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
            double first = mean(groups[channel], 0);
            double second = mean(groups[channel], HALF);
            double mean = (first + second) / 2;
            double squares = 0;
            for (double one : groups[channel]) {
                squares += (one - mean) * (one - mean);
            }
            out.light[0][channel][pixel] = (float) first;
            out.light[1][channel][pixel] = (float) second;
            out.spread[channel][pixel] = (float) (squares / (Sampler.SCRAMBLES - 1) / HALF);
        }
    }

    private static double mean(double[] groups, int from) {
        double sum = 0;
        for (int i = from; i < from + HALF; i++) {
            sum += groups[i];
        }
        return sum / HALF;
    }

    private void guides(int pixel, double each) {
        int from = kept.length - Guides.SIZE;
        for (int i = 0; i < Guides.COUNT; i++) {
            double first = kept[from + i] / each;
            double second = kept[from + Guides.COUNT + i] / each;
            out.guides[i][pixel] = (float) ((first + second) / 2);
            out.doubts[i][pixel] = (float) ((first - second) * (first - second) / 4);
        }
    }
}
