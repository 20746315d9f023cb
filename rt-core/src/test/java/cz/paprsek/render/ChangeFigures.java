package cz.paprsek.render;

import com.sun.management.OperatingSystemMXBean;
import cz.paprsek.material.Material;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import cz.paprsek.standard.StandardScenes;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Prints what it takes to move one of many spheres, to add or remove one, and to make it of glass. Not a test, and left out of the build by its name; {@code -Dtest=ChangeFigures} runs it. */
class ChangeFigures {
    private static final int ROUNDS = 41;

    @Test
    void oneOfManySpheres() {
        for (int count : new int[] {1_000, 10_000, 100_000, 1_000_000}) {
            Scene scene = StandardScenes.cloud(count);
            RenderScene ready = RenderScene.of(scene);
            int[] round = {0};
            Supplier<Scene> move = () -> scene.with(ScenePath.body(round[0]++ * 37 % count), body ->
                    body.placed(body.placement().withPosition(body.placement().position().times(1.001))));
            Supplier<Scene> more = () -> scene.plus(SceneObject.of(new Sphere(0.1)));
            Supplier<Scene> fewer = () -> {
                List<SceneObject> objects = new ArrayList<>(scene.objects());
                objects.remove(round[0]++ * 37 % count);
                return scene.withObjects(objects);
            };
            Supplier<Scene> glass = () -> scene.with(ScenePath.body(round[0]++ * 37 % count), body -> body.madeOf(Material.DEFAULT.withTransparency(0.9, 1.5)));
            Scene withGlass = glass.get();
            Supplier<Scene> opaque = () -> withGlass.with(ScenePath.body(0), body -> body.madeOf(Material.color(round[0]++ % 256, 0, 0)));
            print(count, "added", more, ready);
            print(count, "removed", fewer, ready);
            print(count, "made of glass", glass, ready);
            print(count, "made opaque", opaque, RenderScene.of(withGlass));
            double edit = millis(count, move);
            double change = millis(count, () -> ready.changedTo(move.get(), RenderMonitor.NONE));
            double anew = millis(count, () -> RenderScene.of(checkedAnew(move.get())));
            Scene moved = move.get();
            Scene many = scene.with(IntStream.range(0, count / 20).mapToObj(i -> ScenePath.body(16 * i)).toList(), (at, body) ->
                    body.placed(body.placement().withPosition(body.placement().position().times(1.001))));
            System.out.printf(Locale.ROOT, "%,d spheres: edit %.3f ms, edit and prepare %.3f ms, all anew %.1f ms; a ray takes %.0f ns, with one moved %.0f ns, "
                            + "with one of twenty moved %.0f ns%n",
                    count, edit, change, anew, nanos(ready), nanos(ready.changedTo(moved, RenderMonitor.NONE)), nanos(ready.changedTo(many, RenderMonitor.NONE)));
        }
    }

    private static void print(int count, String what, Supplier<Scene> edit, RenderScene ready) {
        System.out.printf(Locale.ROOT, "%,d spheres, one %s: edit %.3f ms, edit and prepare %.3f ms%n", count, what, millis(count, edit),
                millis(count, () -> ready.changedTo(edit.get(), RenderMonitor.NONE)));
    }

    private static Scene checkedAnew(Scene scene) {
        return new Scene(scene.name(), scene.description(), scene.tags(), scene.settings(), scene.background(), scene.sky(), scene.ambient(),
                new ArrayList<>(scene.cameras()), new ArrayList<>(scene.lights()), new LinkedHashMap<>(scene.materials()), new ArrayList<>(scene.objects()));
    }

    /** The least. */
    private static double millis(int count, Supplier<?> work) {
        int rounds = count >= 1_000_000 ? 5 : ROUNDS;
        double[] taken = new double[rounds];
        for (int warm = 0; warm < (count > 1_000 ? 2 : 20); warm++) {
            for (int i = 0; i < rounds; i++) {
                long begin = System.nanoTime();
                if (work.get() == null) {
                    throw new IllegalStateException();
                }
                taken[i] = (System.nanoTime() - begin) / 1e6;
            }
        }
        return Arrays.stream(taken).min().orElseThrow();
    }

    /** The least of several pictures, by processor time. */
    private static double nanos(RenderScene scene) {
        RenderOptions options = RenderOptions.of(scene.scene().settings().withSize(640, 480)).withThreads(1);
        OperatingSystemMXBean machine = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 4; i++) {
            // The clock goes in steps of a hundredth of a second.
            long begin = machine.getProcessCpuTime();
            long rays = 0;
            for (int k = 0; k < 4; k++) {
                RenderResult.Stats stats = Renderer.render(scene, options, RenderMonitor.NONE).stats();
                rays += stats.primary() + stats.reflected() + stats.refracted() + stats.shadow();
            }
            least = Math.min(least, (machine.getProcessCpuTime() - begin) / (double) rays);
        }
        return least;
    }
}
