package cz.paprsek.format.obj;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Transcoded;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Iterator;
import java.util.Optional;
import java.util.concurrent.ForkJoinPool;

/** A file in blocks of whole lines, some of which other threads read ahead while the first is made use of. */
final class Blocks {
    private static final int SIZE = 1 << 18;
    private static final int LARGEST = 1 << 28;
    private static final int AHEAD = 6;
    /** For a line end that is missing, and what is to be behind it. */
    private static final int ROOM = 1 + Block.PADDING;

    private final InputStream input;
    private final Deque<Block> ahead = new ArrayDeque<>();
    /** Those that have been made use of, to be filled again. */
    private final Deque<Block> spare = new ArrayDeque<>();
    /** What has been read of the block that comes next. */
    private byte[] rest = {};
    private boolean isEnded;

    Blocks(InputStream input) throws IOException {
        this.input = Transcoded.utf8(input);
    }

    /** The next block, which has been read; nothing at the end. The one before is no longer to be used. */
    Optional<Block> next() throws IOException {
        while (!isEnded && ahead.size() < AHEAD) {
            cut().ifPresent(block -> {
                if (!ahead.isEmpty()) {
                    ForkJoinPool.commonPool().execute(block::readUnlessClaimed);
                }
                ahead.add(block);
            });
        }
        Block head = ahead.peek();
        if (head == null) {
            return Optional.empty();
        }
        if (!head.readUnlessClaimed()) {
            // While another thread reads the first, this one reads the next that nobody does.
            for (Iterator<Block> others = ahead.iterator(); others.hasNext() && !head.isRead();) {
                others.next().readUnlessClaimed();
            }
            head.await();
        }
        spare.add(ahead.remove());
        return Optional.of(head);
    }

    /** A block to be filled: the one that was handed out last is in use. */
    private Block empty() {
        return spare.size() > 1 ? spare.remove() : new Block(new byte[SIZE]);
    }

    private Optional<Block> cut() throws IOException {
        Block block = empty();
        byte[] bytes = block.bytes();
        if (bytes.length < 2 * rest.length) {
            bytes = new byte[2 * rest.length];
        }
        System.arraycopy(rest, 0, bytes, 0, rest.length);
        int filled = rest.length;
        while (true) {
            int more = input.readNBytes(bytes, filled, bytes.length - filled - ROOM);
            filled += more;
            if (filled < bytes.length - ROOM) {
                isEnded = true;
                rest = new byte[0];
                return filled == 0 ? Optional.empty() : Optional.of(last(block, bytes, filled));
            }
            int end = lastEnd(bytes, filled);
            if (end > 0) {
                rest = Arrays.copyOfRange(bytes, end, filled);
                return Optional.of(filled(block, bytes, end));
            }
            if (filled > LARGEST) {
                throw FormatFault.in("a line", "is longer than " + LARGEST + " bytes");
            }
            bytes = Arrays.copyOf(bytes, 2 * bytes.length);
        }
    }

    private static Block last(Block block, byte[] bytes, int filled) {
        boolean isWhole = bytes[filled - 1] == '\n' || bytes[filled - 1] == '\r';
        bytes[filled] = '\n';
        return filled(block, bytes, isWhole ? filled : filled + 1);
    }

    private static Block filled(Block block, byte[] bytes, int length) {
        Arrays.fill(bytes, length, length + Block.PADDING, (byte) 0);
        block.fill(bytes, length);
        return block;
    }

    /** Behind the last line that is whole for sure, and not joined with the next; 0 if there is none. */
    private static int lastEnd(byte[] bytes, int filled) {
        for (int i = filled - 2; i > 0; i--) {
            boolean isEnd = bytes[i] == '\n' || (bytes[i] == '\r' && bytes[i + 1] != '\n');
            int before = bytes[i] == '\n' && bytes[i - 1] == '\r' ? i - 2 : i - 1;
            if (isEnd && (before < 0 || bytes[before] != '\\')) {
                return i + 1;
            }
        }
        return 0;
    }
}
