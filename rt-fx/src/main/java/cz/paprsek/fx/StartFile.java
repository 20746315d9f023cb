package cz.paprsek.fx;

import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Finds what to open at the start. */
final class StartFile {
    private static final String DATABASE = "database.xml";

    private StartFile() {}

    /** The file given, else a database in the working folder, else one beside the program. */
    static Optional<Path> find(List<String> arguments, Path workingFolder, Optional<Path> programFolder) {
        if (!arguments.isEmpty()) {
            return Optional.of(workingFolder.resolve(arguments.get(0)));
        }
        List<Path> places = new ArrayList<>();
        places.add(workingFolder.resolve(DATABASE));
        programFolder.ifPresent(folder -> places.add(folder.resolve(DATABASE)));
        return places.stream().filter(Files::isRegularFile).findFirst();
    }

    /** The folder of the program's jar. */
    static Optional<Path> programFolder() {
        CodeSource source = StartFile.class.getProtectionDomain().getCodeSource();
        if (source == null || source.getLocation() == null) {
            return Optional.empty();
        }
        try {
            return Optional.ofNullable(Path.of(source.getLocation().toURI()).getParent());
        } catch (URISyntaxException | java.nio.file.FileSystemNotFoundException | IllegalArgumentException notAFile) {
            return Optional.empty();
        }
    }
}
