package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** The library used long, and by many at once. */
class SoakTest {
    private static final int RENDERS = 2000;
    private static final RenderSettings SMALL = new RenderSettings(24, 16, 5, 1);

    @Test
    void memoryStaysFlatOverManyRenders() throws Exception {
        Scene scene = SceneFiles.read(Path.of("../scenes/showcase.xml")).withSettings(SMALL);
        int[] first = Renderer.render(scene).toArgb();
        long early = 0;
        for (int i = 0; i < RENDERS; i++) {
            assertThat(Renderer.render(scene).toArgb()).isEqualTo(first);
            if (i == RENDERS / 4) {
                early = used();
            }
        }
        // A picture and what it takes to make it is some 100 kB: one in ten of them kept would show.
        assertThat(used() - early).as("bytes more after %d renders", RENDERS).isLessThan(8_000_000);
    }

    @Test
    void sixteenThreadsAtOnceGetTheSameBytes() throws Exception {
        Scene scene = SceneFiles.read(Path.of("../scenes/glass.xml")).withSettings(SMALL.withSize(48, 32));
        RenderScene shared = RenderScene.of(scene);
        int[] alone = Renderer.render(scene).toArgb();
        int[][] pictures = new int[16][];
        Thread[] users = IntStream.range(0, pictures.length).mapToObj(i -> new Thread(() -> {
            for (int j = 0; j < 20; j++) {
                RenderScene mine = j % 2 == 0 ? shared : RenderScene.of(scene);
                pictures[i] = Renderer.render(mine, RenderOptions.of(scene).withThreads(1 + (i + j) % 3), RenderMonitor.NONE).image().toArgb();
                if (!Arrays.equals(pictures[i], alone)) {
                    return;
                }
            }
        })).toArray(Thread[]::new);
        for (Thread user : users) {
            user.start();
        }
        for (Thread user : users) {
            user.join();
        }
        assertThat(Arrays.asList(pictures)).allSatisfy(picture -> assertThat(picture).isEqualTo(alone));
    }

    private static long used() {
        for (int i = 0; i < 3; i++) {
            System.gc();
        }
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }
}
