package cz.paprsek.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Small scene files for the tests. */
public final class Scenes {
    private Scenes() {}

    /** A lit ball, 16 × 8 pixels. */
    public static Path ball(Path file) throws IOException {
        return scene(file, "<point-light position=\"2 3 4\"/><sphere radius=\"1\" position=\"0 1 0\"/>");
    }

    public static Path scene(Path file, String content) throws IOException {
        return Files.writeString(file, "<scene xmlns=\"urn:paprsek:scene:1\" name=\"ball\"><render width=\"16\" height=\"8\"/>"
                + "<camera position=\"0 1 5\" direction=\"0 0 -1\"/>" + content + "</scene>");
    }

    public static Path broken(Path file) throws IOException {
        return scene(file, "\n<sphere radius=\"-2\"/>\n<sphere raduis=\"1\"/>");
    }
}
