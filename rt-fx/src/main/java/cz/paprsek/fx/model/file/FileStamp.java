package cz.paprsek.fx.model.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Optional;

/** By what a file's change is noticed without reading it. */
public record FileStamp(long modifiedMillis, long size) {

    /** Empty if there is no such file, or none that can be looked at. */
    public static Optional<FileStamp> of(Path file) {
        try {
            BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
            return Optional.of(new FileStamp(attributes.lastModifiedTime().toMillis(), attributes.size()));
        } catch (IOException gone) {
            return Optional.empty();
        }
    }
}
