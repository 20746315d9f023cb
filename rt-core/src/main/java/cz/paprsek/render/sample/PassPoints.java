package cz.paprsek.render.sample;

import java.util.Arrays;

/**
 * Scratch of one worker: the points of a whole pass of a pixel, by dimension. Samples of a pass that go alike ask for the same dimensions, and so do those of the next
 * one: of all that were asked for often, the points of all samples are made together before the first is asked for, step by step in plain loops, which the JVM makes
 * vectors of; that takes as long as a few by themselves.
 */
final class PassPoints {
    /** In place of where a point is: it is to be made by itself. */
    static final int ALONE = -1;

    private static final int SCRAMBLES = Sampler.SCRAMBLES;
    private static final int RUN = Sampler.RUN;
    /** How many dimensions are made at most, of paths. */
    static final int MOST = 64;
    /** So many samples must ask for a dimension that it is made for the next pass, and no longer if there are fewer than these. */
    private static final int OFTEN = 6;
    private static final int SELDOM = 3;
    private static final int LOG = 10;
    /** Spreads dimensions over the entries: 2³² times the golden ratio. */
    private static final int SPREAD = 0x9E37_79B1;
    /** Of an entry: the dimension, its first lane or {@link #ALONE}, by how many samples of this pass it was asked for, and whether as a direction. */
    private static final int ENTRY = 4;
    private static final int LANE = 1;
    private static final int ASKED = 2;
    private static final int IS_TURN = 3;

    private final int[] table = new int[ENTRY << LOG];
    /** Entries of dimensions that are not made. */
    private final int[] others = new int[1 << LOG];
    private int othersCount;
    /** The entries of those that are made, directions first. */
    private final int[] made;
    private int madeCount;
    private int turnCount;

    private final int scramble;
    private final int size;
    private int pixel;
    private int first = -1;
    /** How often it has been decided what is made: until then what was found stays where it is. */
    int plans;
    /** Whether the points are still those of another pass. */
    private boolean isStale;
    /** Where the sample's points are among those of a dimension, and its directions. */
    private int offset;
    private int turnOffset;

    // A lane is a sequence of a dimension; lane by lane for the first sample of each sequence, then for the second ones, and so on.
    /** Of lanes, the dimension together with the sequence, and two hashes of that. */
    private final int[] owns;
    private final int[] orderSeeds;
    private final int[] hashes;
    private final int[] reversed;
    private int reversedFirst = -1;
    private int reversedLanes;
    private final int[] places;
    private final int[] keys;
    private final int[] indices;
    private final int[] us;
    private final int[] vs;
    private final PassTurns turns;

    /**
     * No points yet.
     *
     * @param scramble what is added to a dimension for each sequence
     * @param size how many digits number the points
     * @param most how many dimensions are made together at most
     */
    PassPoints(int scramble, int size, int most) {
        this.scramble = scramble;
        this.size = size;
        made = new int[most];
        owns = new int[most * SCRAMBLES];
        orderSeeds = new int[most * SCRAMBLES];
        hashes = new int[most * SCRAMBLES];
        int points = most * SCRAMBLES * RUN;
        reversed = new int[points];
        places = new int[points];
        keys = new int[points];
        indices = new int[points];
        us = new int[points];
        vs = new int[points];
        turns = new PassTurns(points);
        for (int entry = 0; entry < table.length; entry += ENTRY) {
            table[entry + LANE] = ALONE;
        }
    }

    /** Turns to a sample of a pixel. */
    void turnTo(int toPixel, int sample) {
        int pass = sample / PassSums.PASS;
        if (pixel != toPixel || first != pass) {
            pixel = toPixel;
            first = pass;
            isStale = true;
            plan();
        }
        int sequence = Sampler.scramble(sample);
        int run = sample & (RUN - 1);
        offset = run * (madeCount * SCRAMBLES) + sequence;
        turnOffset = run * (turnCount * SCRAMBLES) + sequence;
    }

    /**
     * Where the sample's point of a dimension is, or {@link #ALONE}.
     *
     * @param dimension without what tells sequences apart
     */
    int find(int dimension) {
        int lane = lane(dimension);
        return lane == ALONE ? ALONE : lane + offset;
    }

    /** Where the sample's direction of a dimension is among {@link #turns}, or {@link #ALONE}. */
    int findTurn(int dimension) {
        int lane = lane(dimension);
        if (lane != ALONE && lane < turnCount * SCRAMBLES) {
            return lane + turnOffset;
        }
        table[entry(dimension) + IS_TURN] = 1;
        return ALONE;
    }

    /** Notes where a dimension is that was found. */
    void note(int dimension, Asked asked) {
        asked.entry = entry(dimension);
        asked.lane = table[asked.entry + LANE];
    }

    /** Where the sample's point is of a dimension that was noted since the last plan: as {@link #find}. */
    int again(Asked asked) {
        table[asked.entry + ASKED]++;
        return asked.lane + offset;
    }

    /** Likewise, as {@link #findTurn}. */
    int turnAgain(Asked asked) {
        table[asked.entry + ASKED]++;
        return asked.lane + turnOffset;
    }

    private int lane(int dimension) {
        int entry = entry(dimension);
        if (table[entry] != dimension) {
            return begin(dimension, entry);
        }
        table[entry + ASKED]++;
        int lane = table[entry + LANE];
        if (lane != ALONE && isStale) {
            fill();
        }
        return lane;
    }

    private static int entry(int dimension) {
        return ((dimension * SPREAD) >>> (Integer.SIZE - LOG)) * ENTRY;
    }

    /** The dimension takes the entry from another one that is not made. */
    private int begin(int dimension, int entry) {
        if (table[entry + LANE] == ALONE) {
            if (table[entry] == 0) {
                others[othersCount++] = entry;
            }
            table[entry] = dimension;
            table[entry + ASKED] = 1;
            table[entry + IS_TURN] = 0;
        }
        return ALONE;
    }

    int u(int at) {
        return us[at];
    }

    int v(int at) {
        return vs[at];
    }

    PassTurns turns() {
        return turns;
    }

    /** Decides by what the last pass asked for which dimensions are made. */
    private void plan() {
        plans++;
        for (int i = madeCount - 1; i >= 0; i--) {
            int entry = made[i];
            boolean isMoved = table[entry + IS_TURN] != 0 && i >= turnCount;
            if (table[entry + ASKED] < SELDOM || isMoved) {
                drop(i);
            } else {
                table[entry + ASKED] = 0;
            }
        }
        int kept = 0;
        for (int i = 0; i < othersCount; i++) {
            int entry = others[i];
            boolean isOften = table[entry + ASKED] >= OFTEN && madeCount < made.length;
            if (isOften) {
                make(entry);
            } else if (table[entry + ASKED] == 0) {
                table[entry] = 0;
            } else {
                others[kept++] = entry;
            }
            table[entry + ASKED] = 0;
        }
        othersCount = kept;
    }

    private void make(int entry) {
        int slot = madeCount;
        if (table[entry + IS_TURN] != 0) {
            slot = turnCount++;
            move(slot, madeCount);
        }
        madeCount++;
        put(entry, slot);
        for (int i = 0; i < SCRAMBLES; i++) {
            int own = table[entry] + scramble * i;
            owns[slot * SCRAMBLES + i] = own;
            orderSeeds[slot * SCRAMBLES + i] = Sampler.mixed(own ^ Sampler.ORDER);
            hashes[slot * SCRAMBLES + i] = Sampler.mixed(own);
        }
    }

    private void drop(int slot) {
        int entry = made[slot];
        table[entry + LANE] = ALONE;
        others[othersCount++] = entry;
        int free = slot;
        if (slot < turnCount) {
            free = --turnCount;
            move(free, slot);
        }
        move(--madeCount, free);
    }

    private void move(int from, int to) {
        if (from != to) {
            put(made[from], to);
            System.arraycopy(owns, from * SCRAMBLES, owns, to * SCRAMBLES, SCRAMBLES);
            System.arraycopy(orderSeeds, from * SCRAMBLES, orderSeeds, to * SCRAMBLES, SCRAMBLES);
            System.arraycopy(hashes, from * SCRAMBLES, hashes, to * SCRAMBLES, SCRAMBLES);
        }
    }

    private void put(int entry, int slot) {
        made[slot] = entry;
        table[entry + LANE] = slot * SCRAMBLES;
    }

    /**
     * Makes the points of the pass: the same as {@link Sampler} makes one by one. In one method, which is too long for the JVM to put it into others: so what is called here is
     * always put into these loops, and vectors made of them.
     */
    private void fill() {
        isStale = false;
        int count = madeCount * SCRAMBLES;
        int all = count * RUN;
        count(count);
        int[] ofPlace = places;
        int[] ofKey = keys;
        int[] ofIndex = indices;
        int reversedPixel = Integer.reverse(pixel);
        int[] seeds = orderSeeds;
        for (int i = 0; i < count; i++) {
            ofPlace[i] = reverse(Sampler.permuted(reversedPixel, seeds[i]));
        }
        int[] own = owns;
        int rest = Integer.SIZE - size;
        for (int i = 0; i < count; i++) {
            ofKey[i] = Sampler.mixed(own[i] + (ofPlace[i] >>> rest));
        }
        int[] hash = hashes;
        int digits = size;
        for (int i = 0; i < count; i++) {
            ofIndex[i] = Sampler.mixed(ofPlace[i] ^ hash[i]);
            ofPlace[i] = ofPlace[i] << digits;
        }
        // For the first sample of each sequence, and so for all.
        for (int n = count; n < all; n *= 2) {
            System.arraycopy(ofKey, 0, ofKey, n, n);
            System.arraycopy(ofPlace, 0, ofPlace, n, n);
            System.arraycopy(ofIndex, 0, ofIndex, n, n);
        }
        int[] number = reversed;
        int within = (1 << digits) - 1;
        for (int i = 0; i < all; i++) {
            ofIndex[i] = ofPlace[i] | (reverse(Sampler.permuted(number[i], ofIndex[i])) & within);
        }
        int[] v = vs;
        for (int i = 0; i < all; i++) {
            v[i] = reverse(Sampler.permuted(Sampler.second(ofIndex[i]), ofKey[i] ^ Sampler.SECOND));
        }
        int[] u = us;
        for (int i = 0; i < all; i++) {
            u[i] = reverse(Sampler.permuted(ofIndex[i], ofKey[i]));
        }
        turns.fill(u, v, turnCount * SCRAMBLES, count, RUN);
    }

    /** Puts the number of each sample in its sequence in place, unless it is there. */
    private void count(int lanes) {
        if (reversedFirst != first || reversedLanes != lanes) {
            reversedFirst = first;
            reversedLanes = lanes;
            for (int i = 0; i < RUN; i++) {
                Arrays.fill(reversed, i * lanes, (i + 1) * lanes, Integer.reverse(first * RUN + i));
            }
        }
    }

    /** As {@link Integer#reverse}, of which not every JVM makes vectors. */
    private static int reverse(int x) {
        int y = x;
        y = (y & 0x5555_5555) << 1 | (y >>> 1 & 0x5555_5555);
        y = (y & 0x3333_3333) << 2 | (y >>> 2 & 0x3333_3333);
        y = (y & 0x0F0F_0F0F) << 4 | (y >>> 4 & 0x0F0F_0F0F);
        y = (y & 0x00FF_00FF) << 8 | (y >>> 8 & 0x00FF_00FF);
        return y << 16 | y >>> 16;
    }
}
