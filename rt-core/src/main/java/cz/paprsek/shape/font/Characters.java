package cz.paprsek.shape.font;

/**
 * Which glyph a character is: the table cmap.
 *
 * @source OpenType 1.9, cmap, formats 0, 4, 6 and 12
 */
final class Characters {
    private static final int UNICODE = 0;
    private static final int MACINTOSH = 1;
    private static final int WINDOWS = 3;

    private final Table table;
    private final int format;

    Characters(Table cmap) {
        int best = -1;
        int bestRank = -1;
        int count = cmap.unsigned16(2);
        for (int i = 0; i < count; i++) {
            int rank = rank(cmap.unsigned16(4 + 8L * i), cmap.unsigned16(6 + 8L * i), cmap.unsigned16(cmap.unsigned32(8 + 8L * i)));
            if (rank > bestRank) {
                bestRank = rank;
                best = i;
            }
        }
        if (best < 0) {
            throw cmap.refused(2, "an encoding by Unicode, in format 4 or 12,", count);
        }
        table = cmap.at(cmap.unsigned32(8 + 8L * best));
        format = table.unsigned16(0);
    }

    /** The higher, the better; below 0 for what is not read. Of the Macintosh's characters only those of ASCII are the same. */
    private static int rank(int platform, int encoding, int format) {
        boolean isUnicode = platform == UNICODE || (platform == WINDOWS && (encoding == 1 || encoding == 10));
        return isUnicode && format == 12 ? 3 : isUnicode && (format == 4 || format == 6) ? 2 : platform == MACINTOSH && (format == 0 || format == 6) ? 1 : -1;
    }

    /** The number of a glyph; 0 if there is none. */
    int glyph(int character) {
        return switch (format) {
            case 0 -> character < 128 ? table.unsigned8(6 + character) : 0;
            case 4 -> character < 0x10000 ? inSegments(character) : 0;
            case 6 -> {
                int first = table.unsigned16(6);
                yield character >= first && character < first + table.unsigned16(8) ? table.unsigned16(10 + 2L * (character - first)) : 0;
            }
            default -> inGroups(character);
        };
    }

    private int inSegments(int character) {
        int twice = table.unsigned16(6);
        for (int i = 0; i < twice; i += 2) {
            if (table.unsigned16(14L + i) < character) {
                continue;
            }
            int start = table.unsigned16(16L + twice + i);
            int delta = table.unsigned16(16L + 2L * twice + i);
            long offsetAt = 16L + 3L * twice + i;
            int offset = table.unsigned16(offsetAt);
            if (start > character) {
                return 0;
            }
            int glyph = offset == 0 ? character : table.unsigned16(offsetAt + offset + 2L * (character - start));
            return glyph == 0 ? 0 : glyph + delta & 0xffff;
        }
        return 0;
    }

    private int inGroups(int character) {
        long low = 0;
        long high = table.unsigned32(12);
        while (low < high) {
            long middle = (low + high) / 2;
            long at = 16 + 12 * middle;
            if (character < table.unsigned32(at)) {
                high = middle;
            } else if (character > table.unsigned32(at + 4)) {
                low = middle + 1;
            } else {
                return (int) Math.min(0xffff, table.unsigned32(at + 8) + character - table.unsigned32(at));
            }
        }
        return 0;
    }
}
