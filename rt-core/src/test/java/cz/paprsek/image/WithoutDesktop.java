package cz.paprsek.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** Writes and reads pictures of all formats that are our own, in a process that has no AWT. */
final class WithoutDesktop {
    static final List<String> NAMES = List.of("a.png", "a.ppm", "a.ppm16", "a.pgm", "a.pfm", "a.txt", "a.lum", "a.hdr", "a.exr");

    private WithoutDesktop() {}

    public static void main(String[] folder) throws IOException {
        if (ModuleLayer.boot().findModule("java.desktop").isPresent()) {
            throw new IllegalStateException("this process has a desktop");
        }
        for (String name : NAMES) {
            Path file = Path.of(folder[0], name);
            ImageFiles.write(new Image(40, 30), file);
            ImageFiles.read(file);
        }
    }
}
