package cz.paprsek.fx.model.file;

import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.SceneFile;
import java.util.Optional;

/**
 * The text that a scene has where it is kept, which later saves start from.
 *
 * @param file of a scene with a file of its own
 * @param database of a scene in a database, once it was saved there
 * @param typed what somebody has written, if there is no such file
 */
public record KeptText(Optional<SceneFile> file, Optional<DatabaseFile> database, Optional<OriginalText> typed) {
    public static final KeptText NONE = new KeptText(Optional.empty(), Optional.empty(), Optional.empty());

    public static KeptText of(SceneFile file) {
        return new KeptText(Optional.of(file), Optional.empty(), Optional.empty());
    }

    public static KeptText of(DatabaseFile database) {
        return new KeptText(Optional.empty(), Optional.of(database), Optional.empty());
    }

    /** The text itself. */
    public Optional<OriginalText> original() {
        return typed.or(() -> file.map(SceneFile::text)).or(() -> database.map(DatabaseFile::text));
    }

    /** The same, after somebody has written in it. */
    KeptText with(Optional<OriginalText> written) {
        return written.isEmpty() ? this : new KeptText(file.map(known -> known.withText(written.get())), database, file.isPresent() ? Optional.empty() : written);
    }
}
