package cz.paprsek.xml.text;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Which element of a list has become which one of another list, so that as many as can be stay where they are. */
public final class Alignment {
    /** As many comparisons as are worth it to find out which of some changed elements is which. */
    private static final int MOST_COMPARISONS = 10_000;

    private final List<Form> olds;
    private final List<Form> nows;
    private final int[] origins;

    private Alignment(List<Form> olds, List<Form> nows) {
        this.olds = olds;
        this.nows = nows;
        origins = new int[nows.size()];
        Arrays.fill(origins, -1);
    }

    /** For every new element, the place of the old one that it was; −1 if it was none. They increase: what has moved was none. */
    public static int[] of(List<Form> olds, List<Form> nows) {
        Alignment alignment = new Alignment(olds, nows);
        alignment.align();
        return alignment.origins;
    }

    private void align() {
        int first = 0;
        int shorter = Math.min(olds.size(), nows.size());
        while (first < shorter && olds.get(first).equals(nows.get(first))) {
            origins[first] = first;
            first++;
        }
        int oldTo = olds.size();
        int nowTo = nows.size();
        while (oldTo > first && nowTo > first && olds.get(oldTo - 1).equals(nows.get(nowTo - 1))) {
            oldTo--;
            nowTo--;
            origins[nowTo] = oldTo;
        }
        stay(first, oldTo, nowTo);
        change(first, oldTo, nowTo);
    }

    /** Finds what is the same and in the same order. */
    private void stay(int first, int oldTo, int nowTo) {
        if (first == oldTo || first == nowTo) {
            return;
        }
        Map<Form, Deque<Integer>> places = new HashMap<>();
        for (int i = first; i < oldTo; i++) {
            places.computeIfAbsent(olds.get(i), form -> new ArrayDeque<>()).add(i);
        }
        int[] same = new int[nowTo - first];
        for (int j = first; j < nowTo; j++) {
            Integer place = places.getOrDefault(nows.get(j), new ArrayDeque<>()).poll();
            same[j - first] = place == null ? -1 : place;
        }
        keepLongestIncreasing(same);
        System.arraycopy(same, 0, origins, first, same.length);
    }

    /** Sets all others to −1. Each number is there but once, except −1. */
    private static void keepLongestIncreasing(int[] numbers) {
        int[] ends = new int[numbers.length];
        int[] before = new int[numbers.length];
        int length = 0;
        for (int j = 0; j < numbers.length; j++) {
            if (numbers[j] < 0) {
                continue;
            }
            int low = 0;
            int high = length;
            while (low < high) {
                int middle = (low + high) / 2;
                if (numbers[ends[middle]] < numbers[j]) {
                    low = middle + 1;
                } else {
                    high = middle;
                }
            }
            before[j] = low == 0 ? -1 : ends[low - 1];
            ends[low] = j;
            length = Math.max(length, low + 1);
        }
        int[] kept = new int[numbers.length];
        Arrays.fill(kept, -1);
        for (int j = length == 0 ? -1 : ends[length - 1]; j >= 0; j = before[j]) {
            kept[j] = numbers[j];
        }
        System.arraycopy(kept, 0, numbers, 0, kept.length);
    }

    /** Finds what has been changed, between two that stay. */
    private void change(int first, int oldTo, int nowTo) {
        int old = first;
        int now = first;
        for (int j = first; j <= nowTo; j++) {
            if (j == nowTo || origins[j] >= 0) {
                int oldEnd = j == nowTo ? oldTo : origins[j];
                pair(old, oldEnd, now, j);
                old = oldEnd + 1;
                now = j + 1;
            }
        }
    }

    private void pair(int oldFrom, int oldTo, int nowFrom, int nowTo) {
        int height = oldTo - oldFrom;
        int width = nowTo - nowFrom;
        if (height == 0 || width == 0) {
            return;
        }
        if ((long) height * width > MOST_COMPARISONS) {
            for (int k = 0; k < Math.min(height, width); k++) {
                boolean isLike = Similarity.of(olds.get(oldFrom + k), nows.get(nowFrom + k)) > 0;
                origins[nowFrom + k] = isLike ? oldFrom + k : -1;
            }
            return;
        }
        int[][] likeness = new int[height][width];
        int[][] best = new int[height + 1][width + 1];
        for (int i = height - 1; i >= 0; i--) {
            for (int j = width - 1; j >= 0; j--) {
                likeness[i][j] = Similarity.of(olds.get(oldFrom + i), nows.get(nowFrom + j));
                int both = likeness[i][j] > 0 ? best[i + 1][j + 1] + likeness[i][j] : 0;
                best[i][j] = Math.max(both, Math.max(best[i + 1][j], best[i][j + 1]));
            }
        }
        int i = 0;
        int j = 0;
        while (i < height && j < width) {
            if (likeness[i][j] > 0 && best[i][j] == best[i + 1][j + 1] + likeness[i][j]) {
                origins[nowFrom + j++] = oldFrom + i++;
            } else if (best[i][j] == best[i + 1][j]) {
                i++;
            } else {
                j++;
            }
        }
    }
}
