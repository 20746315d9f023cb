package cz.paprsek.cli.shard;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.process.ExitCode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures of paths whose passes are made by different machines: the bytes of one machine's. */
class PassesTest {
    private static final String SCENE = """
            <scene xmlns="urn:paprsek:scene:1">
              <render width="70" height="40" integrator="path" samples="256" fps="10"/>
              <camera position="0 1 6" target="0 0 0"/>
              <sun-light direction="-1 -2 -1" angle="5"/>
              <sphere name="ball" radius="1"><material color="0.8 0.3 0.2"/></sphere>
              <block min="-4 -1.2 -4" max="4 -1 4"/>
              <animate target="ball" attribute="position"><key t="0" value="-1 0 0"/><key t="1" value="1 0 0"/></animate>
            </scene>
            """;

    @TempDir
    Path folder;

    private Path scene;
    private Path parts;

    @BeforeEach
    void write() throws IOException {
        scene = Files.writeString(folder.resolve("scene.xml"), SCENE);
        parts = folder.resolve("parts");
    }

    /** As many shares as passes, fewer, and more, of which each gets some of all. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"pfm | --max-depth 3 | 2", "exr | --samples 128 --filter mitchell --region 17,9,50,30 | 3", "png | --samples 64 --exposure 1 --tone filmic | 1"})
    void sharesOfPassesInAnyOrderGiveTheBytesOfOneMachine(String ending, String words, int count) {
        Path whole = folder.resolve("whole." + ending);
        render(words, "-o", whole);
        for (int i = count; i > 0; i--) {
            render(words, "--by", "passes", "--shard", i + "/" + count, "-o", parts, "--threads", i);
        }
        assertMerged(whole, "merged." + ending);
    }

    /** What is missing of passes is named, with the line that makes it; what parts with all passes have is not made again. */
    @Test
    void partsOfPassesGoTogetherWithPartsOfAllAndWithOtherShares() {
        Path whole = folder.resolve("whole.pfm");
        render("", "-o", whole);
        render("", "--by", "passes", "--shard", "1/2", "-o", parts);
        Run lacking = Run.cli("merge", parts, "-o", folder.resolve("merged.pfm"));
        assertThat(lacking.code()).isEqualTo(ExitCode.PARTS_LACKING);
        assertThat(lacking.err()).contains("tiles are missing in 2 of 4 passes: 2 4;", "\npaprsek render " + scene + " --by passes --shard 2/2 -o " + parts + "\n");
        render("", "--shard", "2/3", "-o", parts);
        Run rest = render("", "--by", "passes", "--shard", "1/1", "-o", parts);
        assertThat(rest.out()).contains("shard 1/1  24 parts, 16 of them there before");
        assertMerged(whole, "merged.pfm");
        assertMerged(whole, "again.pfm");
    }

    @Test
    void aDamagedPassIsMadeAgainAndAnotherScenesIsRefused() throws IOException {
        Path whole = folder.resolve("whole.ppm");
        render("--samples 128", "-o", whole);
        render("--samples 128 --by passes", "--shard", "1/1", "-o", parts);
        Path part = parts.resolve("pass-00002/tile-00032-00000-32x32.part");
        byte[] right = Files.readAllBytes(part);
        byte[] wrong = right.clone();
        wrong[right.length - 50] ^= 1;
        Files.write(part, wrong);
        Run damaged = Run.cli("merge", parts, "-o", folder.resolve("merged.ppm"));
        assertThat(damaged.code()).isEqualTo(ExitCode.PARTS_LACKING);
        assertThat(damaged.err()).contains(part + ": damaged", "tiles are missing in 1 of 2 passes: 2;");
        assertThat(render("--samples 128 --by passes", "--shard", "1/1", "-o", parts).out()).contains("12 parts, 11 of them there before");
        assertThat(part).hasBinaryContent(right);
        assertMerged(whole, "merged.ppm");
        Run other = Run.cli("render", scene, "--samples", "192", "--by", "passes", "--shard", "1/1", "-o", parts);
        assertThat(other.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(other.err()).contains("rendered with --size 70x40 --integrator path --samples 128 ", "and not with --size 70x40 --integrator path --samples 192");
    }

    /** Also while the shutter is open, whose samples have times of their own. */
    @Test
    void framesOfAFilmAreDividedIntoPassesToo() throws IOException {
        String words = "--frames 2-3 --shutter 0.5 --samples 128";
        Path whole = Files.createDirectories(folder.resolve("whole"));
        Path merged = Files.createDirectories(folder.resolve("merged"));
        render(words, "-o", whole.resolve("f.png"));
        render(words, "--by", "passes", "--shard", "2/2", "-o", parts);
        assertThat(Run.cli("merge", parts, "-o", merged.resolve("f.png")).err()).contains("tiles are missing in 2 of 2 frames: 2 3;", " --by passes --shard 1/2 ");
        render(words, "--by", "passes", "--shard", "1/2", "-o", parts);
        Run run = Run.cli("merge", parts, "-o", merged.resolve("f.png"));
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        try (Stream<Path> files = Files.list(whole)) {
            assertThat(files.toList()).hasSize(2).allSatisfy(file -> assertThat(merged.resolve(file.getFileName())).hasSameBinaryContentAs(file));
        }
    }

    private void assertMerged(Path whole, String name) {
        Path merged = folder.resolve(name);
        Run run = Run.cli("merge", parts, "-o", merged);
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        assertThat(merged).hasSameBinaryContentAs(whole);
    }

    private Run render(String words, Object... further) {
        Run run = Run.cli(Stream.of(Stream.of("render", scene), Stream.of(words.split(" ", -1)).filter(word -> !word.isEmpty()), Stream.of(further)).flatMap(each -> each).toArray());
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        return run;
    }
}
