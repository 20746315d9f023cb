package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pages for man and completion for fish: what the commands' own help says, and nothing that those programs stumble over. */
class ManualTest {
    @TempDir
    static Path folder;

    @BeforeAll
    static void pagesAreWritten() {
        Run run = Run.cli("generate-man", "-o", folder.resolve("man1"));
        assertThat(run.code()).isZero();
        assertThat(run.out() + run.err()).isEmpty();
    }

    private static List<Path> pages() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("man1"))) {
            return files.sorted().toList();
        }
    }

    @Test
    void everyCommandHasAPageWithAllItsOptions() throws IOException {
        assertThat(pages()).hasSizeGreaterThan(20);
        for (Path file : pages()) {
            String page = Files.readString(file);
            List<String> words = List.of(file.getFileName().toString().replace(".1", "").replace("generate-", "generate~").split("-"));
            List<Object> command = Stream.concat(words.stream().skip(1).map(word -> word.replace('~', '-')), Stream.of("--help")).collect(Collectors.toList());
            if (!command.contains("help")) {
                assertThat(options(page.replace("\\-", "-"))).as("%s", file).containsAll(options(Run.cli(command.toArray()).out()));
            }
            assertThat(page).startsWith(".TH PAPRSEK").contains("\n.SH \"NAME\"\npaprsek").doesNotContain("%n", "@|", "${");
        }
    }

    private static Set<String> options(String text) {
        return Pattern.compile("(?m)^ {2,6}(?:-\\w, )?(--[a-z-]+)|\\\\fB(--[a-z-]+)").matcher(text).results()
                .map(found -> found.group(1) == null ? found.group(2) : found.group(1)).collect(Collectors.toCollection(TreeSet::new));
    }

    /** A row for each, with all that it can be told; databases have a page of their own. */
    @Test
    void thePageOfCommandsHasAllTheirOptions() throws IOException {
        List<MatchResult> rows = Pattern.compile("(?m)^\\| `([a-z-]+)[ `].*$").matcher(Files.readString(Path.of("../docs/command-line.md"))).results()
                .filter(row -> !row.group(1).equals("db")).toList();
        assertThat(rows).hasSizeGreaterThan(14).allSatisfy(row -> {
            Set<String> known = options(Run.cli(row.group(1), "--help").out());
            known.removeAll(Set.of("--help", "--output"));
            assertThat(Pattern.compile("--[a-z][a-z-]*").matcher(row.group()).results().map(MatchResult::group)).as(row.group(1)).containsAll(known);
        });
    }

    @Test
    void theFormatterHasNothingToComplainOf() throws Exception {
        assumeTrue(Stream.of("/usr/bin/groff").map(Path::of).allMatch(Files::exists), "there is no groff");
        for (Path file : pages()) {
            Process process = new ProcessBuilder("groff", "-Kutf8", "-man", "-Tutf8", "-ww", "-z", file.toString()).redirectErrorStream(true).start();
            assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)).as("%s", file).isEmpty();
            assertThat(process.waitFor()).isZero();
        }
    }

    @Test
    void fishIsToldOfEveryCommandItsOptionsAndTheirWords() {
        String script = Run.cli("generate-completion", "--shell", "fish").out();
        assertThat(script.lines()).allMatch(line -> line.matches("complete -c paprsek -n '[^']+' (-f -a \\S+|( ?-[sl] \\S+)+( -r| -x -a '[^']+')?)( -d '([^']|\\\\')+')?"));
        assertThat(script).contains("__fish_seen_subcommand_from render' -l filter -x -a 'box gauss mitchell tent'", "from db; and __fish_seen_subcommand_from find'", "-f -a generate-man ");
        Matcher every = Pattern.compile("(?m)^ {2,6}(?:-\\w, )?--([a-z-]+)").matcher(Run.cli("explain", "--help").out());
        assertThat(every.results().map(option -> option.group(1)).toList()).isNotEmpty()
                .allSatisfy(option -> assertThat(script).contains("__fish_seen_subcommand_from explain' ", " -l " + option));
    }

    @Test
    void zshIsGivenWhatBashIsAndAnyOtherShellASentence() {
        assertThat(Run.cli("generate-completion", "--shell", "zsh").out()).isNotEmpty().isEqualTo(Run.cli("generate-completion").out());
        assertThat(Run.cli("generate-completion", "--shell", "tcsh").err()).contains("tcsh", "fish");
    }

    @Test
    void aFileInPlaceOfTheDirectoryIsToldOf() throws IOException {
        Path file = Files.writeString(folder.resolve("taken"), "");
        Run run = Run.cli("generate-man", "-o", file);
        assertThat(run.code()).isEqualTo(1);
        assertThat(run.err().lines()).singleElement().asString().contains(file.toString());
    }
}
