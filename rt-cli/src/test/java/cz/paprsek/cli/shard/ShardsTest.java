package cz.paprsek.cli.shard;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.process.ExitCode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures in shares, put together: the bytes of one machine's. */
class ShardsTest {
    private static final Path SCENE = Path.of("../scenes/lens.xml");

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "png | --size 100x70",
        "jpg | --size 100x70 --samples 2 --region 17,9,70,50",
        "ppm | --size 70x40 --samples 2..4 --error 1/64 --filter mitchell",
        "pfm | --size 70x40 --integrator path --samples 130",
        "hdr | --size 70x40 --integrator path --samples 64..256 --error 1/16 --exposure -1 --tone filmic",
        "exr | --size 70x40 --samples 2..3 --transparent --aov normal,depth,object,error,light",
        "exr | --size 70x40 --integrator path --samples 64 --aov albedo,direct,samples",
        "png | --size 70x40 --mode rays",
        "bmp | --size 70x40 --mode depth --no-legend",
        "pfm | --size 70x40 --mode nodes --format pfm",
        "png | --size 70x40 --integrator path --samples 64 --mode error",
        "png | --size 70x40 --integrator path --samples 64 --denoise",
        "exr | --size 70x40 --integrator path --samples 64..128 --error 1/16 --denoise --transparent --aov albedo,light",
    })
    void sharesInAnyOrderGiveTheBytesOfOneMachine(String ending, String words) throws IOException {
        Path whole = folder.resolve("whole." + ending);
        assertThat(render(words, "-o", whole).code()).isEqualTo(ExitCode.DONE);
        Path parts = folder.resolve("not/there/yet");
        for (String shard : List.of("3/3", "1/3", "2/3")) {
            Run run = render(words, "--shard", shard, "-o", parts, "--threads", 1 + shard.charAt(0) % 2);
            assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        }
        Path merged = folder.resolve("merged." + ending);
        Run run = Run.cli("merge", parts, "-o", merged);
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        assertThat(merged).hasSameBinaryContentAs(whole);
    }

    private static final String FILM = """
            <scene xmlns="urn:paprsek:scene:1">
              <render width="70" height="40" fps="10"/>
              <camera name="eye" position="0 1 6" target="0 0 0"/>
              <point-light position="4 5 6"/>
              <sphere name="ball" radius="1"/>
              <sphere radius="0.3" position="{2*t} 1 1"/>
              <animate target="ball" attribute="position"><key t="0" value="-1 0 0"/><key t="1" value="1 0 0"/></animate>
              <animate target="camera:eye" attribute="position"><key t="0" value="0 1 6" ease="smooth"/><key t="2" value="3 1 6"/></animate>
            </scene>
            """;

    /** Few frames, of which each share gets tiles, and many, of which it gets whole ones; with an open shutter, too, and a single one. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"--frames 2-4 | 3", "--frames 3-18 | 16", "--frames 2-3 --shutter 0.5 --samples 2..3 | 2", "--frame 7 | 1"})
    void framesInSharesAreTheBytesOfOneMachine(String words, int count) throws IOException {
        Path scene = Files.writeString(folder.resolve("film.xml"), FILM);
        Path whole = Files.createDirectories(folder.resolve("whole"));
        Path merged = Files.createDirectories(folder.resolve("merged"));
        Path parts = folder.resolve("parts");
        assertThat(film(scene, words, "-o", whole.resolve("f.png")).code()).isEqualTo(ExitCode.DONE);
        assertThat(film(scene, words, "--shard", "2/2", "-o", parts).code()).isEqualTo(ExitCode.DONE);
        Run lacking = Run.cli("merge", parts, "-o", merged.resolve("f.png"));
        assertThat(lacking.code()).isEqualTo(ExitCode.PARTS_LACKING);
        assertThat(lacking.err()).contains("tiles are missing in ", "\npaprsek render " + scene + " " + words + " --shard 1/2 -o " + parts + "\n");
        Run rest = film(scene, words, "--shard", "1/2", "-o", parts);
        assertThat(rest.code()).as(rest.err()).isEqualTo(ExitCode.DONE);
        Run run = Run.cli("merge", parts, "-o", merged.resolve("f.png"));
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        try (Stream<Path> files = Files.list(whole)) {
            List<Path> all = files.toList();
            assertThat(all).hasSize(count);
            assertThat(all).allSatisfy(file -> assertThat(merged.resolve(file.getFileName())).hasSameBinaryContentAs(file));
        }
    }

    @Test
    void someFramesCanBePutTogetherBeforeTheOthersAreThere() throws IOException {
        Path scene = Files.writeString(folder.resolve("film.xml"), FILM);
        Path parts = folder.resolve("parts");
        assertThat(film(scene, "--frames 1-16", "--shard", "2/2", "-o", parts).code()).isEqualTo(ExitCode.DONE);
        Run run = Run.cli("merge", parts, "--frames", "4", "-o", folder.resolve("{frame}.ppm"));
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        assertThat(folder.resolve("0004.ppm")).exists();
        assertThat(Run.cli("merge", parts, "--frames", "3-4", "-o", folder.resolve("{frame}.ppm")).err()).contains("tiles are missing in 1 of 2 frames: 3;", "--shard 1/2 ");
        Run other = film(scene, "--frames 1-16 --fps 20", "--shard", "2/2", "-o", parts);
        assertThat(other.err()).contains("of another scene");
        try (Stream<Path> files = Files.list(parts.resolve("frame-000004"))) {
            for (Path file : files.toList()) {
                Files.write(file, Arrays.copyOf(Files.readAllBytes(file), 300));
            }
        }
        assertThat(Run.cli("merge", parts, "--frames", "4", "-o", folder.resolve("{frame}.ppm")).err()).contains(": cut off, it has 300 bytes").doesNotContain("none of its parts");
    }

    /** Shares of its beginning, then of all of it: all of it is put together, and the line of what is missing names all its frames. */
    @Test
    void aFilmCanBeMadeLonger() throws IOException {
        Path scene = Files.writeString(folder.resolve("film.xml"), FILM);
        Path parts = folder.resolve("parts");
        Files.createDirectories(folder.resolve("merged"));
        assertThat(film(scene, "--frames 1-16", "--shard", "1/1", "-o", parts).code()).isEqualTo(ExitCode.DONE);
        Run wished = Run.cli("merge", parts, "--frames", "1-18", "-o", folder.resolve("merged/{frame}.ppm"));
        assertThat(wished.code()).isEqualTo(ExitCode.PARTS_LACKING);
        assertThat(wished.err()).contains("tiles are missing in 2 of 18 frames: 17 18;", "\npaprsek render " + scene + " --frames 1-18 --shard 1/1 -o " + parts + "\n");
        assertThat(film(scene, "--frames 1-18", "--shard", "2/2", "-o", parts).code()).isEqualTo(ExitCode.DONE);
        assertThat(Run.cli("merge", parts, "-o", folder.resolve("merged/{frame}.ppm")).err()).contains("tiles are missing in 1 of 18 frames: 17;", " --frames 1-18 ");
        assertThat(film(scene, "--frames 1-18", "--shard", "1/2", "-o", parts).code()).isEqualTo(ExitCode.DONE);
        Files.write(parts.resolve("frame-000003/z.part"), new byte[] {1, 2, 3});
        Run run = Run.cli("merge", parts, "-o", folder.resolve("merged/{frame}.ppm"));
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        assertThat(run.err().lines().filter(line -> line.startsWith("note: "))).hasSize(1);
        try (Stream<Path> files = Files.list(folder.resolve("merged"))) {
            assertThat(files).hasSize(18);
        }
    }

    private static Run film(Path scene, String words, Object... further) {
        return Run.cli(Stream.of(Stream.of("render", scene), Stream.of(words.split(" ", -1)), Stream.of(further)).flatMap(each -> each).toArray());
    }

    @Test
    void bitsAndCompressionAreSaidWhenPartsArePutTogether() throws IOException {
        Path parts = folder.resolve("parts");
        assertThat(render("--size 70x40", "--shard", "1/1", "-o", parts).code()).isEqualTo(ExitCode.DONE);
        for (Object[] how : new Object[][] {{"a.png", "--bits", 16}, {"a.exr", "--bits", 32, "--uncompressed"}}) {
            Path whole = folder.resolve("whole-" + how[0]);
            Path merged = folder.resolve("merged-" + how[0]);
            Object[] further = Stream.of(how).skip(1).toArray();
            assertThat(render("--size 70x40", Stream.concat(Stream.of("-o", whole), Stream.of(further)).toArray()).code()).isEqualTo(ExitCode.DONE);
            assertThat(Run.cli(Stream.concat(Stream.of("merge", parts, "-o", merged), Stream.of(further)).toArray()).code()).isEqualTo(ExitCode.DONE);
            assertThat(merged).hasSameBinaryContentAs(whole);
        }
        assertThat(render("--size 70x40", "--shard", "1/2", "-o", parts, "--bits", "16").err()).contains("are said when the parts are put together");
    }

    /** Who was given more shares than another goes on with what that has left, whatever its parts look like. */
    @Test
    void sharesOfDifferentNumbersFitTogether() throws IOException {
        Path whole = folder.resolve("whole.pfm");
        assertThat(render("--size 500x200", "-o", whole).code()).isEqualTo(ExitCode.DONE);
        Path parts = folder.resolve("parts");
        assertThat(render("--size 500x200", "--shard", "2/2", "-o", parts).code()).isEqualTo(ExitCode.DONE);
        Run rest = render("--size 500x200", "--shard", "1/1", "-o", parts);
        assertThat(rest.out()).contains("of them there before");
        assertThat(Run.cli("merge", parts, "-o", folder.resolve("merged.pfm")).code()).isEqualTo(ExitCode.DONE);
        assertThat(folder.resolve("merged.pfm")).hasSameBinaryContentAs(whole);
    }

    @Test
    void whatIsThereAlreadyIsNotMadeAgainUnlessItIsDamaged() throws IOException {
        Path parts = folder.resolve("parts");
        assertThat(render("--size 100x70", "--shard", "1/2", "-o", parts).out()).contains("shard 1/2  6 parts  ");
        Map<Path, FileTime> before = times(parts);
        Path damaged = before.keySet().iterator().next();
        byte[] right = Files.readAllBytes(damaged);
        byte[] wrong = right.clone();
        wrong[right.length - 100] ^= 1;
        Files.write(damaged, wrong);
        assertThat(render("--size 100x70", "--shard", "1/2", "-o", parts).out()).contains("6 parts, 5 of them there before");
        assertThat(render("--size 100x70", "--shard", "1/2", "-o", parts, "--json").out()).contains("\"outcome\":\"done\",\"shard\":\"1/2\",\"parts\":6,\"made\":0,");
        assertThat(damaged).hasBinaryContent(right);
        Map<Path, FileTime> after = times(parts);
        before.remove(damaged);
        assertThat(after).containsAllEntriesOf(before);
    }

    @Test
    void partsOfAnotherPictureAreNotReplaced() throws IOException {
        Path parts = folder.resolve("parts");
        assertThat(render("--size 100x70", "--shard", "1/2", "-o", parts).code()).isEqualTo(ExitCode.DONE);
        Map<Path, FileTime> before = times(parts);
        Run other = render("--size 100x70 --samples 2", "--shard", "1/2", "-o", parts);
        assertThat(other.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(other.err().lines()).singleElement().asString().contains(".part is rendered with --size 100x70 --samples 3..6 ", ", and not with --size 100x70 --samples 2 ", "to begin anew");
        assertThat(times(parts)).isEqualTo(before);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--shard 0/3 -o parts                     | shard 0/3 must be one of 1/N to N/N",
        "--shard 4/3 -o parts                     | shard 4/3 must be one of 1/N to N/N",
        "--shard three -o parts                   | expected I/N, the share I of N, such as 3/8, but found 'three'",
        "--shard 1/3                              | --shard needs a directory for its parts",
        "--shard 1/3 -o -                         | --shard needs a directory for its parts",
        "--shard 1/3 -o a.png                     | -o is a directory for parts, not a picture such as a.png",
        "--shard 1/3 -o parts --resume            | --shard is without --resume",
        "--shard 1/3 -o parts ../scenes/glass.xml | --shard is for one scene, but there are 2",
        "--shard 1/3 -o pom.xml                   | pom.xml is not a directory",
        "--by passes                              | --by says how the work of --shard is dealt out, which is not there",
        "--shard 1/3 -o parts --by rows           | --by",
        "--shard 1/3 -o parts --by passes         | of light alone; this picture is not of --integrator path: --by tiles goes with it",
        "--shard 1/3 -o parts --by passes --integrator path --samples 100           | --samples 100 is no multiple of 64",
        "--shard 1/3 -o parts --by passes --integrator path --error 1/16            | with --error, how many a pixel gets is known only when those before are there",
        "--shard 1/3 -o parts --by passes --integrator path --samples 64 --denoise  | --aov, --transparent and --denoise are more",
    })
    void whatCannotBeDoneInSharesIsRefused(String words, String sentence) {
        Run run = render(words);
        assertThat(run.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(run.err()).contains(sentence);
    }

    @Test
    void aSceneThatIsWrongHasACodeOfItsOwn() {
        assertThat(Run.cli("render", folder.resolve("none.xml"), "--shard", "1/2", "-o", folder.resolve("parts")).code()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(folder.resolve("parts")).doesNotExist();
    }

    /** A file whose bytes the system does not give: another machine may have more luck. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void aSceneThatCannotBeReadHereMayBeTriedAgain() {
        Run run = Run.cli("render", "/proc/self/mem", "--shard", "1/2", "-o", folder.resolve("parts"));
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.FAILED);
    }

    private static Run render(String words, Object... further) {
        List<Object> all = new ArrayList<>(List.of("render", SCENE));
        all.addAll(List.of(words.trim().split(" +")));
        all.addAll(List.of(further));
        return Run.cli(all.toArray());
    }

    private static Map<Path, FileTime> times(Path folder) throws IOException {
        Map<Path, FileTime> times = new TreeMap<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                times.put(file, Files.getLastModifiedTime(file));
            }
        }
        return times;
    }
}
