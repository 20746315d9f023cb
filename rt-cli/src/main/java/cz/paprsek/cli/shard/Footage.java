package cz.paprsek.cli.shard;

import cz.paprsek.image.ImageOptions;
import cz.paprsek.render.RenderScene;

/** What is to be rendered, frame by frame; a picture that is no film has the frame 0. */
public interface Footage {
    /** How the picture is written in a format that tells its origin. */
    ImageOptions written(int frame);

    /** Prepares the scene. */
    RenderScene scene(int frame);
}
