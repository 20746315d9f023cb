package cz.paprsek.teach.grade;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.StoredImage;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.PlainTracer;
import cz.paprsek.teach.grade.Grade.Verdict;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/** The scenes are those that are shipped; the grader was made with others. */
class GraderTest {
    private static final int SINGLES = 12;
    private static final int PAIRS = 8;
    private static final Path SCENES = Path.of("../scenes");

    /** What was found of what was made. */
    private record Tally(int found, int made, List<String> missed) {}

    @Test
    void mistakesAreFoundInASceneWithBalls() throws Exception {
        Scene scene = SceneFiles.read(SCENES.resolve("csg.xml"));
        List<Mistakes> some = Stream.of(Mistake.FULL_FOVY, Mistake.HALF_PIXEL, Mistake.NO_ROTATION, Mistake.NO_SHADOW, Mistake.GAMMA_POWER).map(Mistakes::of).toList();
        Tally tally = tried(scene, 32, some);
        assertThat(tally.missed()).isEmpty();
        Tally pair = tried(scene, 32, List.of(Mistakes.of(Mistake.FLIP_X).and(Mistake.GAMMA_DOUBLED)));
        assertThat(pair.missed()).isEmpty();
    }

    @Test
    void whatDoesNotShowIsRight_andKnownNotToShow() throws Exception {
        Scene scene = SceneFiles.read(SCENES.resolve("csg.xml"));
        RenderSettings settings = scene.settings().withSize(32, 18).withSamples(1);
        Grader grader = new Grader(scene, settings, true, () -> false);
        assertThat(grader.grade(picture(scene, settings, Mistakes.of(Mistake.SNELL_UPSIDE_DOWN))).verdict()).isEqualTo(Verdict.RIGHT);
        assertThat(grader.silent()).contains(Mistake.SNELL_UPSIDE_DOWN, Mistake.NO_REFLECTION, Mistake.SPOT_HARD).doesNotContain(Mistake.NO_SHADOW, Mistake.FULL_FOVY);
    }

    /** One ray a pixel is tried, too; what that explains nearly with one mistake does not stand in the way of two that explain all with the rays that were taken. */
    @Test
    void pairsAreFoundWhateverTheSamples() throws Exception {
        Scene scene = SceneFiles.read(SCENES.resolve("csg.xml"));
        RenderSettings settings = scene.settings().withSize(480, 270).withSamples(2);
        Mistakes two = Mistakes.of(Mistake.FLIP_Y).and(Mistake.NO_HIGHLIGHT);
        Set<String> finished = ConcurrentHashMap.newKeySet();
        Grader.Watcher watcher = (samples, together, done, all) -> {
            if (done == all) {
                finished.add(samples + ": " + together);
            }
        };
        assertThat(new Grader(scene, settings, false, () -> false).grade(picture(scene, settings, two), watcher).explanations()).contains(two);
        assertThat(finished).as("all mistakes alone, and pairs of them, are told, for either number of rays").containsExactlyInAnyOrder("1: 1", "1: 2", "2: 1", "2: 2");
    }

    /** Takes minutes: to be had by {@code -Dpaprsek.proof}. Prints what was found of what was made, scene by scene. */
    @Test
    @EnabledIfSystemProperty(named = "paprsek.proof", matches = ".*")
    void nineInTenMistakesAndThreeInFourPairsAreFoundInAllScenes() throws Exception {
        Random random = new Random(23);
        List<Tally> singles = new ArrayList<>();
        List<Tally> pairs = new ArrayList<>();
        for (Scene scene : known()) {
            long from = System.nanoTime();
            RenderSettings settings = scene.settings().withSize(64, 36).withSamples(1);
            List<Mistake> loud = new ArrayList<>(List.of(Mistake.values()));
            loud.removeAll(new Grader(scene, settings, true, () -> false).silent());
            Collections.shuffle(loud, random);
            singles.add(tried(scene, 64, loud.stream().limit(SINGLES).map(Mistakes::of).toList()));
            List<Mistakes> two = new ArrayList<>();
            for (int i = 0; i + 1 < Math.min(2 * PAIRS, loud.size()); i += 2) {
                two.add(Mistakes.of(loud.get(i)).and(loud.get(i + 1)));
            }
            pairs.add(tried(scene, 64, two));
            System.out.printf("%s: alone %s, in pairs %s; %d s%n", scene.name(), singles.get(singles.size() - 1), pairs.get(pairs.size() - 1), (System.nanoTime() - from) / 1_000_000_000);
        }
        assertThat(share(singles)).as(singles.toString()).isGreaterThan(0.9);
        assertThat(share(pairs)).as(pairs.toString()).isGreaterThan(0.75);
    }

    private static double share(List<Tally> tallies) {
        return tallies.stream().mapToInt(Tally::found).sum() / (double) tallies.stream().mapToInt(Tally::made).sum();
    }

    private static List<Scene> known() throws IOException, SceneFileException {
        List<Scene> known = new ArrayList<>();
        try (Stream<Path> files = Files.list(SCENES)) {
            for (Path file : files.filter(file -> file.toString().endsWith(".xml")).sorted().toList()) {
                SceneFiles.readAll(file).stream().filter(scene -> PlainTracer.unknown(scene, scene.settings()).isEmpty()).forEach(known::add);
            }
        }
        return known;
    }

    /** Found is what is among explanations that cannot be told apart; of two mistakes, one does not count if the other makes the same picture without it. */
    private static Tally tried(Scene scene, int width, List<Mistakes> all) {
        RenderSettings settings = scene.settings().withSize(width, width * 9 / 16).withSamples(1);
        Grader grader = new Grader(scene, settings, true, () -> false);
        List<String> missed = new ArrayList<>();
        int made = 0;
        for (Mistakes mistakes : all) {
            StoredImage picture = picture(scene, settings, mistakes);
            boolean isHidden = mistakes.all().size() > 1
                    && mistakes.all().stream().anyMatch(one -> ImageComparison.of(picture, picture(scene, settings, Mistakes.of(one)), 2).shareBeyond() < 0.005);
            if (isHidden) {
                continue;
            }
            made++;
            Grade grade = grader.grade(picture);
            if (!grade.explanations().contains(mistakes)) {
                missed.add(mistakes + " taken for " + grade);
            }
        }
        return new Tally(made - missed.size(), made, missed);
    }

    private static StoredImage picture(Scene scene, RenderSettings settings, Mistakes mistakes) {
        Image light = PlainTracer.of(scene, settings, mistakes).render(() -> false);
        Image shown = Image.ofEightBit(light.width(), light.height());
        for (int i = 0; i < light.width() * light.height(); i++) {
            int x = i % light.width();
            int y = i / light.width();
            shown.set(x, y, light.red(x, y), light.green(x, y), light.blue(x, y));
        }
        return new StoredImage(shown, StoredImage.Precision.EIGHT_BIT, false);
    }
}
