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
        RenderResult.Stats stats = stats(text.toString());
        assertThat((double) stats.hits()).isCloseTo(49_788 * SHARE, withinPercentage(5));
        assertThat((double) stats.shadow()).isCloseTo(46_112 * SHARE, withinPercentage(5));
        assertThat(stats.reflected() + stats.refracted()).isZero();
    }

    private static final int TEETH = 36;

    /** A face of a gear: counter-clockwise if turn is 1, clockwise if it is −1. */
    private static double[][] gearFace(double x, double y, double z, double offset, double outer, int turn) {
        double[] within = {-0.19, 0.19, 0.3, 0.7};
        double[][] corners = new double[4 * TEETH][];
        for (int i = 0; i < corners.length; i++) {
            int tooth = i / 4;
            double angle = offset + turn * 2 * Math.PI / TEETH * (tooth + within[i % 4]);
            double radius = (i % 4 < 2 ? 0.995 : 0.9) * outer;
            corners[i] = new double[] {x + radius * Math.cos(angle), y + radius * Math.sin(angle), z};
        }
        return corners;
    }

    private static void polygon(StringBuilder text, double[]... corners) {
        text.append("p ").append(corners.length).append('\n');
        for (double[] corner : corners) {
            for (double number : corner) {
                text.append(Math.rint(number * 1e6) / 1e6).append(' ');
            }
            text.append('\n');
        }
    }

    private static void gear(StringBuilder text, double x, double y, double z, double offset, double outer) {
        double[][] top = gearFace(x, y, z, offset, outer, 1);
        polygon(text, top);
        for (int i = 0; i < top.length; i++) {
            double[] a = top[i];
            double[] b = top[(i + 1) % top.length];
            polygon(text, a, new double[] {a[0], a[1], z - 0.1}, new double[] {b[0], b[1], z - 0.1}, b);
        }
        polygon(text, gearFace(x, y, z - 0.1, offset, outer, -1));
    }

    /** 64 gears, some of them of glass, above a mirror. What little of it mirrors, in place of none, makes no difference to the picture, but to the counts. */
    private static String gears(int size, double mirroring) {
        StringBuilder text = new StringBuilder("b 0.078 0.361 0.753\nv\nfrom -1.1 -2.1 2.6\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution " + size + ' ' + size
                + "\nl 2 4 4\nl -2 4 3\nl 2 -2.5 2.5\nl -1 -4 2\nl -1.111 -2.121 2.626\nf 1 0.85 0.7 0.3 0.6 37 0 0\n");
        polygon(text, new double[] {2, 2, 0}, new double[] {-2, 2, 0}, new double[] {-2, -2, 0}, new double[] {2, -2, 0});
        double outer = 1 / 3.85;
        for (int i = 0; i < 64; i++) {
            int ix = i % 4;
            int iy = i / 4 % 4;
            int iz = i / 16;
            text.append((ix * 4 + iy * 2 + iz) % 5 == 0 ? "f 1 1 1 0.2 " + mirroring + " 0 0.8 1.1\n" : "f 1 1 1 1 0 0 0 0\n");
            gear(text, outer - 1 + ix * 1.9 * outer, outer - 1 + iy * 1.9 * outer, 1 - 0.25 * iz, (ix + iy + iz) % 2 * Math.PI / TEETH, outer);
        }
        return text.toString();
    }

    private static RenderResult.Stats stats(String text) throws IOException {
        Assets assets = Assets.of(Map.of("x.nff", text.getBytes(StandardCharsets.US_ASCII)));
        Scene scene = ForeignScene.read("x.nff", ForeignFormat.NFF, assets).scene();
        return Renderer.render(RenderScene.of(scene, assets, RenderMonitor.NONE), RenderOptions.of(scene), RenderMonitor.NONE).stats();
    }

    /**
     * The counts are of a program that follows a mirrored ray from every surface that light shines through, whatever its file says of the share: the glass of the gears has Ks 0, of which ours sends none. That is
     * all the difference: with a billionth of mirroring, each kind of ray is there as often as was counted; with none, so many are missing as those rays and all that follows from them.
     *
     * @source Haines, Standard Procedural Databases, Readme, Testing Procedures 8 and 9: "All rays hitting only reflective and transmitting objects spawn reflection rays", "all transmitters in the SPD are also
     *     reflective"; the counts of gears
     */
    @Test
    void theGearsTakeAsManyRaysAsWereCountedIfGlassMirrors() throws IOException {
        int size = 97;
        double share = (double) size * size / (513 * 513);
        RenderResult.Stats stats = stats(gears(size, 1e-9));
        assertThat((double) stats.reflected()).as("reflected").isCloseTo(304_643 * share, withinPercentage(6));
        assertThat((double) stats.refracted()).as("refracted").isCloseTo(207_564 * share, withinPercentage(6));
        assertThat((double) stats.shadow()).as("shadow").isCloseTo(2_246_955 * share, withinPercentage(6));
        assertThat((double) stats(gears(size, 0)).reflected()).as("as the file says").isLessThan(0.4 * stats.reflected());
    }
}
