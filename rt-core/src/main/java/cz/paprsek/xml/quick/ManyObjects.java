package cz.paprsek.xml.quick;

import cz.paprsek.scene.SceneObject;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Reads the objects of a long scene by several threads. The file is cut where it looks as it did before an object; whether there was one is known once
 * all before has been read up to there, and nothing is taken over that begins elsewhere.
 */
final class ManyObjects {
    /** So many are read before anything is cut. */
    static final int MANY = 1 << 14;
    /** In how many elements objects are that are cut apart, themselves included. */
    static final int DEPTH = 2;

    private static final int BLOCK = 1 << 18;
    private static final int BLOCKS_EACH = 8;
    private static final int MOST_BLOCKS = 64;

    private final InputStream input;
    private final MaterialReader known;
    private final byte[] text;
    private int end;

    private ManyObjects(InputStream input, MaterialReader known, int blocks) {
        this.input = input;
        this.known = known;
        text = new byte[blocks * BLOCK];
    }

    /**
     * Reads objects as far as they can be told apart so; what comes then is left to be read on.
     *
     * @param input from behind an object on
     * @param known knows materials that were read before
     */
    static InputStream read(InputStream input, MaterialReader known, List<SceneObject> into) throws IOException {
        int blocks = Math.min(MOST_BLOCKS, BLOCKS_EACH * Runtime.getRuntime().availableProcessors());
        return blocks == BLOCKS_EACH ? input : new ManyObjects(input, known, blocks).readInto(into);
    }

    private InputStream readInto(List<SceneObject> into) throws IOException {
        boolean isAllRead = fill(0);
        byte[] start = Arrays.copyOf(text, startLength());
        int from = 0;
        boolean goesOn = start.length > 0;
        while (goesOn) {
            int[] cuts = cuts(start);
            List<Optional<List<SceneObject>>> blocks = IntStream.range(0, cuts.length - 1).parallel().mapToObj(i -> block(cuts[i], cuts[i + 1])).toList();
            int good = 0;
            while (good < blocks.size() && blocks.get(good).isPresent()) {
                into.addAll(blocks.get(good++).get());
            }
            from = cuts[good];
            goesOn = good > 0 && good == blocks.size() && !isAllRead;
            if (goesOn) {
                System.arraycopy(text, from, text, 0, end - from);
                isAllRead = fill(end - from);
                from = 0;
            }
        }
        return new SequenceInputStream(new ByteArrayInputStream(text, from, end - from), input);
    }

    /** Fills what is left behind a place; whether that is all there is. Bit by bit: whoever watches may stop it. */
    private boolean fill(int from) throws IOException {
        end = from;
        int read = BLOCK;
        while (read == BLOCK && end < text.length) {
            read = input.readNBytes(text, end, Math.min(BLOCK, text.length - end));
            end += read;
        }
        return end < text.length;
    }

    /** How long blanks and start of tag are that come next; 0 for what is none, or as long as a block. */
    private int startLength() {
        int at = 0;
        while (at < end && Markup.isBlank(text[at])) {
            at++;
        }
        int name = at + 1;
        while (name < end && Markup.isOfName(text[name])) {
            name++;
        }
        return name < Math.min(end, BLOCK) && text[at] == '<' && name > at + 1 ? name : 0;
    }

    /** Where blocks begin and end: before what looks like the start, each behind as many bytes as a block has, or more. */
    private int[] cuts(byte[] start) {
        int[] cuts = new int[text.length / BLOCK + 1];
        int count = 1;
        for (int i = BLOCK; i < end - start.length; i++) {
            if (text[i] == start[start.length - 1] && text[i - start.length] == '>' && !Markup.isOfName(text[i + 1])
                    && Arrays.equals(text, i + 1 - start.length, i + 1, start, 0, start.length)) {
                cuts[count++] = i + 1 - start.length;
                i += BLOCK;
            }
        }
        return Arrays.copyOf(cuts, count);
    }

    /** What is between two places; empty unless that is objects and nothing else, the last of them whole. */
    private Optional<List<SceneObject>> block(int from, int to) {
        Markup markup = new Markup(text, from, to);
        double[] room = new double[3];
        ShapeReader shapes = new ShapeReader(markup, room, known.knowing(markup, room));
        List<SceneObject> found = new ArrayList<>();
        try {
            while (markup.isMoreLeft()) {
                Unusual.unless(markup.nextTag());
                found.add(shapes.object(DEPTH));
            }
            return Optional.of(found);
        } catch (IllegalArgumentException unusual) {
            return Optional.empty();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
