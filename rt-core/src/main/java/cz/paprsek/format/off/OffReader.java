package cz.paprsek.format.off;

import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.Faces;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.model.TextLines;
import java.io.IOException;
import java.io.InputStream;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads OFF: how many vertices and faces there are, and a line for each. Letters before the first word, from its end on, say what a vertex has after its place: {@code N} a normal, {@code C} a
 * colour; Geomview writes {@code CNOFF}, MeshLab {@code NCOFF}. Colours are sRGB, with a point in one of their numbers from 0 to 1, else from 0 to 255.
 *
 * @source Phillips, Levy and Munzner, Geomview Manual, version 1.9.4, 2007, OFF Files
 */
public final class OffReader {
    private static final Convention CONVENTION = new Convention("", false);
    private static final Pattern FIRST = Pattern.compile("(C|N|CN|NC|)OFF(\\d{0,10})");
    private static final int MOST_CORNERS = 1_000_000;
    /** How many bytes the line of a vertex has at least, and that of a face. */
    private static final int VERTEX = 6;
    private static final int FACE = 4;

    private final TextLines lines;
    private final long size;
    private final Notes notes = new Notes();
    private final Faces faces = new Faces();
    /** What stands at the end of a line, and whether it has a point. */
    private final double[] row = new double[7];
    private final boolean[] hasPoint = new boolean[row.length];

    private OffReader(TextLines lines, long size) {
        this.lines = lines;
        this.size = size;
    }

    /** @param size how many bytes there are; {@link Long#MAX_VALUE} if nobody knows */
    public static Model read(InputStream input, long size) throws IOException {
        return new OffReader(new TextLines(input, false), size).read();
    }

    private Model read() throws IOException {
        Matcher first = FIRST.matcher(next() ? lines.text() : "");
        if (!first.matches() || lines.rest().startsWith("BINARY")) {
            throw lines.fault("an OFF file that is text, and of three dimensions, begins with \"OFF\", or with \"C\" and \"N\" before it");
        }
        boolean isNormalFirst = first.group(1).endsWith("N");
        boolean hasNormals = first.group(1).contains("N");
        boolean isColored = first.group(1).contains("C");
        // Some programs write no blank before the first number.
        long vertices = first.group(2).isEmpty() ? count("vertices", VERTEX) : bounded(Long.parseLong(first.group(2)), "vertices", VERTEX);
        long count = count("faces", FACE);
        lines.next();
        for (long i = 0; i < vertices; i++) {
            line(i, vertices, "vertices");
            vertex(hasNormals, isColored, isNormalFirst);
        }
        for (long i = 0; i < count; i++) {
            line(i, count, "faces");
            face(vertices);
        }
        return Model.of(faces.build(), CONVENTION, notes);
    }

    /** Goes to the next word, past remarks; false if there is none. */
    private boolean next() throws IOException {
        while (lines.wordAnywhere()) {
            if (lines.letter(0) != '#') {
                return true;
            }
            if (!lines.next()) {
                return false;
            }
        }
        return false;
    }

    private long count(String what, int least) throws IOException {
        if (!next()) {
            throw FormatFault.in("the end", "the number of " + what + " is missing");
        }
        return bounded(lines.whole("the number of " + what), what, least);
    }

    private long bounded(long count, String what, int least) throws IOException {
        if (count < 0 || (size != Long.MAX_VALUE && count > size / least + 1)) {
            throw lines.fault("the file says it has " + count + " " + what + ", but is only " + size + " bytes long");
        }
        return count;
    }

    /** Goes to the first word of the next line that has any. */
    private void line(long done, long of, String what) throws IOException {
        if (!next()) {
            throw FormatFault.in("the end", "here are " + done + " of " + of + " " + what);
        }
    }

    private void vertex(boolean hasNormal, boolean isColored, boolean isNormalFirst) throws IOException {
        faces.places().add(within(lines.number("x of a vertex"), "x"));
        faces.places().add(within(lines.nextNumber("y of a vertex"), "y"));
        faces.places().add(within(lines.nextNumber("z of a vertex"), "z"));
        int more = rest("what follows the place of a vertex");
        int channels = more - (hasNormal ? 3 : 0);
        if (channels < 0 || (isColored && channels != 3 && channels != 4)) {
            throw lines.fault("a vertex must have " + (!isColored ? "3" : hasNormal ? "6 or 7" : "3 or 4") + " numbers after its place, but has " + more);
        }
        if (hasNormal) {
            int at = isNormalFirst ? 0 : channels;
            for (int k = 0; k < 3; k++) {
                faces.normals().add(Math.abs(row[at + k]) <= Float.MAX_VALUE ? row[at + k] : 0);
            }
        }
        if (isColored) {
            int at = isNormalFirst ? 3 : 0;
            double white = white(at, channels);
            for (int k = 0; k < 3; k++) {
                faces.vertexColor(white * row[at + k]);
            }
        } else if (channels > 0) {
            notes.line(lines.line(), "numbers after a vertex of which the first line does not tell are not read");
        }
        lines.next();
    }

    private double within(double value, String axis) throws IOException {
        if (!(Math.abs(value) <= Float.MAX_VALUE)) {
            throw lines.fault(axis + " of a vertex must be within ±3.4e38, but is " + FormatFault.quoted(lines.text()));
        }
        return value;
    }

    private void face(long vertices) throws IOException {
        long count = lines.whole("the number of corners");
        if (count < 1 || count > MOST_CORNERS) {
            throw lines.fault("a face has from 1 to " + MOST_CORNERS + " corners, but this one has " + count);
        }
        if (count < 3) {
            notes.line(lines.line(), "faces of less than three corners are not read");
            lines.next();
            return;
        }
        faces.face((int) count);
        for (long i = 0; i < count; i++) {
            if (!lines.word()) {
                throw lines.fault("a face of " + count + " corners needs as many numbers of vertices, but has " + i);
            }
            long vertex = lines.whole("a corner");
            if (vertex < 0 || vertex >= vertices) {
                throw lines.fault("a corner is vertex " + vertex + ", but vertices have numbers from 0 to " + (vertices - 1));
            }
            faces.corner((int) vertex);
        }
        int channels = rest("the colour of a face");
        if (channels == 3 || channels == 4) {
            double white = white(0, channels);
            faces.faceColor(white * row[0], white * row[1], white * row[2]);
        } else if (channels > 0) {
            notes.line(lines.line(), "colours of faces by their number in a table are not read");
        }
        lines.next();
    }

    /** Reads what is left of the line, up to a remark: how many numbers. */
    private int rest(String what) throws IOException {
        int count = 0;
        while (count < row.length && lines.beginWord() && lines.ahead(0) != '#') {
            row[count] = lines.nextNumber(what);
            hasPoint[count] = false;
            for (int i = 0; i < lines.length(); i++) {
                hasPoint[count] |= lines.letter(i) == '.';
            }
            count++;
        }
        return count;
    }

    /** What a channel is multiplied with, so that white is 255; the fourth is opacity. */
    private double white(int from, int channels) {
        for (int i = from; i < from + channels; i++) {
            if (hasPoint[i]) {
                return 255;
            }
        }
        return 1;
    }
}
