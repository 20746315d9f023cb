package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.StandardScenes;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** How much work the standard scenes are, counted rather than timed: a tree of poorer quality shows here on every machine. */
class WorkTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 88;

    /** Visits were recorded when the tree was last improved: a better tree calls for new figures, a poorer one for a reason. */
    private enum Work {
        FEW(StandardScenes::few, 0, 0, 0),
        FLAKE(() -> StandardScenes.flake(4), 0, 0, 0),
        CLOUD(() -> StandardScenes.cloud(100_000), 0, 0, 0),
        CARVED(() -> StandardScenes.carved(1000), 0, 0, 0),
        PIERCED(() -> StandardScenes.pierced(1000), 0, 0, 0),
        CHAIN(() -> StandardScenes.chain(100), 0, 0, 0);

        private final Supplier<Scene> scene;
        private final long reflected;
        private final long shadows;
        private final long visits;

        Work(Supplier<Scene> scene, long reflected, long shadows, long visits) {
            this.scene = scene;
            this.reflected = reflected;
            this.shadows = shadows;
            this.visits = visits;
        }
    }

    @Test
    void raysAndVisitedNodesAreAsRecorded() {
        for (Work work : Work.values()) {
            Scene scene = work.scene.get();
            Tracer tracer = new Tracer(RenderScene.of(scene), 5, 1, RenderMonitor.NONE);
            Eye eye = new Eye(scene.camera(), WIDTH, HEIGHT);
            for (int y = 0; y < HEIGHT; y += 8) {
                for (int x = 0; x < WIDTH; x += 8) {
                    tracer.trace(eye, x, y, 8, 8);
                }
            }
            String found = work + ": " + tracer.reflected + ", " + tracer.shadows + ", " + tracer.visits();
            assertThat(tracer.reflected).as(found).isEqualTo(work.reflected);
            assertThat(tracer.shadows).as(found).isEqualTo(work.shadows);
            assertThat(tracer.visits()).as(found).isCloseTo(work.visits, within(work.visits / 100));
        }
    }
}
