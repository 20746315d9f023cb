package cz.paprsek.fx.view.render;

import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.origin.Origins;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Optional;

/**
 * A scene, and what of it a picture shows.
 *
 * @param whole as it is edited
 * @param seen as it is rendered
 * @param camera the one that sees it, if not the first, in the word of the command line
 * @param light the only one that shines, likewise
 */
record Subject(Scene whole, Scene seen, Optional<String> camera, Optional<String> light) {
    /** What a file in a format tells of a picture of this. */
    Origin origin(RenderOptions options, ImageFormat format) {
        return Origins.of(whole, options, camera, light, format);
    }

    /** What the command line calls one of several: its name, or its number from 1 if another has that name before, or none. */
    static String word(List<String> names, int index) {
        String name = names.get(index);
        return name.isEmpty() || names.indexOf(name) < index ? Integer.toString(index + 1) : name;
    }
}
