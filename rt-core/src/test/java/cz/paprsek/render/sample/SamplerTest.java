package cz.paprsek.render.sample;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SamplerTest {
    private static final int MOST = 256;

    /** A (0, m, 2)-net: of 2ᵐ points, one lies in each box of every grid of 2ᵐ boxes with sides of powers of two. */
    @Test
    void everyPrefixOfAPixelsPointsIsANet() {
        for (Sampler sampler : new Sampler[] {Sampler.scrambled(MOST), Sampler.fixed(MOST)}) {
            for (int[] pixel : new int[][] {{0, 0}, {1, 0}, {700, 433}, {32_767, 32_767}}) {
                assertNets(points(sampler, pixel[0], pixel[1], MOST, Sampler::filter));
                assertNets(points(sampler, pixel[0], pixel[1], MOST, Sampler::lens));
                assertNets(points(sampler, pixel[0], pixel[1], MOST, Sampler::time));
            }
        }
    }

    @Test
    void everyPrefixOfALightsPointsIsANetAndSoAreThoseOfAllSamples() {
        Sampler sampler = Sampler.scrambled(16);
        int path = Sampler.refracted(Sampler.mirrored(Sampler.EYE));
        double[][] all = new double[256][];
        for (int sample = 0; sample < 16; sample++) {
            sampler.start(12, 345, sample);
            sampler.lights(path, 3, 16);
            double[][] own = new double[16][];
            for (int i = 0; i < 16; i++) {
                sampler.next();
                own[i] = new double[] {sampler.u, sampler.v};
                all[16 * sample + i] = own[i];
            }
            assertNets(own);
        }
        assertNets(all);
    }

    private static double[][] points(Sampler sampler, int x, int y, int count, Consumer<Sampler> dimension) {
        double[][] points = new double[count][];
        for (int i = 0; i < count; i++) {
            sampler.start(x, y, i);
            dimension.accept(sampler);
            sampler.next();
            points[i] = new double[] {sampler.u, sampler.v};
        }
        return points;
    }

    private static void assertNets(double[][] points) {
        for (int m = 0; 1 << m <= points.length; m++) {
            for (int across = 0; across <= m; across++) {
                boolean[] met = new boolean[1 << m];
                for (int i = 0; i < 1 << m; i++) {
                    int columns = 1 << across;
                    int rows = 1 << (m - across);
                    int column = (int) (points[i][0] * columns);
                    int box = column * rows + (int) (points[i][1] * rows);
                    assertThat(met[box]).as("box %d of %d × %d", box, columns, rows).isFalse();
                    met[box] = true;
                }
            }
        }
    }

    @Test
    void pointsStayInsideTheSquare() {
        Sampler sampler = Sampler.scrambled(1);
        for (int y = 0; y < 1000; y++) {
            for (int x = 0; x < 1000; x++) {
                sampler.start(x, y, 0);
                sampler.filter();
                sampler.next();
                assertThat(sampler.u > 0 && sampler.u < 1 && sampler.v > 0 && sampler.v < 1).isTrue();
            }
        }
    }

    /** ∫∫ u·v = ¼, ∫∫ u² = ⅓, and a quarter of a disc, π/4; as many random points would miss each by some 5e-3. */
    @Test
    void meansComeCloseToIntegralsMuchFasterThanRandomOnes() {
        double[] errors = new double[3];
        int pixels = 64;
        for (int pixel = 0; pixel < pixels; pixel++) {
            double product = 0;
            double square = 0;
            double disc = 0;
            for (double[] p : points(Sampler.scrambled(4096), pixel, 7 * pixel, 4096, Sampler::lens)) {
                product += p[0] * p[1] / 4096;
                square += p[0] * p[0] / 4096;
                disc += p[0] * p[0] + p[1] * p[1] < 1 ? 1.0 / 4096 : 0;
            }
            errors[0] = Math.max(errors[0], Math.abs(product - 0.25));
            errors[1] = Math.max(errors[1], Math.abs(square - 1.0 / 3));
            errors[2] = Math.max(errors[2], Math.abs(disc - Math.PI / 4));
        }
        assertThat(errors[0]).isLessThan(2e-5);
        assertThat(errors[1]).isLessThan(2e-5);
        assertThat(errors[2]).isLessThan(2e-3);
    }

    /** Over pixels, samples, lights and paths, all of the square is met equally often. */
    @Test
    void nothingIsPreferred() {
        int[] counts = new int[64];
        Sampler sampler = Sampler.scrambled(4);
        for (int i = 0; i < 64_000; i++) {
            sampler.start(i * 37 % 1999, i * 91 % 2003, i % 4);
            sampler.lights(i, i % 5, 1);
            sampler.next();
            int box = (int) (8 * sampler.u);
            counts[8 * box + (int) (8 * sampler.v)]++;
        }
        double chi = 0;
        for (int count : counts) {
            chi += (count - 1000.0) * (count - 1000) / 1000;
        }
        // 63 degrees of freedom: 63 ± 11.2
        assertThat(chi).isLessThan(63 + 4 * 11.2);
    }

    /** The errors of neighbouring pixels do not go together; at best they cancel out: error as fine as grain. */
    @ParameterizedTest
    @ValueSource(ints = {1, 4, 16})
    void errorsOfNeighboursDoNotAddUp(int samples) {
        int side = 128;
        double[][] error = new double[side][side];
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                for (double[] p : points(Sampler.scrambled(samples), x, y, samples, Sampler::lens)) {
                    error[y][x] += (p[0] + 0.7 * p[1] < 0.8 ? 1.0 : 0) / samples - 0.45 / samples;
                }
            }
        }
        double single = 0;
        double acrossPairs = 0;
        double downPairs = 0;
        double ofBlocks = 0;
        for (int y = 0; y < side; y += 4) {
            for (int x = 0; x < side; x += 4) {
                double block = 0;
                for (int i = 0; i < 16; i++) {
                    double own = error[y + i / 4][x + i % 4];
                    single += own * own;
                    acrossPairs += own * error[y + i / 4][(x + i % 4 + 1) % side];
                    downPairs += own * error[(y + i / 4 + 1) % side][x + i % 4];
                    block += own;
                }
                ofBlocks += block * block / 16;
            }
        }
        assertThat(acrossPairs / single).as("correlation across").isLessThan(0.03);
        assertThat(downPairs / single).as("correlation down").isLessThan(0.03);
        assertThat(ofBlocks / single).as("error of blocks of 16, by that of independent pixels").isLessThan(0.3);
    }

    /** Between dimensions, lights and paths there is nothing in common. */
    @Test
    void dimensionsLightsAndPathsAreIndependent() {
        Sampler a = Sampler.scrambled(4);
        Sampler b = Sampler.scrambled(4);
        int[][] paths = {{Sampler.EYE, 0, Sampler.EYE, 1}, {Sampler.EYE, 0, Sampler.mirrored(Sampler.EYE), 0},
            {Sampler.mirrored(Sampler.EYE), 0, Sampler.refracted(Sampler.EYE), 0}};
        for (int[] pair : paths) {
            double sum = 0;
            int n = 0;
            for (int y = 0; y < 64; y++) {
                for (int x = 0; x < 64; x++) {
                    for (int sample = 0; sample < 4; sample++) {
                        a.start(x, y, sample);
                        b.start(x, y, sample);
                        a.lights(pair[0], pair[1], 4);
                        b.lights(pair[2], pair[3], 4);
                        a.next();
                        b.next();
                        sum += (a.u - 0.5) * (b.u - 0.5) * 12;
                        n++;
                    }
                }
            }
            assertThat(sum / n).as("correlation").isCloseTo(0, within(4 / Math.sqrt(n)));
        }
    }

    @Test
    void deepPathsAreToldApart() {
        int path = Sampler.EYE;
        for (int depth = 0; depth < 250; depth++) {
            assertThat(Sampler.mirrored(path)).isNotEqualTo(Sampler.refracted(path)).isNotEqualTo(path);
            path = Sampler.mirrored(path);
        }
    }

    @Test
    void fixedPointsAreTheSameInEveryPixelAndThoseOfLightsInEverySample() {
        Sampler here = Sampler.fixed(16);
        Sampler there = Sampler.fixed(16);
        for (int sample = 0; sample < 16; sample++) {
            here.start(0, 0, sample);
            there.start(811, 77, sample);
            here.lens();
            there.lens();
            assertSameNext(here, there);
            there.start(811, 77, 15 - sample);
            here.lights(Sampler.EYE, 2, 8);
            there.lights(Sampler.mirrored(Sampler.EYE), 2, 8);
            for (int i = 0; i < 8; i++) {
                assertSameNext(here, there);
            }
        }
    }

    /** The points and directions of passes of paths, of which those that are asked for often are made together, are those that a sampler makes which is asked for nothing else. */
    @Test
    void pointsMadeTogetherAreThoseMadeAlone() {
        Sampler together = Sampler.ofPaths(false);
        Asked[] lights = Asked.none(9);
        Asked[] turns = Asked.none(9);
        for (int pass : new int[] {0, 1, 2, 15_624, 3, 4, 5, 6}) {
            for (int k = 0; k < 64; k++) {
                int number = 64 * pass + k;
                together.start(5, 9, number);
                int path = Sampler.EYE;
                // Deep ones seldom, and some neither always nor never; from the second pass on a point is asked for as a direction, too.
                for (int depth = 0; depth < 1 + Integer.numberOfTrailingZeros(k | 32) + pass % 3; depth++) {
                    Sampler alone = Sampler.ofPaths(false);
                    alone.start(5, 9, number);
                    alone.lights(path, 1, 1);
                    together.light(path, 1, lights[depth]);
                    assertSameNext(alone, together);
                    alone.direction(path);
                    if (pass < 3 || k % 3 == 0) {
                        together.direction(path);
                        assertSameNext(alone, together);
                    } else {
                        alone.next();
                    }
                    if (pass > 0) {
                        assertDirection(alone, path, together, turns[depth]);
                    }
                    // Not all go alike.
                    path = k % 16 == 5 ? Sampler.refracted(path) : Sampler.mirrored(path);
                }
            }
        }
    }

    /** One sampler goes from pixel to pixel, along rows and columns: what it made and found for those before is of no use for the next. */
    @Test
    void pointsAreThoseOfTheirPixel() {
        Sampler one = Sampler.ofPaths(false);
        Asked[] asked = Asked.none(2);
        for (int[] pixel : new int[][] {{0, 0}, {0, 1}, {1, 1}, {1, 0}, {7, 0}, {7, 6}}) {
            for (int k = 0; k < 64; k++) {
                Sampler alone = Sampler.ofPaths(false);
                alone.start(pixel[0], pixel[1], k);
                one.start(pixel[0], pixel[1], k);
                alone.lights(Sampler.EYE, 1, 1);
                one.light(Sampler.EYE, 1, asked[0]);
                assertSameNext(alone, one);
                alone.direction(Sampler.EYE);
                alone.next();
                assertDirection(alone, Sampler.EYE, one, asked[1]);
            }
        }
    }

    private static void assertDirection(Sampler point, int path, Sampler sampler, Asked asked) {
        Turn turn = new Turn();
        turn.by(point.v);
        double sine = Math.sqrt(point.u);
        sampler.strew(path, asked);
        assertThat(new double[] {sampler.x, sampler.y, sampler.z}).containsExactly(sine * turn.cosine, sine * turn.sine, Math.sqrt(1 - point.u));
    }

    private static void assertSameNext(Sampler a, Sampler b) {
        a.next();
        b.next();
        assertThat(new double[] {a.u, a.v}).containsExactly(b.u, b.v);
    }

    /** The bytes of a few thousand points, everywhere and for ever: pictures depend on them. */
    @Test
    void pointsAreTheSameEverywhere() throws Exception {
        MessageDigest digest = MessageDigest.getInstance("SHA-256");
        for (Sampler sampler : new Sampler[] {Sampler.scrambled(16), Sampler.fixed(16)}) {
            for (int i = 0; i < 2000; i++) {
                sampler.start(i % 61, i / 61, i % 16);
                sampler.filter();
                digest(sampler, digest);
                sampler.lens();
                digest(sampler, digest);
                sampler.time();
                digest(sampler, digest);
                sampler.lights(Sampler.mirrored(i), i % 7, 1 + i % 33);
                digest(sampler, digest);
            }
        }
        assertThat(HexFormat.of().formatHex(digest.digest())).isEqualTo("c06d8571a894d6331d9c6e418f03a56da37c234e05add1f4f829704edc22f678");
    }

    private static void digest(Sampler sampler, MessageDigest digest) {
        sampler.next();
        digest.update(ByteBuffer.allocate(16).putDouble(sampler.u).putDouble(sampler.v).array());
    }
}
