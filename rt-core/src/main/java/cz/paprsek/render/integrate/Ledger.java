package cz.paprsek.render.integrate;

import cz.paprsek.ray.Arrival;
import cz.paprsek.render.surface.Level;
import java.util.Arrays;

/**
 * What the light of one ray from the eye is made of: an entry for each time that light was added, at a ray of its path or its tree. Hears what a tracer tells, and
 * works out in the end how much of each entry reaches the eye. Scratch of one worker.
 */
public class Ledger extends Witness {
    /** In place of the number of a light: the background, or the sky. */
    public static final int SKY = -1;
    /** Light from nowhere, that counts at each hit. */
    public static final int AMBIENT = -2;
    /** What the surface that was hit gives off of its own. */
    public static final int EMISSION = -3;
    private static final int CHANNELS = 3;
    private static final int NONE = -1;

    private int rays;
    private int open;
    private int[] parent = new int[16];
    private int[] part = new int[16];
    private boolean[] isLit = new boolean[16];
    /** Of each ray, what its light is multiplied by where it is added to that of the one before; what substances leave on its way; and both of all before it. */
    private double[] weight = new double[16 * CHANNELS];
    private double[] left = new double[16 * CHANNELS];
    private double[] reaching = new double[16 * CHANNELS];
    private final double[] nextWeight = new double[CHANNELS];
    private final double[] nextLeft = new double[CHANNELS];

    private int entries;
    private int[] ray = new int[16];
    private int[] source = new int[16];
    private double[] light = new double[16 * CHANNELS];
    /** The light that was looked for last, at which ray, and how many entries there were before. */
    private int sought;
    private int soughtAt;
    private int entriesBefore;
    /** What was summed. */
    public double red;
    public double green;
    public double blue;

    /** Begins another ray from the eye. */
    public final void clear() {
        rays = 0;
        entries = 0;
        open = NONE;
        sought = NONE;
        soughtAt = NONE;
        Arrays.fill(nextWeight, 1);
        Arrays.fill(nextLeft, 1);
    }

    @Override
    public void following(boolean refracted, double red, double green, double blue) {
        set(nextWeight, 0, red, green, blue);
    }

    @Override
    public void met(Level level) {
        begin(level, level.ray.part);
        if (level.red != 0 || level.green != 0 || level.blue != 0) {
            add(AMBIENT, level.red, level.green, level.blue);
        }
    }

    @Override
    public void missed(Level level) {
        arrived(level, SKY);
    }

    @Override
    public void seen(Level level, int lamp) {
        arrived(level, lamp);
    }

    /** The level's ray ends at a light, or at the sky; its light is told as it arrives. */
    private void arrived(Level level, int from) {
        begin(level, NONE);
        Arrays.fill(nextLeft, 1);
        add(from, level.red, level.green, level.blue);
        open = parent[open];
    }

    @Override
    public void emitted(double red, double green, double blue) {
        add(EMISSION, red, green, blue);
    }

    @Override
    public void sought(int lamp, Arrival arrival, double facing, double visibility) {
        if (lamp != sought || open != soughtAt) {
            sought = lamp;
            soughtAt = open;
            entriesBefore = entries;
        }
    }

    @Override
    public void illuminated(double diffuse, double highlight, double red, double green, double blue) {
        add(sought, red, green, blue);
    }

    /** Of several points of a light that were looked for it is the mean that counts. */
    @Override
    public void averaged(int lamp, double red, double green, double blue) {
        entries = entriesBefore;
        add(lamp, red, green, blue);
        soughtAt = NONE;
    }

    @Override
    public void absorbed(int object, double length, double red, double green, double blue) {
        set(nextLeft, 0, red, green, blue);
    }

    @Override
    public void ended(Level level) {
        System.arraycopy(nextLeft, 0, left, CHANNELS * open, CHANNELS);
        Arrays.fill(nextLeft, 1);
        open = parent[open];
        soughtAt = NONE;
    }

    private void begin(Level level, int met) {
        if (rays == parent.length) {
            int more = 2 * rays;
            parent = Arrays.copyOf(parent, more);
            part = Arrays.copyOf(part, more);
            isLit = Arrays.copyOf(isLit, more);
            weight = Arrays.copyOf(weight, more * CHANNELS);
            left = Arrays.copyOf(left, more * CHANNELS);
            reaching = Arrays.copyOf(reaching, more * CHANNELS);
        }
        parent[rays] = open;
        part[rays] = met;
        isLit[rays] = level.isLit;
        System.arraycopy(nextWeight, 0, weight, CHANNELS * rays, CHANNELS);
        set(left, rays, 1, 1, 1);
        open = rays++;
    }

    private void add(int from, double red, double green, double blue) {
        if (entries == ray.length) {
            ray = Arrays.copyOf(ray, 2 * entries);
            source = Arrays.copyOf(source, 2 * entries);
            light = Arrays.copyOf(light, 2 * CHANNELS * entries);
        }
        ray[entries] = open;
        source[entries] = from;
        set(light, entries++, red, green, blue);
    }

    private static void set(double[] numbers, int at, double red, double green, double blue) {
        numbers[CHANNELS * at] = red;
        numbers[CHANNELS * at + 1] = green;
        numbers[CHANNELS * at + 2] = blue;
    }

    /** Whether nothing was told yet of the ray from the eye. */
    protected final boolean isEmpty() {
        return rays == 0;
    }

    /** Works out what of each entry reaches the eye, once all rays have ended. */
    public final void close() {
        for (int i = 0; i < rays; i++) {
            for (int c = 0; c < CHANNELS; c++) {
                double before = parent[i] < 0 ? 1 : reaching[CHANNELS * parent[i] + c];
                reaching[CHANNELS * i + c] = before * weight[CHANNELS * i + c] * left[CHANNELS * i + c];
            }
        }
        for (int i = 0; i < entries; i++) {
            for (int c = 0; c < CHANNELS; c++) {
                light[CHANNELS * i + c] *= reaching[CHANNELS * ray[i] + c];
            }
        }
    }

    /**
     * Sums what comes from a light, in {@link #red}, {@link #green} and {@link #blue}.
     *
     * @param lights how many the scene has; if there is none of that number, what comes from none of them is summed, as from bodies that shine
     */
    public final void sum(int number, int lights) {
        begin();
        for (int i = 0; i < entries; i++) {
            if (number < lights ? source[i] == number : source[i] < 0 || source[i] >= lights) {
                plus(i);
            }
        }
    }

    /** Sums what is added to the light of the ray from the eye itself, in the order in which the tracer adds it; to be called before {@link #close}. */
    public final void sumFirst() {
        begin();
        for (int i = 0; i < entries; i++) {
            if (ray[i] == 0) {
                plus(i);
            }
        }
        red *= left[0];
        green *= left[1];
        blue *= left[2];
    }

    /**
     * Of paths, sums light that comes straight to what is seen: there at once, or strewn there. What a mirror or glass brings is not, nor what was strewn before.
     */
    public final void sumDirect() {
        begin();
        for (int i = 0; i < entries; i++) {
            int at = ray[i];
            if (at == 0 || (parent[at] == 0 && isLit[at] && (part[at] < 0 || source[i] == EMISSION))) {
                plus(i);
            }
        }
    }

    private void begin() {
        red = 0;
        green = 0;
        blue = 0;
    }

    private void plus(int entry) {
        red += red(entry);
        green += green(entry);
        blue += blue(entry);
    }

    public final int entries() {
        return entries;
    }

    /** Where the light of an entry comes from: the number of a light, or of a body or the sky's picture that are looked for as lights are, {@link #SKY}, {@link #AMBIENT} or {@link #EMISSION}. */
    public final int source(int entry) {
        return source[entry];
    }

    public final double red(int entry) {
        return light[CHANNELS * entry];
    }

    public final double green(int entry) {
        return light[CHANNELS * entry + 1];
    }

    public final double blue(int entry) {
        return light[CHANNELS * entry + 2];
    }

    /** The ray whose light an entry is added to. */
    public final int ray(int entry) {
        return ray[entry];
    }

    /** The ray that a ray goes on from; below 0 for that from the eye. */
    public final int parent(int number) {
        return parent[number];
    }

    /** The part of an object that a ray hits; below 0 if it ends at a light, or at the sky. */
    public final int part(int number) {
        return part[number];
    }
}
