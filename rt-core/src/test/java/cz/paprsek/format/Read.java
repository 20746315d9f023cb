package cz.paprsek.format;

import cz.paprsek.format.model.Companions;
import cz.paprsek.format.model.Model;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;

/** Files made of texts and bytes, as they are read. */
final class Read {
    private Read() {}

    static Model text(ForeignFormat format, String text) throws IOException {
        return bytes(format, text.getBytes(StandardCharsets.UTF_8));
    }

    static Model bytes(ForeignFormat format, byte[] bytes) throws IOException {
        return bytes(format, bytes, Map.of());
    }

    static Model bytes(ForeignFormat format, byte[] bytes, Map<String, byte[]> beside) throws IOException {
        return ForeignFiles.model("x." + format.endings().get(0), format, new ByteArrayInputStream(bytes), bytes.length, companions(beside));
    }

    static Companions companions(Map<String, byte[]> beside) {
        return name -> {
            byte[] found = beside.get(name);
            if (found == null) {
                throw new IOException('"' + name + "\": there is no such file beside the scene");
            }
            return ByteBuffer.wrap(found);
        };
    }

    /** What is said of a file that is wrong. */
    static String fault(ForeignFormat format, byte[] bytes) {
        try {
            bytes(format, bytes);
            throw new AssertionError("this file was read");
        } catch (IOException e) {
            return String.valueOf(e.getMessage());
        }
    }

    static String fault(ForeignFormat format, String text) {
        return fault(format, text.getBytes(StandardCharsets.UTF_8));
    }

    static byte[] part(byte[] bytes, int from, int to) {
        return Arrays.copyOfRange(bytes, from, to);
    }
}
