package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.value.Size;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MistakesTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "rendr                                | there is no command \"rendr\"; did you mean \"render\"?",
        "render a.xml --sise 3x3              | unknown option \"--sise\"; did you mean \"--size\"?",
        "render a.xml --width 640             | unknown option \"--width\"; here that is --size WIDTHxHEIGHT",
        "render a.xml --height=480            | unknown option \"--height\"; here that is --size WIDTHxHEIGHT",
        "render a.xml --spp 16                | unknown option \"--spp\"; here that is --samples",
        "info a.xml --spp 16                  | unknown option \"--spp\"",
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
        "render a.xml --samples 1000001       | render samples must be a whole number from 1 to 1000000, but is 1000001",
        "render a.xml --samples 17 --integrator whitted | render samples must be a whole number from 1 to 16, but is 17",
        "render a.xml --integrator pathe      | expected one of whitted, path, but found 'pathe'; did you mean \"path\"?",
        "render a.xml --max-depth 251         | render max-depth must be a whole number from 1 to 250, but is 251",
        "render a.xml --threads many          | expected a whole number, but found 'many'; without --threads, all processors are used",
        "render a.xml --threads auto          | without --threads, all processors are used",
        "render a.xml --samples 2.5           | '--samples': expected a number from 1 to 16, of paths to 1000000, or two such as 2..8, but found '2.5'",
        "render a.xml --samples 99999999999   | '--samples': expected a number from 1 to 16, of paths to 1000000, or two such as 2..8, but found '99999999999'",
        "render a.xml --samples 4..2          | render samples must go from the lesser to the greater number, but go from 4 to 2",
        "render a.xml --samples 2..17 --integrator whitted | must be a whole number from 0 to 16, but is 17",
        "render a.xml --samples 2..0          | '--samples': expected a number from 1 to 16, of paths to 1000000, or two such as 2..8, but found '2..0'",
        "render a.xml --samples 2..00         | '--samples': expected a number from 1 to 16, of paths to 1000000, or two such as 2..8, but found '2..00'",
        "explain a.xml 1,1 --samples 0..0     | '--samples': expected a number from 1 to 16, of paths to 1000000, or two such as 2..8, but found '0..0'",
        "explain a.xml 1,1 --samples 0..2     | render samples must be a whole number from 1 to 1000000, but is 0",
        "render a.xml --samples 2..4 --error 0   | '--error': expected a number above 0 such as 0.004 or 1/255, but found '0'",
        "render a.xml --samples 2..4 --error 1/0 | '--error': expected a number above 0 such as 0.004 or 1/255, but found '1/0'",
        "render a.xml --integrator whitted --samples 3 --error 0.1 | --error and --confidence are for --samples A..B, such as 2..8",
        "render a.xml --confidence 1          | render confidence must be a number above 0 and below 1, but is 1",
        "render a.xml --filter gaus           | expected one of box, tent, gauss, mitchell, but found 'gaus'; did you mean \"gauss\"?",
        "render a.xml --sampler random        | '--sampler': expected one of scrambled, fixed, but found 'random'",
        "render a.xml --sampler fix           | expected one of scrambled, fixed, but found 'fix'; did you mean \"fixed\"?",
        "render a.xml --mode shade            | but found 'shade'; did you mean \"shaded\"?",
        "render a.xml --tone filmc            | expected one of none, filmic, but found 'filmc'; did you mean \"filmic\"?",
        "explain a.xml 1,1 --color alway      | expected one of auto, always, never, but found 'alway'; did you mean \"always\"?",
        "bench --against povry                | expected one of povray, mitsuba, but found 'povry'; did you mean \"povray\"?",
        "compare a.png b.png --tolerance none | expected a number, but found 'none'",
        "render a.xml -s 3x3                  | unknown option \"-s\"; did you mean \"--size\"?",
        "render a.xml -size 3x3               | unknown option \"-size\"; did you mean \"--size\"?",
        "render a.xml -O b.png                | unknown option \"-O\"; did you mean \"-o\"?",
        "render a.xml --out b.png             | unknown option \"--out\"; did you mean \"--output\"?",
        "render a.xml --mistake full-fovi     | normal-not-turned, normal-by-matrix and 58 more, but found 'full-fovi'; did you mean \"full-fovy\"?",
        "render a.xml -D teeth                | Invalid value for option '-D': expected NAME=VALUE, but found 'teeth'",
        "render -dash.xml                     | unknown option \"-dash.xml\"; if it is a file, say ./-dash.xml",
        "render a.xml -dash.xml               | unknown option \"-dash.xml\"; if it is a file, say ./-dash.xml",
        "render a.xml b.png                   | is b.png meant as the output? say -o b.png",
        "render a.xml -o {nme}.png            | there is no {nme}; did you mean \"{name}\"?",
        "--size 3x3 render a.xml              | unknown option \"--size\"; it belongs behind a command: bench, crosscheck, explain, render",
        "help rendr                           | there is no command \"rendr\"; did you mean \"render\"?",
        "bench --scene fwe                    | there is no standard scene \"fwe\"; did you mean \"few\"? there are few,",
        "render a.xml --exposure 1,5          | expected a number, but found '1,5'; a point stands before decimals: 1.5",
        "render a.xml --exposure 1d           | expected a number, but found '1d'",
        "render http://x.org/a.xml            | 'http://x.org/a.xml' is an address, and nothing is fetched; give the path of a file",
        "render a.xml -o file:///tmp/a.png    | 'file:///tmp/a.png' is an address, and nothing is fetched; give the path of a file",
        "convert a.xml -o a.pov               | unknown option \"-o\"; the file stands there without an option: paprsek convert SCENE FILE",
        "merge parts -o a.png --wait -1       | --wait must be a number of seconds, 0 or above, but is -1",
        "explain a.xml 1,1 --svg rays.png     | --svg draws the rays in SVG: name a file that ends in .svg, not rays.png",
        "a.xml                                | there is no command \"a.xml\"; to render it, say paprsek render a.xml",
    })
    void wrongUsageIsExplainedInOneSentence(String line, String sentence) {
        Run run = Run.cli((Object[]) line.trim().split(" "));
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains(sentence).contains("--help'.").hasLineCount(2);
        assertThat(run.out()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "validate", "info", "convert", "explain", "crosscheck"})
    void anEmptyNameIsCalledSo(String command) {
        Run run = Run.cli(command, "", "b.xml");
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("an empty name").hasLineCount(2);
    }

    @Test
    void aSizeMayHaveTheSignOfMultiplication() {
        assertThat(Size.parse("640×480")).isEqualTo(new Size(640, 480));
    }

    @Test
    void callWithoutCommandSaysWhatThereIs() {
        Run run = Run.cli();
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("say what to do: render, merge, plan, validate, info, explain, convert, bench, compare, grade, worksheet, lesson, crosscheck, db, schema, generate-completion, generate-man, help");
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "merge", "plan", "validate", "info", "explain", "convert", "bench", "compare", "grade", "worksheet", "lesson", "crosscheck", "db", "schema", "generate-completion", "generate-man"})
    void everyCommandExplainsItself(String command) {
        Run run = Run.cli(command, "--help");
        assertThat(run.code()).isZero();
        assertThat(run.out()).contains("Usage: paprsek " + command, "Exit codes:", "Example", "-h, --help").doesNotContain("\u00d7");
        assertThat(Run.cli("help", command).out()).isEqualTo(run.out());
        assertThat(run.out().lines()).allMatch(line -> line.length() <= 80).noneMatch(line -> line.endsWith(" ."));
        // What is wider than a terminal would go on at its left edge, where nobody can paste it.
        assertThat(run.out().substring(run.out().indexOf("\nExample")).lines().skip(2)).isNotEmpty().allMatch(line -> line.startsWith("  "));
    }

    @Test
    void theProgramExplainsItselfAndItsVersion() {
        assertThat(Run.cli("--help").out()).contains("Commands:", "render", "validate", "info", "convert", "bench", "compare", "grade", "crosscheck", "schema", "generate-completion", "generate-man", "--version").doesNotContain(":\n  bench");
        assertThat(Run.cli("--version").out()).startsWith("Paprsek ").contains("Java " + Runtime.version());
    }

    @Test
    void shellsCanCompleteTheOptions() {
        Run run = Run.cli("generate-completion");
        assertThat(run.code()).isZero();
        assertThat(run.out() + run.text()).contains("--max-depth", "\"ppm16\"");
    }
}
