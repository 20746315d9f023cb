package cz.paprsek.shape.font;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * By how much pairs of letters are moved together: the table kern.
 *
 * @source OpenType 1.9, kern, version 0, format 0
 */
final class Kerning {
    private static final int HORIZONTAL_PAIRS = 1;
    private static final int PAIRS = 0xff07;

    private final Map<Integer, Integer> moves = new HashMap<>();

    Kerning(Optional<Table> kern) {
        kern.filter(table -> table.unsigned16(0) == 0).ifPresent(this::read);
    }

    private void read(Table table) {
        int tables = table.unsigned16(2);
        long at = 4;
        for (int i = 0; i < tables; i++) {
            long length = Math.max(6, table.unsigned16(at + 2));
            if ((table.unsigned16(at + 4) & PAIRS) == HORIZONTAL_PAIRS) {
                int pairs = table.unsigned16(at + 6);
                // Of more than ten thousand pairs the length is too large for its two bytes.
                length = Math.max(length, 14 + 6L * pairs);
                for (int k = 0; k < pairs; k++) {
                    long pair = at + 14 + 6L * k;
                    moves.merge(table.unsigned16(pair) << 16 | table.unsigned16(pair + 2), table.signed16(pair + 4), Integer::sum);
                }
            }
            at += length;
        }
    }

    /** Between two glyphs, font units; below 0 for nearer. */
    int between(int left, int right) {
        return moves.getOrDefault(left << 16 | right, 0);
    }
}
