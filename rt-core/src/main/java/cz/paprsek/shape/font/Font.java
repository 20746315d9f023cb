package cz.paprsek.shape.font;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * A TrueType font. What is wrong with it is told by a sentence with the place, in bytes from the file's beginning: when it is made, or when a letter is
 * asked for. Immutable.
 *
 * @source OpenType 1.9
 */
public final class Font {
    private static final Map<Long, String> OTHERS = Map.of(
            tag("OTTO"), "this font has outlines as PostScript has them (CFF); only those of TrueType (glyf) are read",
            tag("ttcf"), "this is a collection of several fonts; only single ones are read",
            tag("wOFF"), "this is a compressed font of the web (WOFF); only TrueType (.ttf) is read",
            tag("wOF2"), "this is a compressed font of the web (WOFF2); only TrueType (.ttf) is read");
    private static final long VERSION = 0x00010000;
    private static final int DIRECTORY = 12;
    private static final int ENTRY = 16;

    private final int unitsPerEm;
    private final int lineHeight;
    private final int glyphs;
    private final int widths;
    private final Table hmtx;
    private final Characters characters;
    private final Kerning kerning;
    private final Glyphs outlines;

    /**
     * Reads one; no copy of the bytes is made.
     *
     * @throws IllegalArgumentException with a sentence if this is none, or one that is broken
     */
    public Font(byte[] file) {
        Table whole = new Table(file, 0, file.length, "of contents");
        long version = whole.unsigned32(0);
        if (OTHERS.containsKey(version)) {
            throw new IllegalArgumentException(OTHERS.get(version));
        }
        if (version != VERSION && version != tag("true")) {
            throw new IllegalArgumentException("this is no TrueType font: it must begin with the bytes 00 01 00 00, but has " + String.format("%08x", version));
        }
        Map<String, Table> tables = new HashMap<>();
        for (int i = 0; i < whole.unsigned16(4); i++) {
            long at = DIRECTORY + (long) ENTRY * i;
            String name = name(whole, at);
            tables.put(name, new Table(file, whole.unsigned32(at + 8), whole.unsigned32(at + 12), name));
        }
        Table head = needed(tables, "head");
        unitsPerEm = head.unsigned16(18);
        if (unitsPerEm < 16 || unitsPerEm > 16384) {
            throw head.refused(18, "a number of units from 16 to 16384", unitsPerEm);
        }
        int format = head.unsigned16(50);
        if (format > 1) {
            throw head.refused(50, "0 or 1 for the length of places", format);
        }
        glyphs = needed(tables, "maxp").unsigned16(4);
        Table hhea = needed(tables, "hhea");
        lineHeight = hhea.signed16(4) - hhea.signed16(6) + hhea.signed16(8);
        widths = hhea.unsigned16(34);
        if (widths < 1) {
            throw hhea.refused(34, "a number of widths above 0", widths);
        }
        hmtx = needed(tables, "hmtx");
        characters = new Characters(needed(tables, "cmap"));
        kerning = new Kerning(Optional.ofNullable(tables.get("kern")));
        outlines = new Glyphs(needed(tables, "loca"), needed(tables, "glyf"), format == 1, glyphs);
    }

    private static long tag(String name) {
        return (long) name.charAt(0) << 24 | name.charAt(1) << 16 | name.charAt(2) << 8 | name.charAt(3);
    }

    private static String name(Table whole, long at) {
        StringBuilder name = new StringBuilder();
        for (int i = 0; i < 4; i++) {
            int c = whole.unsigned8(at + i);
            name.append(c > ' ' && c < 127 ? (char) c : '?');
        }
        return name.toString();
    }

    private static Table needed(Map<String, Table> tables, String name) {
        Table table = tables.get(name);
        if (table == null) {
            throw new IllegalArgumentException("this font must have a table " + name + ", but there is none in its table of contents, from byte " + DIRECTORY + " on");
        }
        return table;
    }

    /** How many of its units the size of letters has. */
    public int unitsPerEm() {
        return unitsPerEm;
    }

    /** From one line to the next, in its units. */
    int lineHeight() {
        return lineHeight;
    }

    /** The number of a character's glyph; 0 if there is none. */
    public int glyph(int character) {
        int glyph = characters.glyph(character);
        return glyph < glyphs ? glyph : 0;
    }

    /** How far it is from a glyph's beginning to that of the next, in its units. */
    public int width(int glyph) {
        return hmtx.unsigned16(4L * Math.min(glyph, widths - 1));
    }

    int kerning(int left, int right) {
        return kerning.between(left, right);
    }

    /** A glyph as path data, in its units, y up from the base line; empty if it shows nothing. */
    String path(int glyph) {
        return outlines.path(glyph);
    }
}
