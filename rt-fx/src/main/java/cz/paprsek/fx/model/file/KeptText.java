package cz.paprsek.fx.model.file;

import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.SceneFile;
import java.util.Optional;

/**
 * The text that a scene has where it is kept, which later saves start from.
 *
 * @param file of a scene with a file of its own
 * @param database of a scene in a database, once it was saved there
 */
public record KeptText(Optional<SceneFile> file, Optional<DatabaseFile> database) {
    public static final KeptText NONE = new KeptText(Optional.empty(), Optional.empty());

    public static KeptText of(SceneFile file) {
        return new KeptText(Optional.of(file), Optional.empty());
    }

    public static KeptText of(DatabaseFile database) {
        return new KeptText(Optional.empty(), Optional.of(database));
    }
}
