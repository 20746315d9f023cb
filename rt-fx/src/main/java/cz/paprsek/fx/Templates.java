package cz.paprsek.fx;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Objects;

/** Scenes that come with the program. */
final class Templates {
    /** To start from; each has a text with the key "template." and its name. */
    static final List<String> NEW = List.of("plain", "studio", "test");
    /** To look at: scenes of the project. */
    static final List<String> EXAMPLES = List.of(
            "still-life", "showcase", "primitives", "csg", "placement", "lights", "stage", "soft-shadows", "lanterns", "evening-sun", "focus", "orthographic", "fisheye",
            "panorama", "mirrors", "glass", "lens", "tumbler", "dice", "fresnel", "absorption", "rough", "neon", "materials", "checkers", "patterns", "pictures", "four-lines", "threads", "chess");

    private Templates() {}

    /** Where the pictures of examples come from. */
    static Assets pictures() {
        return Assets.in(Templates.class.getClassLoader(), "cz/paprsek/fx/examples");
    }

    /** Reads a template or example. */
    static Scene read(String name) {
        String file = (NEW.contains(name) ? "templates/" : "examples/") + name + ".xml";
        try (InputStream input = Objects.requireNonNull(Templates.class.getResourceAsStream(file), file + " is missing")) {
            return SceneFiles.read(input, file);
        } catch (IOException | SceneFileException e) {
            throw new IllegalStateException(file + " in the program's own jar cannot be read", e);
        }
    }
}
