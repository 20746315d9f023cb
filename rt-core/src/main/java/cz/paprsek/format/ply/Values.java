package cz.paprsek.format.ply;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.TextLines;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** The numbers of a file one after the other, as text or as bytes. */
abstract class Values {
    /** The next number. It may be none (NaN). */
    abstract double next(Property.Kind kind) throws IOException;

    /** What to throw of the number that was read last. */
    abstract FormatFault fault(String sentence);

    /** What to throw if there is no more. */
    abstract FormatFault ended(String sentence);

    static Values text(TextLines lines) {
        return new Words(lines);
    }

    /** @param before how many bytes there were before */
    static Values bytes(InputStream input, boolean isLittle, long before) {
        return new Bytes(input, isLittle ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN, before);
    }

    private static final class Words extends Values {
        private final TextLines lines;

        Words(TextLines lines) {
            this.lines = lines;
        }

        @Override
        double next(Property.Kind kind) throws IOException {
            while (!lines.beginWord()) {
                if (!lines.next()) {
                    throw new EOFException();
                }
            }
            int first = lines.ahead(0);
            int letter = (first == '-' ? lines.ahead(1) : first) | 32;
            if (letter == 'n' && lines.word() && (lines.is("nan") || lines.is("-nan"))) {
                return Double.NaN;
            }
            return letter == 'n' ? lines.number("a property") : lines.nextNumber("a property");
        }

        @Override
        FormatFault fault(String sentence) {
            return lines.fault(sentence);
        }

        @Override
        FormatFault ended(String sentence) {
            return lines.fault(sentence);
        }
    }

    private static final class Bytes extends Values {
        private final InputStream input;
        private final ByteBuffer buffer;
        private long before;

        Bytes(InputStream input, ByteOrder order, long before) {
            this.input = input;
            this.before = before;
            buffer = ByteBuffer.allocate(1 << 16).order(order).limit(0);
        }

        @Override
        double next(Property.Kind kind) throws IOException {
            if (buffer.remaining() < kind.bytes) {
                refill(kind.bytes);
            }
            return switch (kind) {
                case CHAR -> buffer.get();
                case UCHAR -> buffer.get() & 0xFF;
                case SHORT -> buffer.getShort();
                case USHORT -> buffer.getShort() & 0xFFFF;
                case INT -> buffer.getInt();
                case UINT -> buffer.getInt() & 0xFFFFFFFFL;
                case FLOAT -> buffer.getFloat();
                case DOUBLE -> buffer.getDouble();
            };
        }

        private void refill(int wanted) throws IOException {
            before += buffer.position();
            buffer.compact();
            int got = input.readNBytes(buffer.array(), buffer.position(), buffer.remaining());
            buffer.limit(buffer.position() + got).position(0);
            if (buffer.remaining() < wanted) {
                throw new EOFException();
            }
        }

        @Override
        FormatFault fault(String sentence) {
            return FormatFault.at(before + buffer.position(), sentence);
        }

        @Override
        FormatFault ended(String sentence) {
            return FormatFault.at(before + buffer.limit(), sentence);
        }
    }
}
