package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.xml.recipe.Script;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Shipped files, each damaged in a hundred and twenty-five ways (or as many as the system property {@code paprsek.damages} says), long ones and those that are longer when
 * written out in a third as many: every one is read, or refused by line and column, and nothing else happens.
 */
class DamagedFilesTest {
    private static final int WAYS = Integer.getInteger("paprsek.damages", 125);
    private static final int LARGE = 60_000;
    private static final List<Damage> DAMAGES = List.of(Damage.values());
    private static final List<WayIn> WAYS_IN = List.of(WayIn.values());

    static Stream<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("../scenes"))) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    @Timeout(value = 10, unit = TimeUnit.MINUTES)
    void aDamagedFileIsReadOrRefused(Path file) throws IOException {
        byte[] good = Files.readAllBytes(file);
        int ways = good.length > LARGE || Script.mayBeIn(good) ? WAYS / 3 : WAYS;
        AtomicInteger refused = new AtomicInteger();
        AtomicLong slowest = new AtomicLong();
        IntStream.range(0, ways).parallel().forEach(seed -> {
            Random random = new Random(seed);
            Damage damage = DAMAGES.get(seed % DAMAGES.size());
            byte[] bad = damage.apply(good, random);
            long begin = System.nanoTime();
            try {
                if (seed % 50 < WAYS_IN.size() && WAYS_IN.get(seed % 50).takes(bad)) {
                    WAYS_IN.get(seed % 50).readAlone(bad);
                } else {
                    SceneReader.read(new ByteArrayInputStream(bad), "x", Making.PLAIN);
                }
            } catch (SceneFileException e) {
                refused.incrementAndGet();
                assertThat(e.problems()).as("%s, seed %d", damage, seed).isNotEmpty().allSatisfy(problem -> assertThat(problem.toString())
                        .matches("[^:]*:[1-9][0-9]*:[1-9][0-9]*: [^\\p{Cc}\\p{Cf}]+").doesNotContain("cvc-", "JAXP", "xerces", "null"));
            } catch (IOException | RuntimeException | StackOverflowError | OutOfMemoryError e) {
                throw new AssertionError(damage + ", seed " + seed + ": " + e, e);
            }
            slowest.accumulateAndGet(System.nanoTime() - begin, Math::max);
        });
        assertThat(refused.get()).as("the damage is felt").isBetween(ways / 4, ways - 1);
        System.out.printf("%s: %d damaged copies, %d refused, the slowest took %d ms%n", file, ways, refused.get(), slowest.get() / 1_000_000);
    }
}
