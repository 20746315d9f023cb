package cz.paprsek.format.off;

import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.Doubles;
import cz.paprsek.format.model.Faces;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Ints;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.model.TextLines;
import java.io.IOException;
import java.io.InputStream;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads OFF: how many vertices and faces there are, and a line for each. Letters before the first word, from its end on, say what a vertex has after its place: {@code N} a normal, {@code C} a
 * colour; Geomview writes {@code CNOFF}, MeshLab {@code NCOFF}; {@code ST} is a place in a picture, after both. Colours are sRGB. Those of all vertices are from 0 to 1 if one of them has a point or
 * an exponent, or none is above 1; else from 0 to 255. A face's are so by itself; what has only zeros and ones is as the other faces are.
 *
 * @source Phillips, Levy and Munzner, Geomview Manual, version 1.9.4, 2007, OFF Files
 */
public final class OffReader {
    private static final Convention CONVENTION = new Convention("", false);
    private static final Pattern FIRST = Pattern.compile("(?:ST)?(C|N|CN|NC|)(?:ST)?OFF(\\d{0,10})");
    private static final int MOST_CORNERS = 1_000_000;
    /** How many bytes the line of a vertex has at least, and that of a face. */
    private static final int VERTEX = 6;
    private static final int FACE = 4;

    private final TextLines lines;
    private final long size;
    private final Notes notes = new Notes();
    private final Faces faces = new Faces();
    /** Of the vertices, as they are in the file, until all are known. */
    private final Doubles vertexColors = new Doubles();
    private final Scale vertexScale = new Scale();
    /** Which faces have colours; which, as they are in the file; and what they are multiplied with, 0 if only the other faces tell. */
    private final Ints coloredFaces = new Ints();
    private final Doubles faceColors = new Doubles();
    private final Scale faceScale = new Scale();
    /** What stands at the end of a line, and whether it has a point or an exponent. */
    private final double[] row = new double[9];
    private final boolean[] isReal = new boolean[row.length];
    /** Whether the first word of a line was looked at and is still to be read. */
    private boolean isBegun;

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
            throw lines.fault("an OFF file that is text, and of three dimensions, begins with \"OFF\", or with \"C\", \"N\" and \"ST\" before it, but here is "
                    + FormatFault.quoted(lines.rest().startsWith("BINARY") ? lines.text() + " BINARY" : lines.text()));
        }
        boolean isMapped = first.group().contains("ST");
        boolean isNormalFirst = first.group(1).endsWith("N");
        boolean hasNormals = first.group(1).contains("N");
        boolean isColored = first.group(1).contains("C");
        // Some programs write no blank before the first number.
        long vertices = first.group(2).isEmpty() ? count("vertices", VERTEX) : bounded(Long.parseLong(first.group(2)), "vertices", VERTEX);
        long count = count("faces", FACE);
        edges();
        for (long i = 0; i < vertices; i++) {
            line(i, vertices, "vertices");
            vertex(hasNormals, isColored, isNormalFirst, isMapped);
        }
        for (long i = 0; i < count; i++) {
            line(i, count, "faces");
            face(vertices);
        }
        colors();
        return Model.of(faces.build(notes), CONVENTION, notes);
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

    /** Goes past the number of edges, of which nothing depends: after those of vertices and faces, or alone in the next line, or nowhere. */
    private void edges() throws IOException {
        boolean isHere = isMore();
        lines.next();
        if (!isHere && next()) {
            isBegun = !lines.rest().isEmpty() && !lines.rest().startsWith("#");
            if (!isBegun) {
                lines.next();
            }
        }
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
        if (!isBegun && !next()) {
            throw FormatFault.in("the end", "here are " + done + " of " + of + " " + what + "; each must be a line");
        }
        isBegun = false;
    }

    private void vertex(boolean hasNormal, boolean isColored, boolean isNormalFirst, boolean isMapped) throws IOException {
        faces.places().add(within(lines.number("x of a vertex"), "x"));
        faces.places().add(coordinate("y"));
        faces.places().add(coordinate("z"));
        int more = rest("what follows the place of a vertex");
        int others = (hasNormal ? 3 : 0) + (isMapped ? 2 : 0);
        int channels = more - others;
        if (channels < 0 || (isColored && channels != 3 && channels != 4)) {
            throw lines.fault("a vertex must have " + (isColored ? others + 3 + " or " + (others + 4) : others) + " numbers after its place, but has " + more);
        }
        if (hasNormal) {
            int at = isNormalFirst ? 0 : channels;
            for (int k = 0; k < 3; k++) {
                faces.normals().add(Math.abs(row[at + k]) <= Float.MAX_VALUE ? row[at + k] : 0);
            }
        }
        if (isColored) {
            int at = isNormalFirst ? 3 : 0;
            keep(vertexColors, at);
            vertexScale.see(row, isReal, at, channels);
        } else if (channels > 0) {
            notes.line(lines.line(), "numbers after a vertex of which the first line does not tell are not read");
        }
        if (isMapped) {
            int at = (hasNormal ? 3 : 0) + (isColored ? channels : 0);
            faces.map().add(row[at]);
            faces.map().add(row[at + 1]);
        }
        lines.next();
    }

    private void keep(Doubles colors, int at) {
        for (int k = 0; k < 3; k++) {
            colors.add(row[at + k]);
        }
    }

    private double coordinate(String axis) throws IOException {
        if (!isMore()) {
            throw lines.fault(axis + " of a vertex is missing; each must be a line");
        }
        return within(lines.nextNumber(axis + " of a vertex"), axis);
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
            Scale own = new Scale();
            own.see(row, isReal, 0, channels);
            faceScale.see(row, isReal, 0, channels);
            coloredFaces.add(faces.count() - 1);
            keep(faceColors, 0);
            faceColors.add(own.isTold() ? own.white() : 0);
        } else if (channels > 0) {
            notes.line(lines.line(), "colours of faces by their number in a table are not read");
        }
        lines.next();
    }

    /** Reads what is left of the line, up to a remark: how many numbers. */
    private int rest(String what) throws IOException {
        int count = 0;
        while (count < row.length && isMore()) {
            row[count] = lines.nextNumber(what);
            isReal[count] = false;
            for (int i = 0; i < lines.length(); i++) {
                isReal[count] |= lines.letter(i) == '.' || lines.letter(i) >= 'A';
            }
            count++;
        }
        return count;
    }

    /** Whether there is another word in the line, before a remark. */
    private boolean isMore() {
        return lines.beginWord() && lines.ahead(0) != '#';
    }

    /** Gives the faces their colours, now that it is known what white is. */
    private void colors() {
        for (int i = 0; i < vertexColors.size(); i++) {
            faces.vertexColor(vertexScale.white() * vertexColors.get(i));
        }
        for (int i = 0; i < coloredFaces.size(); i++) {
            double own = faceColors.get(4 * i + 3);
            double white = own > 0 ? own : faceScale.white();
            faces.faceColor(coloredFaces.get(i), white * faceColors.get(4 * i), white * faceColors.get(4 * i + 1), white * faceColors.get(4 * i + 2));
        }
    }
}
