package cz.paprsek.render.show;

import cz.paprsek.render.surface.Level;
import java.util.Arrays;

/** What the rays of a pixel meet first: scratch of one worker. */
final class FirstHits {
    /** How many numbers are kept of normals and distances. */
    static final int SIZE = 5;

    /** Of each of its samples, the number of the object it meets; 0 for none. */
    private int[] objects = new int[64];
    private int samples;
    /** The sum of the normals, and of the distances, of those that meet something, and how many there are. */
    final KeptSums sums = new KeptSums(SIZE);

    void clear() {
        samples = 0;
        sums.clear();
    }

    /** A sample meets nothing, as long as it is not said to {@link #meet}. */
    void begin() {
        if (samples == objects.length) {
            objects = Arrays.copyOf(objects, 2 * samples);
        }
        objects[samples++] = 0;
    }

    void meet(Level level, int number) {
        objects[samples - 1] = number + 1;
        sums.add(0, level.hit.sx);
        sums.add(1, level.hit.sy);
        sums.add(2, level.hit.sz);
        sums.add(3, level.ray.max);
        sums.add(4, 1);
    }

    /** Of the sample at hand, the number of the object it meets, from 1; 0 if it meets none. */
    int object() {
        return objects[samples - 1];
    }

    double normalX() {
        return sums.at(0) * share();
    }

    double normalY() {
        return sums.at(1) * share();
    }

    double normalZ() {
        return sums.at(2) * share();
    }

    double distance() {
        return sums.at(3) * share();
    }

    private double share() {
        return 1 / Math.max(1, sums.at(4));
    }

    /** Of the objects that the samples meet, the one that most do; of several the first in the scene. */
    int mostFrequent() {
        Arrays.sort(objects, 0, samples);
        int most = 0;
        int winner = 0;
        int run = 0;
        for (int i = 0; i < samples; i++) {
            run = i > 0 && objects[i] == objects[i - 1] ? run + 1 : 1;
            if (run > most) {
                most = run;
                winner = objects[i];
            }
        }
        return winner;
    }

    /** Goes on with sums that were kept, but of the objects with none, from a place on; where what follows them begins. */
    int load(float[] numbers, int from) {
        samples = 0;
        return sums.load(numbers, from);
    }
}
