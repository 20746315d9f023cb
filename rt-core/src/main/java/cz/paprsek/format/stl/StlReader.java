package cz.paprsek.format.stl;

import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.model.TextLines;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Reads STL. A file is text if it begins with {@code solid}, has no zero byte in its first kilobyte, and not exactly the size that its bytes 80 to 83 would
 * ask for; for many a program writes {@code solid} at the beginning of bytes.
 *
 * @source 3D Systems, StereoLithography Interface Specification, 1989, as described by M. Burns, Automated Fabrication, 1993, §6.5
 */
public final class StlReader {
    private static final Convention CONVENTION = new Convention("mm", true);
    private static final int HEAD = 84;
    private static final int RECORD = 50;
    private static final int SEEN = 1024;
    private static final int AT_ONCE = 1024;

    private final Weld weld = new Weld();
    private final Notes notes = new Notes();
    private FacetColors colors = FacetColors.of(new byte[HEAD]);

    private StlReader() {}

    /** @param size how many bytes there are; {@link Long#MAX_VALUE} if nobody knows */
    public static Model read(InputStream input, long size) throws IOException {
        BufferedInputStream peeked = new BufferedInputStream(input, 1 << 16);
        peeked.mark(SEEN);
        byte[] head = peeked.readNBytes(SEEN);
        peeked.reset();
        StlReader reader = new StlReader();
        if (isText(head, size)) {
            reader.text(new TextLines(peeked, false));
        } else {
            reader.bytes(peeked, size);
        }
        if (reader.weld.isEmpty()) {
            throw FormatFault.in("the end", "there is no triangle in this file");
        }
        return Model.of(reader.weld.build(), CONVENTION, reader.notes);
    }

    static boolean isText(byte[] head, long size) {
        int at = 0;
        while (at < head.length && ((head[at] <= ' ' && head[at] > 0) || (head[at] & 0x80) != 0) && at < 8) {
            at++;
        }
        if (!new String(head, at, Math.min(5, head.length - at), StandardCharsets.ISO_8859_1).equalsIgnoreCase("solid")) {
            return false;
        }
        for (byte b : head) {
            if (b == 0) {
                return false;
            }
        }
        return head.length < HEAD || size != HEAD + RECORD * count(head);
    }

    private static long count(byte[] head) {
        return ByteBuffer.wrap(head, 80, 4).order(ByteOrder.LITTLE_ENDIAN).getInt() & 0xFFFFFFFFL;
    }

    private void bytes(InputStream input, long size) throws IOException {
        byte[] head = input.readNBytes(HEAD);
        if (head.length < HEAD) {
            throw FormatFault.at(head.length, "the file ends here, but an STL file in bytes has a head of 84; and a text begins with \"solid\"");
        }
        colors = FacetColors.of(head);
        long count = count(head);
        if (size != Long.MAX_VALUE && count > (size - HEAD) / RECORD) {
            throw FormatFault.at(80, "the file says it has " + count + " triangles, but there is room for " + (size - HEAD) / RECORD);
        }
        byte[] piece = new byte[RECORD * AT_ONCE];
        ByteBuffer numbers = ByteBuffer.wrap(piece).order(ByteOrder.LITTLE_ENDIAN);
        for (long done = 0; done < count;) {
            int wanted = (int) Math.min(AT_ONCE, count - done);
            int got = input.readNBytes(piece, 0, RECORD * wanted) / RECORD;
            for (int i = 0; i < got; i++) {
                triangle(numbers, RECORD * i, HEAD + RECORD * (done + i));
            }
            done += got;
            if (got < wanted) {
                throw FormatFault.at(HEAD + RECORD * done, "the file ends within triangle " + (done + 1) + " of " + count);
            }
        }
        if (input.read() >= 0) {
            notes.add("byte " + (HEAD + RECORD * count), "what follows the last of the " + count + " triangles is not read");
        }
    }

    private void triangle(ByteBuffer numbers, int from, long offset) throws IOException {
        weld.color(colors.of(numbers.getShort(from + 48) & 0xFFFF));
        for (int k = 0; k < 3; k++) {
            int at = from + 12 + 12 * k;
            float x = numbers.getFloat(at);
            float y = numbers.getFloat(at + 4);
            float z = numbers.getFloat(at + 8);
            if (!(Math.abs(x) + Math.abs(y) + Math.abs(z) <= Float.MAX_VALUE)) {
                throw FormatFault.at(offset + 12 + 12L * k, "a corner must have three numbers, but is " + x + " " + y + " " + z);
            }
            weld.corner(k, x, y, z);
        }
        weld.triangle();
    }

    private void text(TextLines lines) throws IOException {
        int corner = 0;
        boolean isWithin = false;
        while (lines.wordAnywhere()) {
            if (lines.is("vertex")) {
                double x = coordinate(lines, "x of a corner");
                double y = coordinate(lines, "y of a corner");
                double z = coordinate(lines, "z of a corner");
                if (!isWithin || corner == 3) {
                    throw lines.fault(isWithin ? "this is the fourth corner of a triangle" : "a corner must be within \"facet\" and \"endfacet\"");
                }
                weld.corner(corner++, x, y, z);
            } else if (lines.is("facet")) {
                if (isWithin) {
                    throw lines.fault("here must be \"endfacet\" before the next \"facet\"");
                }
                isWithin = true;
                corner = 0;
                lines.next();
            } else if (lines.is("endfacet")) {
                if (!isWithin || corner < 3) {
                    throw lines.fault(isWithin ? "a triangle has three corners, but this one has " + corner : "here is \"endfacet\" without \"facet\"");
                }
                weld.triangle();
                isWithin = false;
            } else if (lines.is("solid")) {
                weld.part(lines.rest());
                lines.next();
            } else if (lines.is("endsolid") || lines.is("color")) {
                lines.next();
            } else if (!lines.is("outer") && !lines.is("loop") && !lines.is("endloop")) {
                throw lines.fault("here must be one of facet, outer loop, vertex, endloop, endfacet, solid, endsolid, but is " + FormatFault.quoted(lines.text()));
            }
        }
        if (isWithin) {
            throw lines.fault("the file ends within a triangle");
        }
    }

    private static double coordinate(TextLines lines, String what) throws IOException {
        double value = lines.nextNumber(what);
        if (!(Math.abs(value) <= Float.MAX_VALUE)) {
            throw lines.fault(what + " must be within ±3.4e38, but is " + FormatFault.quoted(lines.text()));
        }
        return value;
    }
}
