package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WorksheetCommandTest {
    private static final String SCENE = """
            <scene name="Ball" xmlns="urn:paprsek:scene:1"><render width="48" height="32" max-depth="2"/><background color="20 40 90"/><ambient color="60 60 60"/>
            <camera position="0 1 6" target="0 1 0"/><point-light position="3 5 4" intensity="0.8"/>
            <plane><material color="200 200 200"/></plane>
            <sphere radius="1" position="0 1 0"><material color="220 60 40" specular="0.5" shininess="20" reflection="0.2"/></sphere></scene>
            """;

    @TempDir
    Path folder;

    private Path scene;

    @BeforeEach
    void writeTheScene() throws IOException {
        scene = Files.writeString(folder.resolve("scene.xml"), SCENE);
    }

    private String sheet(String... options) throws IOException {
        Path page = folder.resolve("sheet.html");
        String[] words = new String[options.length + 4];
        System.arraycopy(options, 0, words, 4, options.length);
        words[0] = "worksheet";
        words[1] = scene.toString();
        words[2] = "-o";
        words[3] = page.toString();
        Run run = Run.cli((Object[]) words);
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out()).isEmpty();
        return Files.readString(page);
    }

    private static String solutions(String page) {
        return page.substring(page.indexOf("<div class=\"solution\">"));
    }

    @Test
    void exercisesHaveBlanksAndTheSolutionsAreOnASheetOfTheirOwn() throws IOException {
        String page = sheet("--pixel", "24,12");
        String exercises = page.substring(0, page.indexOf("<div class=\"solution\">"));
        assertThat(exercises).contains("Worksheet: Ball", "Pixel 24, 12", "<svg", "N·L", "S = kS·max(0, R·L)ⁿ", "class=\"blank\"").doesNotContain("class=\"result\"");
        assertThat(solutions(page)).contains("class=\"result\"").doesNotContain("class=\"blank\"", "<svg");
        assertThat(page.replace("http://www.w3.org/2000/svg", "")).as("nothing is fetched").doesNotContain("http", "src=", "@import");
    }

    /** Whoever reckons with the four decimals that stand there gets to the program's own pixel, to a step or two of 255. */
    @Test
    void fourDecimalsLeadToTheProgramsPixel() throws IOException {
        for (String pixel : new String[] {"24,12", "20,10", "30,20", "24,28", "5,30", "0,0"}) {
            String solved = solutions(sheet("--pixel", pixel));
            int[] reckoned = steps(solved, "<span class=\"result\">sRGB (\\d+) (\\d+) (\\d+)");
            int[] program = steps(solved, "the program has .*, sRGB (\\d+) (\\d+) (\\d+)");
            for (int i = 0; i < 3; i++) {
                assertThat(reckoned[i]).as(pixel + " " + solved).isBetween(program[i] - 2, program[i] + 2);
            }
            Run explained = Run.cli("explain", scene, pixel);
            assertThat(explained.out()).as("the same as explain").contains(program[0] + " " + program[1] + " " + program[2]);
        }
    }

    private static int[] steps(String text, String pattern) {
        Matcher found = Pattern.compile(pattern).matcher(text);
        assertThat(found.find()).isTrue();
        return new int[] {Integer.parseInt(found.group(1)), Integer.parseInt(found.group(2)), Integer.parseInt(found.group(3))};
    }

    @Test
    void eachSeedHasOtherNumbersButTheSameLines() throws IOException {
        String first = sheet("--pixel", "24,12", "--seed", "1");
        assertThat(sheet("--pixel", "24,12", "--seed", "1")).as("the same every time").isEqualTo(first);
        String second = sheet("--pixel", "24,12", "--seed", "2");
        assertThat(second).isNotEqualTo(first).contains("variant 2");
        assertThat(formulas(second)).isEqualTo(formulas(first));
    }

    private static String formulas(String page) {
        return solutions(page).replaceAll("<h[12]>.*|<td>.*|<p.*", "");
    }

    @Test
    void czechIsSpokenToo() throws IOException {
        assertThat(sheet("--pixel", "24,12", "--language", "cs")).contains("Pracovní list", "Řešení", "lang=\"cs\"");
    }

    @Test
    void whatCannotBeIsSaidInALine() {
        Path page = folder.resolve("x.html");
        assertThat(Run.cli("worksheet", scene, "--pixel", "24,12", "-o", folder.resolve("x.pdf")).err()).contains("name a file that ends in .html");
        assertThat(Run.cli("worksheet", scene, "--pixel", "99,12", "-o", page).err()).startsWith("paprsek: " + scene + ": pixel 99,12 must lie inside");
        assertThat(Run.cli("worksheet", scene, "--pixel", "24", "-o", page).err()).contains("expected COLUMN,ROW");
        assertThat(Run.cli("worksheet", folder.resolve("none.xml"), "--pixel", "2,2", "-o", page).code()).isEqualTo(3);
        assertThat(page).doesNotExist();
    }
}
