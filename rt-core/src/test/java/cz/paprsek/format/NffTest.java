package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import cz.paprsek.asset.Assets;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** One of the Standard Procedural Databases, made here from its description, against the rays that were counted for it. */
class NffTest {
    /** A quarter of the pixels each way, so that there are a sixteenth of the rays. */
    private static final int SIZE = 129;
    private static final double SHARE = (double) SIZE * SIZE / (513 * 513);
    /** Every other corner of a cube. */
    private static final int[][] CORNERS = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

    /** A pyramid of four faces, which is four pyramids of half the size, and so on. */
    private static void tetra(StringBuilder text, double x, double y, double z, double size, int depth) {
        for (int[] corner : CORNERS) {
            if (depth > 0) {
                tetra(text, x + corner[0] * size / 2, y + corner[1] * size / 2, z + corner[2] * size / 2, size / 2, depth - 1);
            } else {
                text.append("p 3\n");
                for (int[] other : CORNERS) {
                    if (other != corner) {
                        text.append(x + other[0] * size).append(' ').append(y + other[1] * size).append(' ').append(z + other[2] * size).append('\n');
                    }
                }
            }
        }
    }

    /** @source Haines, A Proposal for Standard Graphics Environments, IEEE Computer Graphics and Applications 7(11), 1987: 49 788 eye rays hit, with 46 112 shadow rays */
    @Test
    void thePyramidTakesAsManyRaysAsWereCounted() throws IOException {
        StringBuilder text = new StringBuilder("b 0.078 0.361 0.753\nv\nfrom 1.02285 -3.17715 -2.17451\nat -0.004103 -0.004103 0.216539\nup -0.816497 -0.816497 0.816497\nangle 45\nhither 1\n"
                + "resolution " + SIZE + ' ' + SIZE + "\nl 2 -18 -5\nf 1 0.2 0.2 1 0 100000 0 0\n");
        tetra(text, 0, 0, 0, 1, 5);
        assertThat(text.toString().lines().filter(line -> line.startsWith("p"))).hasSize(4096);
        Assets assets = Assets.of(Map.of("tetra.nff", text.toString().getBytes(StandardCharsets.US_ASCII)));
        Scene scene = ForeignScene.read("tetra.nff", ForeignFormat.NFF, assets).scene();
        RenderResult.Stats stats = Renderer.render(RenderScene.of(scene, assets, RenderMonitor.NONE), RenderOptions.of(scene), RenderMonitor.NONE).stats();
        assertThat((double) stats.hits()).isCloseTo(49_788 * SHARE, withinPercentage(5));
        assertThat((double) stats.shadow()).isCloseTo(46_112 * SHARE, withinPercentage(5));
        assertThat(stats.reflected() + stats.refracted()).isZero();
    }
}
