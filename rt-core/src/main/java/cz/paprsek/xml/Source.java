package cz.paprsek.xml;

import cz.paprsek.xml.quick.Unusual;
import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * The bytes of one file for both readers, opened once: a pipe can be read once only, and a file may be replaced between two openings. What is
 * handed out closes nothing: a parser closes what it was given where the document ends, and there may be more to come.
 */
abstract class Source implements Closeable {
    /** How much of what cannot be read twice is kept for the second reader, in bytes; of a file beyond that, the first one is not asked. */
    private static final int MOST_KEPT = 1 << 27;

    /** A file of any kind, also a pipe or one within an archive. */
    static Source of(Path file) throws IOException {
        return Files.isRegularFile(file) ? new Rewound(Files.newByteChannel(file)) : new Kept(Files.newInputStream(file));
    }

    /** A stream that somebody else closes. */
    static Source of(InputStream input) {
        return new Kept(new Unclosable(input));
    }

    /** Bytes that are in memory already. */
    static Source of(byte[] bytes) {
        return new Held(bytes);
    }

    /** All bytes from the first one on; to be asked for twice at most, and the first stream is not read any more after that. */
    abstract InputStream fromStart() throws IOException;

    /** The same once more, when both are done with; empty if it cannot be had again. */
    Optional<InputStream> again() throws IOException {
        return Optional.of(fromStart());
    }

    /** How many bytes there are; 0 if that is not known. */
    abstract long size() throws IOException;

    private static final class Rewound extends Source {
        private final SeekableByteChannel channel;

        Rewound(SeekableByteChannel channel) {
            this.channel = channel;
        }

        @Override
        InputStream fromStart() throws IOException {
            channel.position(0);
            return new Unclosable(Channels.newInputStream(channel));
        }

        @Override
        long size() throws IOException {
            return channel.size();
        }

        @Override
        public void close() throws IOException {
            channel.close();
        }
    }

    private static final class Held extends Source {
        private final byte[] bytes;

        Held(byte[] bytes) {
            this.bytes = bytes;
        }

        @Override
        InputStream fromStart() {
            return new ByteArrayInputStream(bytes);
        }

        @Override
        long size() {
            return bytes.length;
        }

        @Override
        public void close() {
            // There is nothing open.
        }
    }

    private static final class Kept extends Source {
        private final InputStream input;
        private final List<byte[]> pieces = new ArrayList<>();
        private boolean isSecond;
        private int size;

        Kept(InputStream input) {
            this.input = input;
        }

        @Override
        InputStream fromStart() {
            boolean first = !isSecond;
            isSecond = true;
            return first ? new Keeping(true) : new Unclosable(new SequenceInputStream(kept(), new Keeping(false)));
        }

        @Override
        Optional<InputStream> again() {
            return size > MOST_KEPT ? Optional.empty() : Optional.of(kept());
        }

        private InputStream kept() {
            return new SequenceInputStream(Collections.enumeration(pieces.stream().<InputStream>map(ByteArrayInputStream::new).toList()));
        }

        @Override
        long size() {
            return 0;
        }

        @Override
        public void close() throws IOException {
            input.close();
        }

        private final class Keeping extends InputStream {
            private final boolean isFirst;

            Keeping(boolean isFirst) {
                this.isFirst = isFirst;
            }

            @Override
            public int read() throws IOException {
                byte[] one = new byte[1];
                return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
            }

            @Override
            public int read(byte[] into, int offset, int length) throws IOException {
                if (isFirst && size > MOST_KEPT) {
                    throw new Unusual();
                }
                int read = input.read(into, offset, length);
                if (read > 0 && size <= MOST_KEPT) {
                    pieces.add(Arrays.copyOfRange(into, offset, offset + read));
                    size += read;
                }
                return read;
            }
        }
    }

    private static final class Unclosable extends FilterInputStream {
        Unclosable(InputStream input) {
            super(input);
        }

        /** Java asks a pipe for its place to answer that, and fails. */
        @Override
        public int available() {
            return 0;
        }

        @Override
        public void close() {
            // That is for whoever opened it.
        }
    }
}
