package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.image.Image;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.standard.StandardScenes;
import cz.paprsek.tree.Kernel;
import cz.paprsek.xml.SceneFiles;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Trees of all kinds, one thread and two, and both of Java's compilers show the same pictures, to the last bit. Which kind there is, a virtual machine knows from its start: so some are started. */
class KernelsTest {
    @Test
    void picturesAreTheSameWithVectorsAndWithout() throws Exception {
        Process vectors = start("--add-modules", "jdk.incubator.vector", "-Dpaprsek.kernel=vector", "-Dpaprsek.threads=2");
        Process scalar = start("-XX:TieredStopAtLevel=1", "-Dpaprsek.kernel=scalar", "-Dpaprsek.threads=1");
        Process compiled = start("-Dpaprsek.kernel=scalar", "-Dpaprsek.threads=1", "-Dpaprsek.some");
        List<String> with = vectors.inputReader().lines().toList();
        List<String> without = scalar.inputReader().lines().toList();
        List<String> twice = compiled.inputReader().lines().toList();
        assertThat(vectors.waitFor()).isZero();
        assertThat(compiled.waitFor()).isZero();
        assertThat(scalar.waitFor()).isZero();
        assertThat(without.get(0)).isEqualTo("scalar");
        assertThat(twice).hasSize(10).allMatch(without::contains);
        assumeTrue(with.get(0).contains("vectors"), "this machine has no vectors of eight floats or more");
        assertThat(with).hasSizeGreaterThan(75);
        assertThat(with.subList(1, with.size())).isEqualTo(without.subList(1, without.size()));
        if (with.get(0).contains("16")) {
            Process narrower = start("--add-modules", "jdk.incubator.vector", "-XX:MaxVectorSize=32", "-Dpaprsek.kernel=vector", "-Dpaprsek.threads=2", "-Dpaprsek.some");
            List<String> some = narrower.inputReader().lines().toList();
            assertThat(narrower.waitFor()).isZero();
            assertThat(some).startsWith("vectors of 8 floats").hasSize(10).allMatch(line -> line.startsWith("vectors") || with.contains(line));
        }
    }

    private static Process start(String... options) throws Exception {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        command.addAll(List.of(options));
        command.add("-Dpaprsek.width=" + (System.getProperty("paprsek.proof") == null ? 56 : 88));
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), Digests.class.getName()));
        return new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    }

    /** Prints which kernel this is, and the digest of every scene there is, or of the standard ones. */
    static final class Digests {
        private Digests() {}

        public static void main(String[] args) throws Exception {
            System.out.println(Kernel.inUse());
            List<Scene> scenes = new ArrayList<>(List.of(StandardScenes.few(), StandardScenes.flake(3), StandardScenes.cloud(5000),
                    StandardScenes.carved(100), StandardScenes.pierced(100), StandardScenes.chain(2), StandardScenes.chain(300),
                    StandardScenes.cloud(100_000), StandardScenes.mesh(200_000)));
            for (String folder : System.getProperty("paprsek.some") != null ? List.<String>of() : List.of("../scenes", "src/test/resources/crosscheck")) {
                try (Stream<Path> files = Files.list(Path.of(folder))) {
                    for (Path file : files.filter(f -> f.toString().endsWith(".xml")).sorted().toList()) {
                        scenes.addAll(SceneFiles.readAll(file));
                    }
                }
            }
            int threads = Integer.getInteger("paprsek.threads");
            int width = Integer.getInteger("paprsek.width");
            for (Scene scene : scenes) {
                RenderOptions options = RenderOptions.of(scene.withSettings(scene.settings().withSize(width, width * 7 / 11).withSamples(1))).withThreads(threads);
                System.out.println(scene.name() + ": " + digest(Renderer.render(ShippedPictures.ready(scene), options, RenderMonitor.NONE).image()));
            }
        }

        private static String digest(Image image) throws Exception {
            ByteBuffer bits = ByteBuffer.allocate(12 * image.width() * image.height());
            for (int y = 0; y < image.height(); y++) {
                for (int x = 0; x < image.width(); x++) {
                    bits.putFloat(image.red(x, y)).putFloat(image.green(x, y)).putFloat(image.blue(x, y));
                }
            }
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bits.array()));
        }
    }
}
