package cz.paprsek.fx.view.look;

import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.Map;
import java.util.function.BiConsumer;
import javafx.application.Platform;
import javafx.scene.image.Image;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;

/** Pictures of balls of materials, rendered one after the other in the background. */
public final class MaterialBalls {
    /** Pixels. */
    public static final int SIZE = 44;
    /** Pixels rendered for one that is shown, along each side: for screens of twice the resolution. */
    private static final int FINER = 2;

    private MaterialBalls() {}

    /** Tells each picture on JavaFX's thread, when it is there. */
    public static void paint(Map<String, Material> materials, BiConsumer<String, Image> receiver) {
        Thread thread = new Thread(() -> materials.forEach((name, material) -> {
            Image image = image(scene(material));
            Platform.runLater(() -> receiver.accept(name, image));
        }), "material-balls");
        thread.setDaemon(true);
        thread.start();
    }

    /** A ball half a unit in radius on a floor of squares before a wall of light. */
    private static Scene scene(Material material) {
        Material floor = Material.DEFAULT.withPattern(new Pattern.Checker(0.35, new Vec3(0, -0.7, 0), Rgb.grey(226), Rgb.grey(104)));
        return Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 0.35, 2.6), Vec3.ZERO).withFovy(25)).withBackground(new Rgb(176, 192, 212)).withAmbient(Rgb.grey(70))
                .plus(Light.at(-3, 5, 4).withIntensity(0.75)).plus(Light.at(4, 3, 3).withIntensity(0.3))
                .plus(SceneObject.of(new Rectangle(-6, -6, 6, 6)).rotated(-90, 0, 0).at(0, -0.5, 0).madeOf(floor),
                        SceneObject.of(new Sphere(0.5)).madeOf(material));
    }

    private static Image image(Scene scene) {
        int size = FINER * SIZE;
        RenderSettings settings = new RenderSettings(size, size, 6, 2);
        int[] pixels = Renderer.render(RenderScene.of(scene), RenderOptions.of(settings).withThreads(1), RenderMonitor.NONE).image().toArgb();
        WritableImage image = new WritableImage(size, size);
        image.getPixelWriter().setPixels(0, 0, size, size, PixelFormat.getIntArgbInstance(), pixels, 0, size);
        return image;
    }
}
