package cz.paprsek.format.obj;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Transcoded;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.ForkJoinPool;

/** A file in blocks of whole lines, some of which other threads read ahead while the first is made use of. */
final class Blocks {
    private static final int SIZE = 1 << 20;
    private static final int LARGEST = 1 << 28;
    private static final int AHEAD = 6;
    /** For a line end that is missing, and what is to be behind it. */
    private static final int ROOM = 1 + Block.PADDING;

    private final InputStream input;
    private final Deque<Block> ahead = new ArrayDeque<>();
    /** What has been read of the block that comes next. */
    private byte[] rest = {};
    private boolean isEnded;

    Blocks(InputStream input) throws IOException {
        this.input = Transcoded.utf8(input);
    }

    /** The next block, which has been read; nothing at the end. */
    Optional<Block> next() throws IOException {
        while (!isEnded && ahead.size() < AHEAD) {
            cut().ifPresent(block -> {
                if (!ahead.isEmpty()) {
                    ForkJoinPool.commonPool().execute(block::read);
                }
                ahead.add(block);
            });
        }
        Optional<Block> head = Optional.ofNullable(ahead.poll());
        head.ifPresent(Block::read);
        return head;
    }

    private Optional<Block> cut() throws IOException {
        byte[] bytes = Arrays.copyOf(rest, Math.max(SIZE, 2 * rest.length));
        int filled = rest.length;
        while (true) {
            int more = input.readNBytes(bytes, filled, bytes.length - filled - ROOM);
            filled += more;
            if (filled < bytes.length - ROOM) {
                isEnded = true;
                rest = new byte[0];
                return filled == 0 ? Optional.empty() : Optional.of(last(bytes, filled));
            }
            int end = lastEnd(bytes, filled);
            if (end > 0) {
                rest = Arrays.copyOfRange(bytes, end, filled);
                return Optional.of(block(bytes, end));
            }
            if (filled > LARGEST) {
                throw FormatFault.in("a line", "is longer than " + LARGEST + " bytes");
            }
            bytes = Arrays.copyOf(bytes, 2 * bytes.length);
        }
    }

    private static Block last(byte[] bytes, int filled) {
        boolean isWhole = bytes[filled - 1] == '\n' || bytes[filled - 1] == '\r';
        bytes[filled] = '\n';
        return block(bytes, isWhole ? filled : filled + 1);
    }

    private static Block block(byte[] bytes, int length) {
        Arrays.fill(bytes, length, length + Block.PADDING, (byte) 0);
        return new Block(bytes, length);
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
