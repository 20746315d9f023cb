package cz.paprsek;

import cz.paprsek.asset.Assets;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderScene;
import cz.paprsek.scene.Scene;
import java.nio.file.Files;
import java.nio.file.Path;

/** The pictures of the scenes that lie here and there in this project. */
public final class ShippedPictures {
    private static final Path SHIPPED = Path.of("../scenes");
    private static final Path CROSSCHECK = Path.of("src/test/resources/crosscheck");

    private ShippedPictures() {}

    public static Assets all() {
        return Assets.from(name -> Files.newInputStream(Files.exists(SHIPPED.resolve(name)) ? SHIPPED.resolve(name) : CROSSCHECK.resolve(name)));
    }

    /** One of those scenes, ready to be rendered. */
    public static RenderScene ready(Scene scene) {
        return RenderScene.of(scene, all(), RenderMonitor.NONE);
    }
}
