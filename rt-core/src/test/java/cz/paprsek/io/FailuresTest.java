package cz.paprsek.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.ClosedChannelException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Map;
import java.util.zip.ZipException;
import org.junit.jupiter.api.Test;

/** Sentences of failures that say nothing, or only a name. */
class FailuresTest {
    @Test
    void everyFailureHasASentence() {
        Map<Throwable, String> sentences = Map.of(
                new ClosedChannelException(), "the file was closed while it was in use",
                new EOFException(), "the file is cut off",
                new IOException(), "it cannot be read or written",
                new IOException(" "), "it cannot be read or written",
                new ZipException(), "zip",
                new NoSuchFileException("a.xml"), "a.xml: no such file",
                new AccessDeniedException("a.xml"), "a.xml: permission denied",
                new FileSystemException("a.xml", null, "No space left on device"), "a.xml: no space left on device",
                new UncheckedIOException(new ClosedChannelException()), "the file was closed while it was in use",
                new OutOfMemoryError(), "out of memory");
        sentences.forEach((failure, sentence) -> assertThat(Failures.sentence(failure)).isEqualTo(sentence));
    }

    @Test
    void theFileIsNamedOnce() {
        assertThat(Failures.sentence("b.xml", new ClosedChannelException())).isEqualTo("b.xml: the file was closed while it was in use");
        assertThat(Failures.sentence("b.xml", new IOException("b.xml: it is odd"))).isEqualTo("b.xml: it is odd");
        assertThat(Failures.sentence("b.xml", new NoSuchFileException("b.xml"))).isEqualTo("b.xml: no such file");
    }
}
