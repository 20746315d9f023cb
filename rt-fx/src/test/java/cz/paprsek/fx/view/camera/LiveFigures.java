package cz.paprsek.fx.view.camera;

import com.sun.management.OperatingSystemMXBean;
import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.CameraMoves;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.projection.Axes;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import cz.paprsek.standard.StandardScenes;
import cz.paprsek.xml.SceneFiles;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.animation.AnimationTimer;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableValue;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.junit.jupiter.api.Test;

/**
 * Prints how the views follow a hand. Not a test, and left out of the build by its name; {@code -Dtest=LiveFigures} runs it. What
 * is counted is what can be seen: pulses of JavaFX in which the picture is another one than in the pulse before.
 */
class LiveFigures {
    private static final double SECONDS = 6;
    private static final int CHANGES = 40;
    private static final double DEGREES = 0.7;

    @Test
    void showcase() throws Exception {
        showcase(380, 330, 380, 214);
    }

    @Test
    void aLargeShowcase() throws Exception {
        showcase(960, 560, 960, 540);
    }

    private void showcase(double paneWidth, double paneHeight, int width, int height) throws Exception {
        EditorModel model = new EditorModel(SceneFiles.read(Path.of("../scenes/showcase.xml")));
        CameraPane pane = Gui.on(() -> new CameraPane(model, fault -> {}));
        try (Gui gui = Gui.show(() -> pane, paneWidth, paneHeight)) {
            gui.until("the picture is complete", pane::isComplete);
            Watch watch = Gui.on(() -> new Watch((ImageView) pane.lookup(".live-picture").lookup("ImageView")));
            dragged(gui, model, watch);
            double updates = dragged(gui, model, watch);
            List<Double> delays = new ArrayList<>();
            for (int i = 0; i < CHANGES; i++) {
                gui.until("the picture is complete", pane::isComplete);
                delays.add(firstPicture(gui, model, watch));
            }
            delays.sort(null);
            System.out.printf(Locale.ROOT, "live picture of showcase.xml, %d x %d pixels, %d processors:%n"
                            + "  updates a second while the camera is dragged: %.1f%n"
                            + "  first picture after a change: median %.0f ms, longest of %d %.0f ms%n",
                    width, height, Runtime.getRuntime().availableProcessors(), updates, delays.get(CHANGES / 2), CHANGES, delays.get(CHANGES - 1));
        }
        pane.close();
    }

    @Test
    void tenThousandObjects() {
        List<SceneObject> balls = IntStream.range(0, 10_000)
                .mapToObj(i -> SceneObject.of(new Sphere(0.3)).at(i % 100, i / 1000 * 2, i / 100 % 10 * 2)).toList();
        projections(Scene.EMPTY.withObjects(balls).plus(Light.at(50, 50, 50)), 5000, "10,000 spheres");
    }

    @Test
    void aMeshOfAMillionTriangles() {
        projections(StandardScenes.mesh(1_000_000), 1, "a mesh of a million triangles");
    }

    private static void projections(Scene scene, int dragged, String what) {
        EditorModel model = new EditorModel(scene);
        ObservableValue<Theme> theme = new SimpleObjectProperty<>(Theme.LIGHT);
        List<ProjectionPane> panes = Stream.of(Axes.values()).map(axes -> Gui.on(
                () -> new ProjectionPane(new Edits(model, Texts.in(Locale.ENGLISH)), axes, theme, new SimpleBooleanProperty(true), new SimpleBooleanProperty(true)))).toList();
        try (Gui gui = Gui.show(() -> {
            HBox row = new HBox(4);
            row.getChildren().addAll(panes);
            panes.forEach(pane -> HBox.setHgrow(pane, Priority.ALWAYS));
            return row;
        }, 1200, 330)) {
            gui.act(() -> model.select(ScenePath.body(dragged)));
            ProjectionPane pane = panes.get(0);
            pulses(gui, model, pane, (old, pulse) -> old, 1);
            System.out.printf(Locale.ROOT, "three projections of %s, 400 x 330 pixels each, %d processors:%n"
                            + "  while one is dragged with the mouse: %s%n  while it is turned: %s%n  while a view is zoomed: %s%n",
                    what, Runtime.getRuntime().availableProcessors(),
                    pulses(gui, model, pane, (old, pulse) -> Moves.translated(old, model.selection(), new Vec3(0.05 * pulse, 0, 0)), 1),
                    pulses(gui, model, pane, (old, pulse) -> Moves.rotated(old, model.selection(), Vec3.ZERO, new Vec3(0.5 * pulse, 0, 0)), 1),
                    pulses(gui, model, pane, (old, pulse) -> old, 1.01));
        }
    }

    /** What a hand does to a scene until a pulse, of which there have been so many. */
    private interface Hand {
        Scene move(Scene scene, int pulse);
    }

    /** Frames a second while in every one of them the hand does something, and a view is zoomed; and what they cost. */
    private static String pulses(Gui gui, EditorModel model, ProjectionPane pane, Hand doing, double zoom) {
        Gesture gesture = Gui.on(() -> model.begin(Label.of(Label.Edit.MOVE)));
        AtomicInteger pulses = new AtomicInteger();
        AnimationTimer hand = Gui.on(() -> new AnimationTimer() {
            @Override
            public void handle(long now) {
                int pulse = pulses.incrementAndGet();
                gesture.preview(scene -> doing.move(scene, pulse));
                if (zoom != 1) {
                    pane.zoom(pulses.get() / 60 % 2 == 0 ? zoom : 1 / zoom);
                }
            }
        });
        long start = System.nanoTime();
        long busy = processorTime();
        gui.act(hand::start);
        gui.until("time is over", () -> System.nanoTime() - start > SECONDS * 1e9);
        double taken = (System.nanoTime() - start) / 1e9;
        double worked = (processorTime() - busy) / 1e6;
        int frames = pulses.get();
        gui.act(() -> {
            hand.stop();
            gesture.cancel();
        });
        return String.format(Locale.ROOT, "%.1f frames a second, each for %.1f ms of processor time", frames / taken, worked / frames);
    }

    private static long processorTime() {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime();
    }

    /** Updates a second while every pulse moves the camera. */
    private static double dragged(Gui gui, EditorModel model, Watch watch) {
        Gesture gesture = Gui.on(() -> model.begin(Label.of(Label.Edit.CAMERA)));
        AtomicInteger pulses = new AtomicInteger();
        AnimationTimer hand = Gui.on(() -> new AnimationTimer() {
            @Override
            public void handle(long now) {
                double degrees = DEGREES * pulses.incrementAndGet();
                gesture.preview(scene -> orbited(scene, degrees));
            }
        });
        long start = System.nanoTime();
        gui.act(() -> {
            watch.updates.set(0);
            watch.start();
            hand.start();
        });
        gui.until("time is over", () -> System.nanoTime() - start > SECONDS * 1e9);
        double taken = (System.nanoTime() - start) / 1e9;
        int updates = watch.updates.get();
        gui.act(() -> {
            hand.stop();
            watch.stop();
            gesture.cancel();
        });
        return updates / taken;
    }

    /** From a change of the scene to the pulse that shows another picture, in milliseconds. */
    private static double firstPicture(Gui gui, EditorModel model, Watch watch) {
        gui.act(watch::start);
        long start = System.nanoTime();
        Gui.on(() -> {
            watch.updates.set(0);
            model.edit(Label.of(Label.Edit.CAMERA), scene -> orbited(scene, DEGREES));
            return true;
        });
        gui.until("another picture is shown", () -> watch.updates.get() > 0);
        double millis = (watch.changed - start) / 1e6;
        gui.act(watch::stop);
        return millis;
    }

    private static Scene orbited(Scene scene, double degrees) {
        return scene.withCamera(CameraMoves.orbited(scene.camera(), Vec3.ZERO, degrees, 0));
    }

    /** Looks in every pulse whether the picture has changed. */
    private static final class Watch extends AnimationTimer {
        private static final int APART = 7;

        private final ImageView view;
        final AtomicInteger updates = new AtomicInteger();
        volatile long changed;
        private long last;

        Watch(ImageView view) {
            this.view = view;
        }

        @Override
        public void handle(long now) {
            Image image = view.getImage();
            long sum = 0;
            for (int y = 0; y < image.getHeight(); y += APART) {
                for (int x = 0; x < image.getWidth(); x += APART) {
                    sum = 31 * sum + image.getPixelReader().getArgb(x, y);
                }
            }
            if (sum != last) {
                last = sum;
                changed = System.nanoTime();
                updates.incrementAndGet();
            }
        }
    }
}
