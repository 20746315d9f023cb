package cz.paprsek.format.model;

import java.util.Arrays;

/** Gives pairs of numbers a number each, from 0 on, in the order in which they first come. */
public final class Pairs {
    private static final int NONE = -1;

    private final Ints first = new Ints();
    private final Ints second = new Ints();
    private int[] buckets = new int[1 << 10];

    public Pairs() {
        Arrays.fill(buckets, NONE);
    }

    public int size() {
        return first.size();
    }

    public int number(int a, int b) {
        if (2L * first.size() > buckets.length && buckets.length < 1 << 30) {
            buckets = new int[2 * buckets.length];
            Arrays.fill(buckets, NONE);
            for (int i = 0; i < first.size(); i++) {
                buckets[bucket(first.get(i), second.get(i))] = i;
            }
        }
        int at = bucket(a, b);
        if (buckets[at] == NONE) {
            buckets[at] = first.size();
            first.add(a);
            second.add(b);
        }
        return buckets[at];
    }

    private int bucket(int a, int b) {
        int mask = buckets.length - 1;
        int at = (((a * 31 + b) * 0x9E3779B9) >>> 7) & mask;
        while (buckets[at] != NONE && (first.get(buckets[at]) != a || second.get(buckets[at]) != b)) {
            at = (at + 1) & mask;
        }
        return at;
    }
}
