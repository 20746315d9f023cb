package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.IntToDoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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

    /** Or as near to it as makes no difference in four decimals. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"0 | (0, 0, 0)", "0.00001 | (0, 0, 1)"})
    void aLightMayStandInThePoint(String height, String direction) throws IOException {
        Files.writeString(scene, """
                <scene xmlns="urn:paprsek:scene:1"><render width="1" height="1"/><camera position="0 0 5" direction="0 0 -1"/>
                <point-light position="0 0 %s"/><rectangle min="-1 -1" max="1 1"/></scene>
                """.formatted(height));
        assertThat(solutions(sheet("--pixel", "0,0"))).contains("L = (Q − P)/|Q − P|", direction);
    }

    @Test
    void aFileThatEndsInPdfIsOne() throws IOException {
        Path file = folder.resolve("sheet.PDF");
        Run run = Run.cli("worksheet", scene, "--pixel", "24,12", "-o", file);
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(Files.readAllBytes(file)).startsWith('%', 'P', 'D', 'F', '-', '1', '.', '7').endsWith('%', '%', 'E', 'O', 'F', '\n');
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

    /** What stands under Σ and τ·Σ is what comes out of the numbers that stand there, to the last of the four decimals. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            color="220 60 40" emission="90 40 10"                                                             | own light
            color="10 10 10" transparency="0.9" refractive-index="1.3" attenuation-color="120 200 90" attenuation-distance="1" | ambient
            """)
    void printedNumbersGiveThePrintedSolution(String material, String term) throws IOException {
        Files.writeString(scene, SCENE.replace("color=\"220 60 40\"", material));
        String solved = solutions(sheet("--pixel", "24,16"));
        Matcher sums = Pattern.compile("Σ</td><td>= ([^=]*) = ([^=]*) = <span class=\"result\">([^<]*)<").matcher(solved);
        int rays = 0;
        boolean isThere = false;
        while (sums.find()) {
            rays++;
            isThere |= sums.group(1).contains(term);
            List<double[]> terms = triples(sums.group(2));
            assertThat(terms).as(sums.group()).hasSize(sums.group(1).split(" \\+ ").length);
            assertSame(triples(sums.group(3)).get(0), channel -> terms.stream().mapToDouble(one -> one[channel]).sum(), 1e-9);
        }
        assertThat(rays).as(solved).isGreaterThan(1);
        assertThat(isThere).as(solved).isTrue();
        Matcher products = Pattern.compile("Σ</td><td>=.* = <span class=\"result\">([^<]*)<.*\\s+<tr><td class=\"f\">light of E[RT]* = τ·Σ</td><td>= ([^=]*) = <span class=\"result\">([^<]*)<").matcher(solved);
        assertThat(products.results().peek(found -> {
            List<double[]> factors = triples(found.group(2));
            assertThat(factors.get(1)).as("the sum above").isEqualTo(triples(found.group(1)).get(0));
            assertSame(triples(found.group(3)).get(0), channel -> factors.get(0)[channel] * factors.get(1)[channel], 5.1e-5);
        }).count()).as(solved).matches(found -> found > 0 == material.contains("attenuation"));
    }

    private static void assertSame(double[] printed, IntToDoubleFunction reckoned, double most) {
        for (int channel = 0; channel < 3; channel++) {
            assertThat(printed[channel]).isCloseTo(reckoned.applyAsDouble(channel), Offset.offset(most));
        }
    }

    private static List<double[]> triples(String text) {
        return Pattern.compile("\\(([\\d.−]+), ([\\d.−]+), ([\\d.−]+)\\)").matcher(text).results().map(found -> IntStream.rangeClosed(1, 3)
                .mapToDouble(group -> Double.parseDouble(found.group(group).replace('−', '-'))).toArray()).toList();
    }

    /** Where the picture is exposed and toned, and where light is too faint or too bright for the formula of the last line. */
    @ParameterizedTest
    @CsvSource({"exposure=\"1.5\", 'B = 2^(1.5)·light of E'", "exposure=\"1\" tone=\"filmic\", B with tone filmic", "exposure=\"-9\", 'Below: v = 255·12.92·B'", "exposure=\"9\", Above 1: v = 255"})
    void theScreenShowsWhatTheProgramShows(String screen, String said) throws IOException {
        Files.writeString(scene, SCENE.replace("max-depth", screen + " max-depth"));
        String page = sheet("--pixel", "24,12");
        assertThat(page).contains(said);
        int[] reckoned = steps(solutions(page), "<span class=\"result\">sRGB (\\d+) (\\d+) (\\d+)");
        int[] program = steps(solutions(page), "the program has .*, sRGB (\\d+) (\\d+) (\\d+)");
        for (int i = 0; i < 3; i++) {
            assertThat(reckoned[i]).as(page).isBetween(program[i] - 2, program[i] + 2);
        }
        assertThat(Run.cli("explain", scene, "24,12").out()).contains(program[0] + " " + program[1] + " " + program[2]);
    }

    @Test
    void eachSeedHasOtherNumbersButTheSameLines() throws IOException {
        String first = sheet("--pixel", "24,12", "--seed", "1");
        assertThat(sheet("--pixel", "24,12", "--seed", "1")).as("the same every time").isEqualTo(first);
        String second = sheet("--pixel", "24,12", "--seed", "2");
        assertThat(second).isNotEqualTo(first).contains("variant 2");
        assertThat(formulas(second)).isEqualTo(formulas(first));
    }

    /** A class of thirty. */
    @Test
    void thirtySeedsHaveThirtySheetsThatAskTheSame() throws IOException {
        Set<String> pixels = new HashSet<>();
        Set<String> asked = new HashSet<>();
        for (int seed = 1; seed <= 30; seed++) {
            String page = sheet("--pixel", "24,12", "--seed", String.valueOf(seed));
            Matcher pixel = Pattern.compile("Pixel \\d+, \\d+").matcher(page);
            assertThat(pixel.find()).isTrue();
            pixels.add(pixel.group());
            asked.add(formulas(page));
        }
        assertThat(pixels).hasSizeGreaterThanOrEqualTo(20);
        assertThat(asked).hasSize(1);
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
        assertThat(Run.cli("worksheet", scene, "--pixel", "24,12", "-o", folder.resolve("x.txt")).err()).contains("name a file that ends in .pdf or .html");
        assertThat(Run.cli("worksheet", scene, "--pixel", "99,12", "-o", page).err()).startsWith("paprsek: " + scene + ": pixel 99,12 must lie inside");
        assertThat(Run.cli("worksheet", scene, "--pixel", "24", "-o", page).err()).contains("expected COLUMN,ROW");
        assertThat(Run.cli("worksheet", folder.resolve("none.xml"), "--pixel", "2,2", "-o", page).code()).isEqualTo(3);
        assertThat(page).doesNotExist();
    }
}
