package cz.paprsek.cli.output;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.Layers;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.TileStore;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;

/** How a picture is made, and where it goes: by itself, or as one of the frames of a film. */
interface Way {
    RenderResult render(Scene scene, Assets assets, RenderOptions options, RenderMonitor monitor, TileStore store);

    void write(Target target, Image image, Layers layers, ImageOptions how) throws IOException;

    /** The file beside which finished tiles are kept. */
    default Path tilesBeside(Target target) {
        return target.file().orElseThrow();
    }

    /** A scene that differs if the picture does: that which it shows, for a picture of a moment. */
    default Scene keptAs(Scene shown) {
        return shown;
    }

    /** Whether the picture is all that goes to the target's file. */
    default boolean isAlone() {
        return false;
    }

    /** Whether tiles of another picture, which are found there, are of no use to anybody. */
    default boolean beginsAnew() {
        return false;
    }

    /** Whether they are kept when the picture is written. */
    default boolean keepsTiles() {
        return false;
    }
}
