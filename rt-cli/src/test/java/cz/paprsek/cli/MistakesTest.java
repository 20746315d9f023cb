package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MistakesTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "rendr                                | there is no command \"rendr\"; did you mean \"render\"?",
        "render a.xml --sise 3x3              | unknown option \"--sise\"; did you mean \"--size\"?",
        "render a.xml --raytrace              | unknown option \"--raytrace\"",
        "schema now                           | unexpected \"now\"",
        "render                               | Missing required parameter: 'SCENE'",
        "render a.xml --size 12               | expected WIDTHxHEIGHT such as 1280x720, but found '12'",
        "render a.xml --size 0x7              | render width must be a whole number from 1 to 32768, but is 0",
        "render a.xml --size 99999x7          | render width must be a whole number from 1 to 32768, but is 99999",
        "render a.xml --region 1,2,3          | expected X,Y,WIDTH,HEIGHT in pixels",
        "render a.xml --size 9x9 --region 5,5,5,1 | region 5,5,5,1 must lie inside the picture",
        "render a.xml --format jgp            | did you mean \"jpg\"?",
        "render a.xml --threads 0             | threads must be a whole number from 1 to 1024, but is 0",
        "render a.xml --samples 17            | render samples must be a whole number from 1 to 16, but is 17",
        "render a.xml --max-depth 251         | render max-depth must be a whole number from 1 to 250, but is 251",
        "render a.xml --threads many          | 'many' is not an int",
    })
    void wrongUsageIsExplainedInOneSentence(String line, String sentence) {
        Run run = Run.cli((Object[]) line.trim().split(" "));
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains(sentence).contains("--help'.").hasLineCount(2);
        assertThat(run.out()).isEmpty();
    }

    @Test
    void callWithoutCommandSaysWhatThereIs() {
        Run run = Run.cli();
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("say what to do: render, validate, info, explain, convert, bench, compare, crosscheck, db, schema, generate-completion, help");
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "validate", "info", "explain", "convert", "bench", "compare", "crosscheck", "db", "schema"})
    void everyCommandExplainsItself(String command) {
        Run run = Run.cli(command, "--help");
        assertThat(run.code()).isZero();
        assertThat(run.out()).contains("Usage: rt-cli " + command, "Exit codes:", "Example", "-h, --help").doesNotContain("\u00d7");
        assertThat(Run.cli("help", command).out()).isEqualTo(run.out());
        assertThat(run.out().lines()).allMatch(line -> line.length() <= 100);
    }

    @Test
    void theProgramExplainsItselfAndItsVersion() {
        assertThat(Run.cli("--help").out()).contains("Commands:", "render", "validate", "info", "convert", "bench", "compare", "crosscheck", "schema", "generate-completion", "--version");
        assertThat(Run.cli("--version").out()).startsWith("Paprsek ").contains("Java " + Runtime.version());
    }

    @Test
    void shellsCanCompleteTheOptions() {
        Run run = Run.cli("generate-completion");
        assertThat(run.code()).isZero();
        assertThat(run.out() + run.text()).contains("--max-depth", "\"ppm16\"");
    }
}
