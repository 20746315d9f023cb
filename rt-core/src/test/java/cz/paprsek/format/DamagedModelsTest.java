package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Files of all formats, each damaged in a thousand ways (or as many as the system property {@code paprsek.damages} says): every one is read, or refused in one line
 * that says where, and nothing else happens.
 */
class DamagedModelsTest {
    private static final int WAYS = Integer.getInteger("paprsek.damages", 1000);

    private static final String GLTF = "'nodes':[{'children':[1,2]},{'mesh':0,'translation':[10,0,0],'rotation':[0,0,0.7,0.7],'scale':[2,1,1]},{'mesh':0,'camera':0}],"
            + "'scenes':[{'nodes':[0]}],'meshes':[{'primitives':[{'attributes':{'POSITION':0},'indices':1,'material':0,'mode':4}]}],"
            + "'cameras':[{'type':'orthographic','orthographic':{'ymag':2}}],'materials':[{'pbrMetallicRoughness':{'baseColorFactor':[1,0.5,0.1,1],'metallicFactor':0}}]";

    static Stream<Arguments> files() {
        Triangles ring = Solids.torus(2, 1, 8, 6);
        String obj = "mtllib none.mtl\ng a b\nusemtl x\ns 1\n" + Solids.obj(ring) + "vt 0 1\nvn 0 0 1\ng c\nf 1/1/1 2/1/1 3/1/1 -4/1/1 -5/-1/-1\n";
        return Stream.of(Arguments.of(ForeignFormat.STL, Solids.stlText(ring).getBytes(StandardCharsets.US_ASCII)),
                Arguments.of(ForeignFormat.STL, Solids.stlBytes(ring, "solid bytes")), Arguments.of(ForeignFormat.OBJ, obj.getBytes(StandardCharsets.US_ASCII)),
                Arguments.of(ForeignFormat.PLY, Solids.ply(ring, null)), Arguments.of(ForeignFormat.PLY, Solids.ply(ring, ByteOrder.BIG_ENDIAN)),
                Arguments.of(ForeignFormat.PLY, Solids.ply(ring, ByteOrder.LITTLE_ENDIAN)), Arguments.of(ForeignFormat.GLTF, GltfTest.embedded(GLTF).getBytes(StandardCharsets.US_ASCII)),
                Arguments.of(ForeignFormat.OFF, Solids.off(ring).getBytes(StandardCharsets.US_ASCII)), Arguments.of(ForeignFormat.GLTF, GltfTest.inOnePiece(GltfTest.HEAD.replace(",'uri':'%s'", "") + GLTF + "}")));
    }

    @Test
    void everyFormatIsDamaged() {
        assertThat(Stream.concat(files(), scenes()).map(row -> row.get()[0]).distinct()).containsExactlyInAnyOrder((Object[]) ForeignFormat.values());
    }

    @ParameterizedTest(name = "{0} {index}")
    @MethodSource("files")
    @Timeout(value = 5, unit = TimeUnit.MINUTES)
    void aDamagedFileIsReadOrRefused(ForeignFormat format, byte[] good) {
        AtomicInteger refused = new AtomicInteger();
        AtomicLong slowest = new AtomicLong();
        IntStream.range(0, WAYS).parallel().forEach(seed -> {
            long begin = System.nanoTime();
            try {
                assertThat(Read.bytes(format, damaged(good, new Random(seed))).triangles().count()).isPositive();
            } catch (IOException e) {
                refused.incrementAndGet();
                assertThat(e.getMessage()).as("seed %d", seed).matches("((line|byte|face|triangle) \\d+|the end|[a-zA-Z]+(\\[\\d+\\])?[^:]*): [^\\p{Cc}\\p{Cf}]+").doesNotContain("null", "Exception");
            } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
                throw new AssertionError("seed " + seed + ": " + e, e);
            }
            slowest.accumulateAndGet(System.nanoTime() - begin, Math::max);
        });
        System.out.printf("%s: %d damaged copies, %d refused, the slowest took %d ms%n", format, WAYS, refused.get(), slowest.get() / 1_000_000);
        assertThat(refused.get()).as("the damage is felt").isPositive().isLessThan(WAYS);
    }

    static Stream<Arguments> scenes() {
        String csg = """
                multmatrix([[1, 0.5, 0, -24], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {
                  union() { cube(size = [15, 15, 15], center = true); sphere($fn = 0, $fa = 12, $fs = 2, r = 10); }
                }
                color([1, 0, 0, 0.5]) { difference() { cylinder($fn = 6, h = 4, r1 = 2, r2 = 1); sphere($fn = 8, r = 1); } }
                linear_extrude(height = 10, twist = 90, slices = 9, scale = [1, 0.5]) { polygon(points = [[0, 0], [4, 0], [0, 3], [1, 1]], paths = [[0, 1, 2], [3, 2, 1]]); }
                rotate_extrude(angle = 90, $fn = 20) { multmatrix([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { circle(r = 2); } }
                polyhedron(points = [[10, 10, 0], [10, -10, 0], [-10, -10, 0], [0, 0, 10]], faces = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 2]], convexity = 1);
                """;
        String nff = """
                v
                from 2.1 1.3 1.7
                at 0 0 0
                up 0 0 1
                angle 45
                hither 1
                resolution 51 51
                b 0.078 0.361 0.753
                l 4 3 2 1 1 0.5
                f 1 0.75 0.33 0.8 0 0 0 1
                p 4
                12 12 -0.5
                -12 12 -0.5
                -12 -12 -0.5
                12 -12 -0.5
                s 0 0 0 0.5
                c
                0 0 0 1
                0 0 3 0.5
                """;
        return Stream.of(Arguments.of(ForeignFormat.OPENSCAD, csg), Arguments.of(ForeignFormat.NFF, nff));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("scenes")
    @Timeout(value = 5, unit = TimeUnit.MINUTES)
    void aDamagedSceneIsReadOrRefused(ForeignFormat format, String good) {
        AtomicInteger refused = new AtomicInteger();
        IntStream.range(0, WAYS).parallel().forEach(seed -> {
            byte[] bad = damaged(good.getBytes(StandardCharsets.US_ASCII), new Random(seed));
            try {
                assertThat(ForeignScene.read("a", format, Assets.of(Map.of("a", bad))).scene().cameras()).isNotEmpty();
            } catch (IOException e) {
                refused.incrementAndGet();
                assertThat(e.getMessage()).as("seed %d", seed).startsWith("\"a\": ").matches("[^\\p{Cc}\\p{Cf}]+").doesNotContain("null", "Exception");
            } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
                throw new AssertionError("seed " + seed + ": " + e, e);
            }
        });
        System.out.printf("%s: %d damaged copies, %d refused%n", format, WAYS, refused.get());
        assertThat(refused.get()).as("the damage is felt").isPositive().isLessThan(WAYS);
    }

    private static byte[] damaged(byte[] good, Random random) {
        byte[] bad = good.clone();
        // Heads decide most: half of the damage is done there.
        int end = random.nextBoolean() ? Math.min(good.length, 300) : good.length;
        for (int i = random.nextInt(4); i >= 0; i--) {
            int at = random.nextInt(end);
            switch (random.nextInt(7)) {
                case 0 -> bad[at] ^= (byte) (1 << random.nextInt(8));
                case 1 -> bad[at] = (byte) (random.nextBoolean() ? 0xFF : 0x7F);
                case 2 -> Arrays.fill(bad, at, Math.min(bad.length, at + 1 + random.nextInt(8)), (byte) 0);
                case 3 -> bad = i == 0 ? Arrays.copyOf(bad, at + 1) : bad;
                case 4 -> {
                    int from = random.nextInt(bad.length);
                    System.arraycopy(bad.clone(), from, bad, at, Math.max(0, Math.min(20, Math.min(bad.length - from, bad.length - at))));
                }
                case 5 -> bad[at] = (byte) "0123456789-.e \n/\"{}[]();,"
                        .charAt(random.nextInt(25));
                default -> bad[at] = (byte) random.nextInt();
            }
            end = Math.min(end, bad.length);
        }
        return bad;
    }
}
