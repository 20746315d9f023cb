package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** What is understood without picocli must be what it would have understood. */
class PlainRenderTest {
    private final Terminal terminal = Terminal.system();
    private final Stop stop = new Stop();

    private RenderCommand byPicocli(String... words) {
        CommandLine line = new Cli(terminal, stop).commandLine(List.of("render"));
        line.parseArgs(words);
        return (RenderCommand) Objects.requireNonNull(line.getSubcommands().get("render")).getCommandSpec().userObject();
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.xml", "a.xml -o b.png", "-q a.xml", "--quiet a.xml b.xml --output dir/", "a.xml --size 12x34 --threads 0", "--threads 1024 scenes/*.xml --size 9\u00d79 -o {name}.jpg -q"})
    void plainCallsAreUnderstoodAsPicocliWould(String line) {
        String[] words = ("render " + line).split(" ");
        RenderCommand plain = new RenderCommand(terminal, stop, PlainRender.of(words).orElseThrow());
        assertThat(plain).usingRecursiveComparison().ignoringFields("spec").ignoringAllOverriddenEquals().isEqualTo(byPicocli(words));
    }

    @ParameterizedTest
    @ValueSource(strings = {"info a.xml", "render", "render -q", "render a.xml -q -q", "render a.xml -o", "render a.xml -o -", "render - -o a.png", "render a.xml -ob.png", "render a.xml --size=8x8",
        "render a.xml --size 8", "render a.xml --size 0x8", "render a.xml --threads 1.5", "render a.xml --threads -1", "render a.xml --threads 10000", "render a.xml -o a.png --output b.png",
        "render a.xml --json", "render @words", "render a.xml -o @words", "render --help", "render a.xml --mode depth", "render a.xml -- b.xml"})
    void allElseIsPicoclis(String line) {
        assertThat(PlainRender.of(line.split(" "))).isEmpty();
    }

    @Test
    void noWordsAndEmptyOnesAreNotPlain() {
        assertThat(PlainRender.of()).isEmpty();
        assertThat(PlainRender.of("render", "")).isEmpty();
        assertThat(PlainRender.of("render", "a.xml", "-o", "")).isEmpty();
    }

    /** In the sentences and with the code of any call. */
    @Test
    void whatIsWrongIsToldAsOfOtherCalls() {
        Run plain = Run.cli("render", "a.xml", "b.png");
        Run other = Run.cli("render", "a.xml", "b.png", "--mode", "shaded");
        assertThat(plain.code()).isEqualTo(2);
        assertThat(plain.err()).contains("say -o b.png", "Try 'paprsek render --help'.").isEqualTo(other.err());
        assertThat(Run.cli("render", "nowhere.xml").err()).isEqualTo(Run.cli("render", "nowhere.xml", "--max-depth", "5").err());
        assertThat(Run.cli("render", "nowhere.xml", "--threads", "0").err()).isEqualTo(Run.cli("render", "nowhere.xml", "--threads=0").err());
    }
}
