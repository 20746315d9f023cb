package cz.paprsek.image.film;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.TreeMap;

/**
 * At most 256 colours for a picture: its own if it has no more. Else the colours are cut into boxes at their medians, and pixels are dithered by a pattern that depends on their place alone, so that what does
 * not move does not flicker.
 *
 * @source Heckbert, Color Image Quantization for Frame Buffer Display, SIGGRAPH 1982; Bayer, An optimum method for two-level rendition of continuous-tone pictures, 1973
 */
final class Palette {
    static final int MOST = 256;
    /** Colours are counted by so many bits of each channel. */
    private static final int BITS = 5;
    private static final int SHIFT = 8 - BITS;
    private static final int CELLS = 1 << (3 * BITS);
    /** How far dithering changes a channel at most. */
    private static final int SPREAD = 5;
    private static final int[] ORDER = order();

    private final int[] colors;
    private final boolean isExact;
    /** For cells of colours, which is nearest, plus 1; 0 for not looked up yet. */
    private final short[] nearest;

    private Palette(int[] colors, boolean isExact) {
        this.colors = colors;
        this.isExact = isExact;
        this.nearest = new short[isExact ? 0 : CELLS];
    }

    /** @param rgb each as 0xRRGGBB */
    static Palette of(int[] rgb) {
        TreeMap<Integer, Integer> own = new TreeMap<>();
        for (int i = 0; i < rgb.length && own.size() <= MOST; i++) {
            if (i == 0 || rgb[i] != rgb[i - 1]) {
                own.put(rgb[i] & 0xFFFFFF, own.size());
            }
        }
        return own.size() <= MOST ? new Palette(own.keySet().stream().mapToInt(Integer::intValue).toArray(), true) : new Palette(cut(rgb), false);
    }

    /** How many bits it takes to number the colours. */
    int bits() {
        return Math.max(1, 32 - Integer.numberOfLeadingZeros(colors.length - 1));
    }

    /** A colour; black beyond those there are. */
    int color(int index) {
        return index < colors.length ? colors[index] : 0;
    }

    /** For each pixel, which colour it has. */
    byte[] indexes(int[] rgb, int width) {
        byte[] indexes = new byte[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            indexes[i] = (byte) (isExact ? Arrays.binarySearch(colors, rgb[i] & 0xFFFFFF) : dithered(rgb[i], ORDER[(i / width % 8) * 8 + i % width % 8]));
        }
        return indexes;
    }

    private int dithered(int rgb, int order) {
        // From −63 to 63 of 64.
        int change = SPREAD * (2 * order - 63) / 64;
        int cell = cell((clamp((rgb >> 16 & 0xFF) + change) << 16) | (clamp((rgb >> 8 & 0xFF) + change) << 8) | clamp((rgb & 0xFF) + change));
        if (nearest[cell] == 0) {
            nearest[cell] = (short) (nearest(cell) + 1);
        }
        return nearest[cell] - 1;
    }

    private static int clamp(int channel) {
        return Math.max(0, Math.min(255, channel));
    }

    private int nearest(int cell) {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int i = 0; i < colors.length; i++) {
            int distance = 0;
            for (int channel = 0; channel < 3; channel++) {
                int d = middle(cell, channel) - ((colors[i] >> (8 * channel)) & 0xFF);
                distance += d * d;
            }
            if (distance < least) {
                least = distance;
                best = i;
            }
        }
        return best;
    }

    private static int cell(int rgb) {
        return (((rgb >> 16) & 0xFF) >> SHIFT << (2 * BITS)) | (((rgb >> 8) & 0xFF) >> SHIFT << BITS) | ((rgb & 0xFF) >> SHIFT);
    }

    private static int axis(int cell, int channel) {
        return (cell >> (BITS * channel)) & ((1 << BITS) - 1);
    }

    private static int middle(int cell, int channel) {
        return (axis(cell, channel) << SHIFT) + (1 << (SHIFT - 1));
    }

    /** How often there are colours of each cell, and the sums of their channels. */
    private static final class Counts {
        private final int[] count = new int[CELLS];
        private final long[][] sums = new long[3][CELLS];

        static Counts of(int[] rgb) {
            Counts counts = new Counts();
            for (int color : rgb) {
                int cell = cell(color);
                counts.count[cell]++;
                for (int channel = 0; channel < 3; channel++) {
                    counts.sums[channel][cell] += (color >> (8 * channel)) & 0xFF;
                }
            }
            return counts;
        }
    }

    /** Some cells. */
    private record Box(List<Integer> cells, int longest, long weight) {
        static Box of(List<Integer> cells, Counts counts) {
            int longest = 0;
            int length = -1;
            for (int channel = 0; channel < 3; channel++) {
                int k = channel;
                int size = cells.stream().mapToInt(cell -> axis(cell, k)).max().orElse(0) - cells.stream().mapToInt(cell -> axis(cell, k)).min().orElse(0);
                if (size > length) {
                    length = size;
                    longest = channel;
                }
            }
            long total = cells.stream().mapToLong(cell -> counts.count[cell]).sum();
            return new Box(cells, longest, cells.size() < 2 ? 0 : total * length);
        }

        int color(Counts counts) {
            long total = cells.stream().mapToLong(cell -> counts.count[cell]).sum();
            int color = 0;
            for (int channel = 0; channel < 3; channel++) {
                long[] sums = counts.sums[channel];
                color |= (int) ((cells.stream().mapToLong(cell -> sums[cell]).sum() + total / 2) / total) << (8 * channel);
            }
            return color;
        }
    }

    private static int[] cut(int[] rgb) {
        Counts counts = Counts.of(rgb);
        List<Integer> all = new ArrayList<>();
        for (int cell = 0; cell < CELLS; cell++) {
            if (counts.count[cell] > 0) {
                all.add(cell);
            }
        }
        List<Box> boxes = new ArrayList<>(List.of(Box.of(all, counts)));
        while (boxes.size() < MOST) {
            Box widest = boxes.stream().max(Comparator.comparingLong(Box::weight)).orElseThrow();
            if (widest.weight == 0) {
                break;
            }
            boxes.remove(widest);
            List<Integer> sorted = new ArrayList<>(widest.cells);
            sorted.sort(Comparator.<Integer>comparingInt(cell -> axis(cell, widest.longest)).thenComparing(Comparator.naturalOrder()));
            long half = sorted.stream().mapToLong(cell -> counts.count[cell]).sum() / 2;
            int at = 0;
            for (long before = 0; at < sorted.size() - 1 && (at == 0 || before + counts.count[sorted.get(at)] <= half); at++) {
                before += counts.count[sorted.get(at)];
            }
            boxes.add(Box.of(sorted.subList(0, at), counts));
            boxes.add(Box.of(sorted.subList(at, sorted.size()), counts));
        }
        return boxes.stream().mapToInt(box -> box.color(counts)).distinct().sorted().toArray();
    }

    /** The numbers from 0 to 63 in eight rows, near ones far apart. */
    private static int[] order() {
        int[] order = new int[64];
        for (int i = 0; i < 64; i++) {
            int x = i & 7;
            int y = x ^ (i >> 3);
            int value = 0;
            for (int bit = 0; bit < 3; bit++) {
                value = 4 * value + 2 * ((y >> bit) & 1) + ((i >> (3 + bit)) & 1);
            }
            order[i] = value;
        }
        return order;
    }
}
