package cz.paprsek.cli.shard;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.Scenes;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.render.Tile;
import cz.paprsek.render.mode.RenderMode;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Parts whose content is what was written, by somebody who wrote of a picture that there cannot be: a sentence, in a moment. */
class CraftedPartsTest {
    private static final String NOISE = "what it knows of noise is not all there, or not in order, or of a picture that has none";

    @TempDir
    Path folder;

    private Path parts;

    @BeforeEach
    void name() {
        parts = folder.resolve("parts");
    }

    /** The head of the only part of a small picture. */
    private PartHead head(String... words) throws IOException {
        Path scene = Scenes.ball(folder.resolve("ball.xml"));
        Run run = Run.cli(Stream.concat(Stream.of("render", scene, "--integrator", "path", "--samples", 64, "--shard", "1/1", "-o", parts), Stream.of(words)).toArray());
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        try (Stream<Path> files = Files.list(parts)) {
            return PartFile.head(files.findFirst().orElseThrow());
        }
    }

    private Run merge(PartHead head) throws IOException {
        try (Stream<Path> files = Files.list(parts)) {
            PartFile.write(files.findFirst().orElseThrow(), head, (channel, x, y) -> 0.5f);
        }
        Run run = Run.cli("merge", parts, "-o", folder.resolve("picture.pfm"));
        assertThat(run.err()).doesNotContain("Exception", "\tat ", "fault");
        return run;
    }

    private static PartHead changed(PartHead head, RenderMode mode, List<String> planes, int passes) {
        Card card = head.card();
        Card other = new Card(card.program(), card.settings(), card.exposure(), card.tone(), mode, card.numbers(), card.legend(), card.transparent(), card.region(), planes, passes, card.filter(),
                card.scene(), card.options());
        return new PartHead(other, head.told(), head.frame(), head.pass(), head.tile(), head.span(), head.shard(), head.words());
    }

    /** Every plane once, in order, behind the layers. */
    @Test
    void whatIsKnownOfNoiseIsAllThereOrNothing() throws IOException {
        PartHead head = head("--denoise");
        List<String> planes = head.card().planes();
        assertThat(merge(changed(head, RenderMode.SHADED, planes, 0)).code()).isEqualTo(ExitCode.DONE);
        List<UnaryOperator<List<String>>> wrong = List.of(all -> all.subList(0, 1), all -> all.subList(0, all.size() - 1), all -> {
            Collections.swap(all, 3, 4);
            return all;
        }, all -> {
            all.add("depth");
            return all;
        }, all -> {
            all.add(all.get(0));
            return all;
        }, all -> {
            all.set(5, all.get(4));
            return all;
        });
        for (UnaryOperator<List<String>> change : wrong) {
            Run run = merge(changed(head, RenderMode.SHADED, change.apply(new ArrayList<>(planes)), 0));
            assertThat(run.code()).isEqualTo(ExitCode.PARTS_LACKING);
            assertThat(run.err()).contains(".part: its head cannot be: " + NOISE);
        }
        assertThat(merge(changed(head, RenderMode.DEPTH, planes, 0)).err()).contains(NOISE);
        List<String> behindLayers = new ArrayList<>(List.of("normal.X"));
        behindLayers.addAll(planes);
        assertThat(Card.read(new Fields(changed(head, RenderMode.SHADED, behindLayers, 0).card().text().lines().toList())).layers()).containsExactly("normal.X");
    }

    @ParameterizedTest
    @ValueSource(ints = {Integer.MAX_VALUE, 15_626, -1})
    void aPictureHasNoMorePassesThanThereCanBePaths(int passes) throws IOException {
        assertThat(merge(changed(head(), RenderMode.SHADED, List.of(), passes)).err()).contains("its head cannot be: a picture has no more than 15625 passes, and not " + passes);
    }

    @Test
    void onlyAPictureOfLightAloneIsInPasses() throws IOException {
        PartHead head = head();
        String sentence = "its head cannot be: only a picture of light alone is in passes";
        assertThat(merge(changed(head, RenderMode.DEPTH, List.of(), 4)).err()).contains(sentence);
        assertThat(merge(changed(head, RenderMode.SHADED, List.of("depth"), 4)).err()).contains(sentence);
        String transparent = head.card().text().replace("transparent false", "transparent true");
        assertThatThrownBy(() -> Card.read(new Fields(transparent.lines().toList()))).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("of light alone");
    }

    /** Of all frames that a film can have, in as many passes as there can be, one part: what is missing is told, and nobody waits until all of it is counted one by one. */
    @Test
    @Timeout(20)
    void whoseWorkIsMissingOfTheLongestFilmIsToldOrGivenUpWhenAStopIsAskedFor() throws IOException {
        Deal deal = new Deal(new Tile(0, 0, 256, 256), new Span(1, 9_999_999), 15_625, 3);
        Stop stop = new Stop();
        assertThat(deal.owners(piece -> true, stop)).containsExactly(1, 2, 3);
        assertThat(new Deal(new Tile(0, 0, 256, 256), new Span(1, 9_999_999), 15_625, 1_000_000).owners(piece -> true, stop)).hasSize(1_000_000);
        stop.request();
        assertThatThrownBy(() -> deal.owners(piece -> false, stop)).isInstanceOf(InterruptedIOException.class);
    }
}
