package cz.paprsek.cli.shard;

import cz.paprsek.asset.Assets;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.scene.Scene;
import java.nio.file.Path;

/**
 * A picture or film that is wanted, as it is known once its scene has been read.
 *
 * @param file of the scene
 * @param scene what is shown; of a film, all of it
 * @param assets the files beside it, read already
 * @param card which picture it is
 * @param span its frames
 */
public record Order(Path file, Scene scene, Assets assets, Card card, RenderOptions options, Span span, Footage footage) {}
