package cz.paprsek.cli.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The script for Windows, of which elsewhere only what it looks for in scenes can be tried. */
class BatchScriptTest {
    private static final Pattern SEARCH = Pattern.compile("findstr /r (.*) \"%scene%\" > nul(?: 2> nul)? (&&|\\|\\|) exit /b (\\d)");
    private static final Pattern WORD = Pattern.compile("/c:\"([^\"]*)\"");

    private static String script() throws Exception {
        return Files.readString(Path.of("src/main/launcher/paprsek.bat"), StandardCharsets.US_ASCII);
    }

    /** What the script says of a file without --size: its searches, one after the other, as far as one of them ends it. */
    private static boolean isShort(String text) throws Exception {
        String decision = script().substring(script().indexOf(":words\r\n"), script().indexOf(":sized\r\n"));
        Matcher search = SEARCH.matcher(decision);
        int count = 0;
        while (search.find()) {
            count++;
            // Its classes, points and stars mean what they do in Java.
            boolean isFound = WORD.matcher(search.group(1)).results().anyMatch(word -> text.lines().anyMatch(line -> Pattern.compile(word.group(1)).matcher(line).find()));
            if (isFound == search.group(2).equals("&&")) {
                return search.group(3).equals("0");
            }
        }
        assertThat(count).isEqualTo(5);
        return true;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\u0000', nullValues = "-", value = {
            "true  | <sphere/>",
            "true  | <render width=\"1280\" height=\"720\" samples=\"1\"/><sphere/>",
            "true  | <render width='999' height='999'/><sphere/>",
            "true  | <render width=\"1299\"/>",
            "false | <render width=\"1299\" height=\"770\"/>",
            "false | <render width=\"1300\" height=\"20\"/>",
            "false | <render width=\"820\" height=\"1280\"/>",
            "false | <render width=\"10000\" height=\"2\"/>",
            "false | <render width = \"8\"/>",
            "false | <render samples=\"16\"/>",
            "false | <render samples=\"1..4\"/>",
            "false | <render samples='{n}'/>",
            "false | <render integrator=\"path\"/>",
            "false | <camera aperture=\"1\"/>",
            "false | <mesh\tfile=\"m.stl\"/>",
            "false | <repeat count=\"9\"><sphere/></repeat>",
            "false | <sky zenith=\"1 2 3\"/>",
            "false | <database><scene name=\"a\"/></database>",
            "false | <sphere-light radius=\"1\"/>"})
    void whatStandsForMuchWorkIsFoundAsByTheOtherScript(boolean isQuick, String content) throws Exception {
        assertThat(isShort("<scene xmlns='urn:paprsek:scene:1'>\n" + content + "\n</scene>\n")).isEqualTo(isQuick);
        assertThat(isShort(content)).as("no scene").isFalse();
    }

    @Test
    void theOtherScriptLooksForTheSameElements() throws Exception {
        String other = Files.readString(Path.of("src/main/launcher/paprsek"));
        Matcher elements = Pattern.compile("'<\\(([a-z|-]+)\\)\\(\\[").matcher(other);
        assertThat(elements.find()).isTrue();
        assertThat(script()).contains("/c:\"<" + elements.group(1).replace("|", "\" /c:\"<") + "\"");
        Matcher longest = Pattern.compile("wc -c < \"\\$scene\"\\)\" -le (\\d+) ]").matcher(other);
        assertThat(longest.find()).isTrue();
        assertThat(script()).contains("(\"%scene%\") do if %%~zf gtr " + longest.group(1) + " exit /b 1");
    }

    /** Labels are not found by Windows in files whose lines end otherwise. */
    @Test
    void linesEndAsWindowsWants() throws Exception {
        assertThat(script().replace("\r\n", "")).doesNotContain("\n", "\r");
        assertThat(script()).contains("%compiler%", "set \"compiler=-XX:TieredStopAtLevel=1\"");
    }

    /** Words of the system answer {@code /?} themselves, and the folder of the script is known by the word that is never shifted away. */
    @Test
    void whoAsksForHelpIsAnsweredByTheProgram() throws Exception {
        int asked = script().indexOf("if [%1]==[/?] goto start\r\nif [%1]==[\"/?\"] goto start\r\nshift /1\r\n");
        assertThat(asked).isPositive().isLessThan(script().indexOf(" %*\r\n"));
        assertThat(script().substring(script().indexOf(":start\r\n"), script().indexOf("exit /b %errorlevel%"))).doesNotContain("call ", "set ");
    }

    /** A closing bracket within a list of words would be the end of the list, and of the script. */
    @Test
    void listsOfWordsHaveNoBrackets() throws Exception {
        assertThat(script()).contains("set words=%words:(=?%\r\nset words=%words:)=?%\r\nfor %%f in (%words%) do ").doesNotContain("in (%*)");
    }
}
