package cz.paprsek.xml.quick;

import cz.paprsek.scene.Scene;
import cz.paprsek.xml.format.FileScenes;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Reads good files quickly: makes the records by what stands at their components, and takes nothing that the schema would refuse. At the first
 * thing that is wrong or not known here, it gives up; the file is then read thoroughly.
 */
public final class QuickReader {
    private static final byte[] DATABASE = Slot.ascii("database");
    private static final TagForm DATABASE_TAG = new TagForm(List.of(), List.of());

    private final Markup markup;
    private final double[] room = new double[3];

    private QuickReader(Markup markup) {
        this.markup = markup;
    }

    /** What is in a file; empty if it must be read thoroughly. */
    public static Optional<FileScenes> read(InputStream input) throws IOException {
        try {
            return Optional.of(new QuickReader(new Markup(input)).file());
        } catch (IllegalArgumentException unusual) {
            return Optional.empty();
        }
    }

    /** Whether a file's first element is a {@code <scene>}; not if that is not easily seen. Java's parser takes longer to be made than a small scene to be read. */
    public static boolean isScene(Path file) throws IOException {
        try (InputStream input = Files.newInputStream(file)) {
            Markup markup = new Markup(input);
            boolean isScene = markup.nextTag() && markup.isNamed(WholeSceneReader.SCENE);
            // Behind the name there must be something else than more of it.
            markup.nextAttribute();
            return isScene;
        } catch (IllegalArgumentException unusual) {
            return false;
        }
    }

    private FileScenes file() throws IOException {
        Unusual.unless(markup.nextTag());
        boolean isDatabase = markup.isNamed(DATABASE);
        WholeSceneReader scenes = new WholeSceneReader(markup, room);
        List<Scene> found = isDatabase ? database(scenes) : List.of(scenes.readRoot());
        markup.end();
        return new FileScenes(found, isDatabase);
    }

    private List<Scene> database(WholeSceneReader reader) throws IOException {
        DATABASE_TAG.readRoot(markup, room);
        List<Scene> scenes = new ArrayList<>();
        Set<String> names = new HashSet<>();
        if (markup.hasContent(1)) {
            while (markup.nextTag()) {
                Scene scene = reader.read(2);
                Unusual.unless(!scene.name().isEmpty() && names.add(scene.name()));
                scenes.add(scene);
            }
            markup.endTag(DATABASE);
        }
        return scenes;
    }
}
