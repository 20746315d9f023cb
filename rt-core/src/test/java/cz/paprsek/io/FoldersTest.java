package cz.paprsek.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FoldersTest {
    @TempDir
    private Path folder;

    @Test
    void aLinkToAFolderIsOne() throws IOException {
        Path link = link("link", Files.createDirectory(folder.resolve("real")));
        Folders.make(link);
        Folders.makeFor(link.resolve("below/file"));
        assertThat(folder.resolve("real/below")).isDirectory();
    }

    /** Not the folder below it, which is not there. */
    @Test
    void aLinkThatLeadsNowhereIsNamed() throws IOException {
        Path link = link("link", folder.resolve("nowhere"));
        for (Path wanted : new Path[] {link, link.resolve("below"), link.resolve("far/below")}) {
            assertThatThrownBy(() -> Folders.make(wanted)).isInstanceOf(IOException.class).hasMessage(link + " is not a directory, so nothing can be written there");
        }
    }

    private Path link(String name, Path to) throws IOException {
        try {
            return Files.createSymbolicLink(folder.resolve(name), to);
        } catch (IOException | UnsupportedOperationException refused) {
            assumeTrue(false, "links cannot be made here: " + refused);
            throw refused;
        }
    }
}
