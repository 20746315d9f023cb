package cz.paprsek.fx.view.library;

import cz.paprsek.asset.Assets;
import cz.paprsek.io.Failures;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneObject;
import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ExecutorService;
import java.util.function.Supplier;
import javafx.application.Platform;
import javafx.scene.image.Image;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;

/**
 * Small pictures of scenes, rendered one after the other in the background. Kept by the scene's content: a
 * scene that is renamed or tagged keeps its picture. For JavaFX's thread.
 */
public final class Thumbnails implements AutoCloseable {
    /** Pixels. */
    public static final int WIDTH = 192;
    public static final int HEIGHT = 108;
    /** Levels of rays. Glass within glass takes twice the time for each; fewer only make it a little darker. */
    private static final int DEEPEST = 7;
    /** In a pixel. */
    private static final int PATHS = 16;
    /** A picture has 80 kB. */
    private static final int MOST = 2_000;

    private final ExecutorService worker = Worker.named("library-thumbnails");
    private final Map<Content, Picture> made = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Content, Picture> eldest) {
            return size() > MOST;
        }
    };
    private final Queue<Wish> wishes = new ArrayDeque<>();
    private final Supplier<Assets> assets;
    private boolean isBusy;
    private volatile boolean closed;

    /** @param assets where pictures come from that the scenes name */
    public Thumbnails(Supplier<Assets> assets) {
        this.assets = assets;
    }

    /** A picture, or a sentence why there is none. */
    public record Picture(Optional<Image> image, String fault) {}

    /** A picture that is asked for, and who wants to know when it is there. */
    private record Wish(Scene scene, Assets assets, Runnable receiver) {}

    /** All that a picture depends on. */
    private record Content(Integrator integrator, int maxDepth, Rgb background, Sky sky, Rgb ambient, Camera camera, List<Light> lights, Map<String, Material> materials,
            List<SceneObject> objects) {
        static Content of(Scene scene) {
            return new Content(scene.settings().integrator(), Math.min(DEEPEST, scene.settings().maxDepth()), scene.background(), scene.sky(), scene.ambient(), scene.camera(), scene.lights(), scene.materials(),
                    scene.objects());
        }

        /** Looks at one object only: there may be a million, and this is asked for every tile that comes into sight. */
        @Override
        public int hashCode() {
            return 31 * (31 * camera.hashCode() + objects.size()) + (objects.isEmpty() ? 0 : objects.get(objects.size() / 2).hashCode());
        }
    }

    /** The picture, if there is one already. */
    public Optional<Picture> get(Scene scene) {
        return Optional.ofNullable(made.get(Content.of(scene)));
    }

    /** Makes a picture, and tells when it is there. */
    void request(Scene scene, Runnable receiver) {
        request(scene, assets.get(), receiver);
    }

    /** Makes a picture of a scene whose pictures come from elsewhere, and tells when it is there. */
    public void request(Scene scene, Assets from, Runnable receiver) {
        wishes.add(new Wish(scene, from, receiver));
        next();
    }

    /** Withdraws the wishes of one who has no use for them any more. */
    void cancel(Runnable receiver) {
        wishes.removeIf(wish -> wish.receiver().equals(receiver));
    }

    private void next() {
        if (isBusy || closed || wishes.isEmpty()) {
            return;
        }
        Wish wish = wishes.remove();
        isBusy = true;
        worker.execute(() -> {
            Optional<Picture> picture = render(wish.scene(), wish.assets());
            Platform.runLater(() -> {
                isBusy = false;
                picture.ifPresent(done -> {
                    made.put(Content.of(wish.scene()), done);
                    wish.receiver().run();
                });
                next();
            });
        });
    }

    /** Nothing if the window was closed meanwhile. */
    private Optional<Picture> render(Scene scene, Assets from) {
        RenderMonitor monitor = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return closed;
            }
        };
        RenderSettings small = new RenderSettings(WIDTH, HEIGHT, Math.min(DEEPEST, scene.settings().maxDepth()), 2);
        small = scene.settings().isPath() ? small.withIntegrator(Integrator.PATH).withSamples(PATHS) : small;
        try {
            RenderResult result = Renderer.render(RenderScene.of(scene, from, monitor), RenderOptions.of(small).withThreads(1), monitor);
            return result.outcome() == RenderResult.Outcome.CANCELLED ? Optional.empty() : Optional.of(new Picture(Optional.of(image(result)), ""));
        } catch (RuntimeException | StackOverflowError | OutOfMemoryError fault) {
            return Optional.of(new Picture(Optional.empty(), Failures.sentence(fault)));
        }
    }

    private static Image image(RenderResult result) {
        WritableImage image = new WritableImage(WIDTH, HEIGHT);
        image.getPixelWriter().setPixels(0, 0, WIDTH, HEIGHT, PixelFormat.getIntArgbInstance(), result.image().toArgb(), 0, WIDTH);
        return image;
    }

    @Override
    public void close() {
        closed = true;
        worker.shutdown();
    }
}
