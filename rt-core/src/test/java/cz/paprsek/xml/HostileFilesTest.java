package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Files that mean harm: each is refused in one line, in a moment, whatever follows in it; nothing is fetched. */
class HostileFilesTest {
    private static final String HEAD = "<scene xmlns='urn:paprsek:scene:1'>\n<camera position='0 1 5' direction='0 0 -1'/>\n";
    private static final long HUGE = 300_000_000;

    static Stream<Arguments> endless() {
        return Stream.of(
                Arguments.of("levels", HEAD, "<union>", ": elements must not be nested deeper than 250"),
                Arguments.of("value of an attribute", HEAD + "<sphere radius='1' name='", "x", "3:1: from here on, a comment, value or name is longer than"),
                Arguments.of("number", HEAD + "<sphere radius='", "1", "3:1: from here on, a comment, value or name is longer than"),
                Arguments.of("attributes", HEAD + "<sphere", " a='1'", "3:"),
                Arguments.of("namespaces", HEAD + "<sphere", " xmlns:a='1'", "3:"),
                Arguments.of("name", HEAD + "<", "x", ": here is a name of more than 1000 characters"),
                Arguments.of("comment", HEAD + "<!--", "x>", "3:1: from here on, a comment, value or name is longer than"),
                Arguments.of("processing instruction", HEAD + "<?p ", "x", "3:1: from here on, a comment, value or name is longer than"),
                Arguments.of("text", HEAD + "<description>", "x", "3:1: a description must not be longer than 100000 characters"),
                Arguments.of("unmarked text", HEAD + "<description><![CDATA[", "x", "3:14: from here on, a comment, value or name is longer than"),
                Arguments.of("mark out of place", HEAD + "\uFEFF", "1", "3:1: "),
                Arguments.of("text out of place", HEAD + "x", "x", "3:1: "));
    }

    /** Three hundred megabytes of each would follow; the whole of it must never be kept, nor waited for: whoever writes into a pipe is hung up on. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("endless")
    void whatHasNoEndIsRefused(String what, String start, String again, String sentence) {
        byte[] beginning = start.getBytes(StandardCharsets.UTF_8);
        for (WayIn way : WayIn.ofStreams()) {
            Repeated rest = new Repeated(again);
            assertTimeoutPreemptively(Duration.ofSeconds(20), () ->
                    assertThat(way.problems(() -> new SequenceInputStream(new ByteArrayInputStream(beginning), rest))).as("%s", way)
                            .hasSizeBetween(1, 2).first().asString().contains(sentence));
            assertThat(rest.at).as("%s hangs up", way).isLessThan(HUGE / 8);
        }
    }

    static Stream<Arguments> references() {
        return Stream.of(
                Arguments.of("<!DOCTYPE scene SYSTEM '%s'><scene/>", "a DOCTYPE is not allowed"),
                Arguments.of("<!DOCTYPE scene [<!ENTITY x SYSTEM '%s'>]>" + HEAD + "<description>&x;</description></scene>", "a DOCTYPE is not allowed"),
                Arguments.of("<!DOCTYPE scene [<!ENTITY %% x SYSTEM '%s'> %%x;]>" + HEAD + "</scene>", "a DOCTYPE is not allowed"),
                Arguments.of("<!DOCTYPE a [<!ENTITY b 'bb'><!ENTITY c '&b;&b;&b;&b;'><!ENTITY d '&c;&c;&c;&c;'>]><a>&d;</a>", "a DOCTYPE is not allowed"),
                Arguments.of(HEAD + "<xi:include xmlns:xi='http://www.w3.org/2001/XInclude' href='%s'/></scene>", "include"),
                Arguments.of(HEAD.replace(">\n<c", " xmlns:x='http://www.w3.org/2001/XMLSchema-instance' x:schemaLocation='urn:y %1$s'>\n<c")
                        + "<a xmlns='urn:y'/></scene>", "3:1"),
                Arguments.of("<?xml-stylesheet href='%s'?><a/>", "a scene file starts with"));
    }

    @ParameterizedTest
    @MethodSource("references")
    void nothingIsFetched(String text, String sentence, @TempDir Path folder) throws IOException {
        Path bait = Files.writeString(folder.resolve("bait"), "the bait was taken");
        try (ServerSocket server = new ServerSocket(0, 9, InetAddress.getLoopbackAddress())) {
            server.setSoTimeout(1);
            for (String address : List.of("http://127.0.0.1:" + server.getLocalPort() + "/x", bait.toUri().toString())) {
                assertThat(WayIn.all(String.format(text, address)).problems()).hasSize(1).first().asString().contains(sentence).doesNotContain("bait was");
            }
            assertThat(catchThrowableOfType(SocketTimeoutException.class, server::accept)).as("nobody calls").isNotNull();
        }
    }

    @Test
    void measurelessCountsAreRefused() throws IOException {
        assertThat(WayIn.all(HEAD + "<render width='1000000000' height='1000000000'/></scene>").problems()).hasSize(2)
                .allSatisfy(line -> assertThat(line).contains("from 1 to 32768"));
        assertThat(WayIn.all(HEAD + "<disc radius='1'><material><checkerboard columns='1000000000' rows='1'/></material></disc></scene>").problems())
                .hasSize(1).first().asString().contains("from 1 to 1000000");
    }

    /** A text again and again. */
    private static final class Repeated extends InputStream {
        private final byte[] text;
        private volatile long at;

        Repeated(String text) {
            this.text = text.getBytes(StandardCharsets.UTF_8);
        }

        @Override
        public int read() {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 255;
        }

        @Override
        public int read(byte[] into, int offset, int length) {
            long from = at;
            int size = (int) Math.min(length, HUGE - from);
            for (int i = 0; i < size; i++) {
                into[offset + i] = text[(int) ((from + i) % text.length)];
            }
            at = from + size;
            return size == 0 && length > 0 ? -1 : size;
        }
    }
}
