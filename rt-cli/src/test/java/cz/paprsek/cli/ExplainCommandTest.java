package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExplainCommandTest {
    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void writeAScene() throws IOException {
        file = Scenes.ball(folder.resolve("ball.xml"));
    }

    @Test
    void aPixelIsExplained() {
        Run run = Run.cli("explain", file, "8,4", "--color", "never");
        assertThat(run.code()).isZero();
        assertThat(run.out()).startsWith("E  from the eye, hits sphere #1  100 %\n").contains("pixel 8, 4: the light of E = ");
        assertThat(Run.cli("explain", file, "0,0").out()).contains("nothing: the background");
    }

    @Test
    void coloursAreAddedOnRequestAndNeverToPipes() {
        assertThat(Run.cli("explain", file, "8,4", "--color", "always").out()).contains("\u001b[1;33mE  from the eye").contains("\u001b[48;");
        assertThat(Run.cli("explain", file, "8,4", "--color", "never").out()).doesNotContain("\u001b");
    }

    @Test
    void namesFromTheFileCannotCommandTheTerminal() throws IOException {
        Path evil = Scenes.scene(folder.resolve("evil.xml"), "<sphere name=\"&#x9b;31mred\" radius=\"1\" position=\"0 1 0\"/>");
        Run run = Run.cli("explain", evil, "8,4", "--color", "always");
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.out() + run.err()).contains("U+009B").doesNotContain("\u009b");
    }

    @Test
    void aTreeForAScriptIsOneLine() {
        assertThat(Run.cli("explain", file, "8,4", "--size", "32x16", "--json").out())
                .startsWith("{\"column\":8,\"row\":4,").hasLineCount(1);
    }

    @Test
    void mistakesAreToldInOneLine() throws IOException {
        assertThat(Run.cli("explain", file, "16,0").code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(Run.cli("explain", file, "16,0").err()).contains("pixel 16,0 must lie inside the picture of 16 × 8 pixels");
        assertThat(Run.cli("explain", file, "8;4").err()).contains("expected COLUMN,ROW of a pixel such as 320,180, but found '8;4'");
        Path deep = Scenes.scene(folder.resolve("deep.xml"), "<material name=\"m\" reflection=\"0.5\" transparency=\"0.5\" refractive-index=\"1.2\"/>"
                + "<sphere radius=\"1\" material=\"m\"/><sphere radius=\"9\" material=\"m\"/>");
        Run tooMany = Run.cli("explain", deep, "8,4", "--max-depth", "60");
        assertThat(tooMany.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(tooMany.err()).contains("deep.xml: there are more than 100000 rays, too many to explain; ask for a lower max-depth or fewer samples");
        assertThat(Run.cli("explain", file, "1,1", "--samples", "64").err()).startsWith("paprsek: " + file + ": render samples must be a whole number from 1 to 16, but is 64\n");
        assertThat(Run.cli("explain", file, "1,1", "--samples", "1..17").code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(Run.cli("explain", folder.resolve("no.xml"), "1,1").code()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(Run.cli("explain", Scenes.broken(folder.resolve("bad.xml")), "1,1").err()).contains("bad.xml:2:");
    }

    @Test
    void aSceneOfADatabaseIsChosenByItsName() {
        Path database = Path.of("../scenes/database.xml");
        assertThat(Run.cli("explain", database, "100,100", "--size", "200x150", "--scene", "Gears").out()).contains("pixel 100, 100: the average of 4 rays");
        Run unnamed = Run.cli("explain", database, "1,1");
        assertThat(unnamed.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(unnamed.err()).containsPattern("is a database of \\d+ scenes; name one with --scene NAME");
        assertThat(Run.cli("explain", database, "1,1", "--scene", "Pearl").err()).contains("there is no scene named \"Pearl\"; did you mean \"Pearls\"?");
        assertThat(Run.cli("explain", file, "1,1", "--scene", "wall").code()).isEqualTo(ExitCode.WRONG_USAGE);
    }

    @Test
    void aSceneWithSeveralRaysAPixelIsToldSo() throws IOException {
        assertThat(Run.cli("explain", file, "8,4").err()).isEmpty();
        Path smooth = folder.resolve("smooth.xml");
        Files.writeString(smooth, Files.readString(file).replace("height=\"8\"", "height=\"8\" samples=\"3\""));
        Run typical = Run.cli("explain", smooth, "8,4");
        assertThat(typical.out()).contains("ray 9 of 9", "the average of 9 rays");
        assertThat(typical.err()).contains("--all tells of each of the 9 rays in full, --samples 1 of the one through the middle");
        Run all = Run.cli("explain", smooth, "8,4", "--all");
        assertThat(all.out()).contains("ray 9 of 9", "the average of 9 rays");
        assertThat(all.err()).isEmpty();
        Run middle = Run.cli("explain", smooth, "8,4", "--samples", "1");
        assertThat(middle.out()).contains("the light of E").doesNotContain("ray 1 of");
        assertThat(middle.err()).isEmpty();
    }

    @Test
    void mathematicsIsSpeltOutWhereTheTerminalHasNoSuchLetters() {
        assertThat(Letters.fit("│ 0.9·0.5²⁰ − sin θ₁ = 1.2·10⁻³°", StandardCharsets.US_ASCII.newEncoder()))
                .isEqualTo("| 0.9*0.5^20 - sin theta1 = 1.2*10^-3 deg");
        assertThat(Letters.fit("│ θ²⁰", StandardCharsets.UTF_8.newEncoder())).isEqualTo("│ θ²⁰");
    }

    @Test
    void picturesToLearnFromHaveAMode() {
        Path picture = folder.resolve("normals.ppm");
        assertThat(Run.cli("render", file, "--mode", "normals", "-o", picture).code()).isZero();
        assertThat(picture).exists();
        assertThat(Run.cli("render", file, "--mode", "rays", "-o", picture).out()).as("with its legend").contains("16x32");
        assertThat(Run.cli("render", file, "--mode", "rays", "--no-legend", "-o", picture).out()).contains("16x8");
        assertThat(Run.cli("render", file, "--mode", "norms").err()).contains("expected one of shaded, normals, depth");
    }

    @Test
    void oneLightOnlyIsChosenByNameOrNumber() throws IOException {
        Path lamps = Scenes.scene(folder.resolve("lamps.xml"), "<point-light name=\"key\" position=\"2 3 4\"/><point-light position=\"-2 3 4\"/>"
                + "<sphere radius=\"1\" position=\"0 1 0\"/>");
        assertThat(Run.cli("render", lamps, "--light", "key", "-o", folder.resolve("a.ppm")).code()).isZero();
        assertThat(Run.cli("render", lamps, "--light", "2", "-o", folder.resolve("b.ppm")).code()).isZero();
        assertThat(folder.resolve("a.ppm")).content(StandardCharsets.ISO_8859_1).isNotEqualTo(content(folder.resolve("b.ppm")));
        Run wrong = Run.cli("render", lamps, "--light", "3", "-o", folder.resolve("c.ppm"));
        assertThat(wrong.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(wrong.err()).contains("there is no light \"3\"; this scene has lights 1 to 2, named key");
    }

    @Test
    void aLightByItselfLeavesOtherLampsStandingAndAddsUpWithThem() throws IOException {
        Path lamps = Scenes.scene(folder.resolve("bulbs.xml"), "<ambient color=\"60 60 60\"/><background color=\"0 0 200\"/><sphere radius=\"1\" position=\"0 1 0\"/>"
                + "<point-light name=\"key\" position=\"2 3 4\"/><sphere-light name=\"bulb\" radius=\"0.5\" position=\"-1.5 1 1\"/>");
        Path none = Scenes.scene(folder.resolve("none.xml"), "<ambient color=\"60 60 60\"/><background color=\"0 0 200\"/><sphere radius=\"1\" position=\"0 1 0\"/>"
                + "<sphere-light radius=\"0.5\" position=\"-1.5 1 1\" intensity=\"0\"/>");
        Image all = rendered(lamps);
        Image key = rendered(lamps, "--light", "key");
        Image bulb = rendered(lamps, "--light", "2");
        Image dark = rendered(none);
        assertThat(key.red(4, 4)).as("where the bulb stands").isZero();
        assertThat(bulb.red(4, 4)).isGreaterThan(1);
        for (int y = 0; y < all.height(); y++) {
            for (int x = 0; x < all.width(); x++) {
                assertThat(key.green(x, y) + bulb.green(x, y) + dark.green(x, y)).as("%d,%d", x, y).isCloseTo(all.green(x, y), within(1e-5f));
            }
        }
    }

    private Image rendered(Path scene, String... words) throws IOException {
        Path picture = folder.resolve("linear.pfm");
        assertThat(Run.cli(Stream.concat(Stream.of("render", scene, "-o", picture), Stream.of(words)).toArray()).code()).isZero();
        return ImageFiles.read(picture);
    }

    private static String content(Path picture) throws IOException {
        return Files.readString(picture, StandardCharsets.ISO_8859_1);
    }
}
