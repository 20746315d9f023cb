package cz.paprsek.cli.shard;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.Scenes;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.shard.PartFile.Pixels;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What is said of parts that do not make a picture. */
class MergeTest {
    private static final String SIZE = "100x70";

    @TempDir
    Path folder;

    private Path scene;
    private Path parts;
    private Path picture;

    @BeforeEach
    void aSceneWithASpaceInItsName() throws IOException {
        scene = Scenes.ball(folder.resolve("the ball.xml"));
        parts = folder.resolve("parts");
        picture = folder.resolve("picture.png");
    }

    private Run render(int shard, int count, Object... further) {
        Run run = Run.cli(Stream.concat(Stream.of("render", scene, "--size", SIZE, "--shard", shard + "/" + count, "-o", parts), Stream.of(further)).toArray());
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        return run;
    }

    private Run merge(Object... further) {
        return Run.cli(Stream.concat(Stream.of("merge", parts, "-o", picture), Stream.of(further)).toArray());
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(parts)) {
            return files.sorted().toList();
        }
    }

    private Run refused() {
        Run run = merge();
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.PARTS_LACKING);
        assertThat(picture).doesNotExist();
        assertThat(run.err()).doesNotContain("Exception", "\tat ");
        return run;
    }

    @Test
    void whatIsMissingIsToldWithTheLineThatMakesIt() throws IOException {
        render(2, 4);
        Run run = refused();
        assertThat(run.err().lines()).hasSize(2);
        assertThat(run.err()).contains(parts + ": 9 of 12 tiles are missing: ", "; this makes them, where the others were made:\nfor i in 1 3 4; do paprsek render '" + scene + "' --size "
                + SIZE + " --shard $i/4 -o " + parts + "; done\n");
        render(1, 4);
        render(4, 4);
        assertThat(refused().err()).endsWith("\npaprsek render '" + scene + "' --size " + SIZE + " --shard 3/4 -o " + parts + "\n");
        render(3, 4);
        assertThat(merge().code()).isEqualTo(ExitCode.DONE);
        assertThat(picture).exists();
    }

    @Test
    void aPartThatIsLostIsMissedAtItsPlace() throws IOException {
        render(1, 1);
        Files.delete(parts.resolve("tile-00032-00064-32x6.part"));
        assertThat(refused().err()).contains("1 of 12 tiles are missing: 32,64,32,6;");
    }

    @Test
    void partsOfAnotherSceneAndOtherOptionsAreNamed() throws IOException {
        render(1, 2);
        render(2, 2);
        Path other = folder.resolve("other");
        Path changed = Scenes.scene(folder.resolve("b.xml"), "<sphere radius=\"1.5\"/>");
        assertThat(Run.cli("render", changed, "--size", SIZE, "--shard", "1/64", "-o", other).code()).isEqualTo(ExitCode.DONE);
        Files.copy(only(other), parts.resolve("b.part"));
        assertThat(refused().err().lines()).singleElement().asString().isEqualTo(parts.resolve("b.part") + " is of another scene, or of other files beside it");
        Files.delete(parts.resolve("b.part"));
        Path third = folder.resolve("third");
        assertThat(Run.cli("render", scene, "--size", SIZE, "--max-depth", 3, "--shard", "1/64", "-o", third).code()).isEqualTo(ExitCode.DONE);
        Files.copy(only(third), parts.resolve("c.part"));
        assertThat(refused().err()).contains("c.part is rendered with --size 100x70 --samples 1 --max-depth 3, and not with --size 100x70 --samples 1 --max-depth 5");
    }

    private static Path only(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.findFirst().orElseThrow();
        }
    }

    @Test
    void partsOfAnotherVersionAreForeign() throws IOException {
        render(1, 1);
        Path part = files().get(0);
        byte[] bytes = Files.readAllBytes(part);
        Files.write(part, new String(bytes, StandardCharsets.ISO_8859_1).replaceFirst("paprsek part 2", "paprsek part 1").getBytes(StandardCharsets.ISO_8859_1));
        assertThat(refused().err()).contains(part + " is written by another version, in a format that this one does not read");
        Files.write(part, new String(bytes, StandardCharsets.ISO_8859_1).replaceFirst("program Paprsek .development.", "program Paprsek 0.0.1 beta  .").getBytes(StandardCharsets.ISO_8859_1));
        assertThat(refused().err()).contains(part + " is made by Paprsek 0.0.1 beta");
    }

    /** Whose share a part was does not matter: some were made when the work was dealt out to others, or by tiles. */
    @Test
    void partsThatWereDealtOtherwiseMakeTheSameBytes() throws IOException {
        Object[] light = {"--integrator", "path", "--samples", 192, "--by", "passes"};
        render(1, 5, light);
        int made = files(parts).size();
        render(2, 3, "--integrator", "path", "--samples", 192);
        render(2, 2, light);
        render(1, 2, light);
        assertThat(made).isPositive().isLessThan(files(parts).size());
        assertThat(merge().code()).isEqualTo(ExitCode.DONE);
        Path plain = folder.resolve("plain.png");
        assertThat(Run.cli("render", scene, "--size", SIZE, "--integrator", "path", "--samples", 192, "-o", plain).code()).isEqualTo(ExitCode.DONE);
        assertThat(picture).hasSameBinaryContentAs(plain);
    }

    private static List<Path> files(Path parts) throws IOException {
        try (Stream<Path> files = Files.walk(parts)) {
            return files.filter(Files::isRegularFile).toList();
        }
    }

    @Test
    void damagedPartsAreNamedAndMadeAgainByTheSameLine() throws IOException {
        render(1, 1);
        List<Path> all = files();
        byte[] right = Files.readAllBytes(all.get(0));
        Files.write(all.get(0), Arrays.copyOf(right, right.length - 7));
        byte[] flipped = Files.readAllBytes(all.get(1));
        flipped[flipped.length - 40] ^= 4;
        Files.write(all.get(1), flipped);
        Files.write(all.get(2), new byte[0]);
        Files.write(all.get(3), Arrays.copyOf(right, 300));
        assertThat(refused().err()).contains(all.get(0) + ": cut off, it has " + (right.length - 7) + " bytes in place of " + right.length, all.get(1) + ": damaged, its content is not what was written",
                all.get(2) + ": cut off, it has 0 bytes", all.get(3) + ": cut off, it has 300 bytes\n", "4 of 12 tiles are missing: ", "--shard 1/1 ");
        render(1, 1);
        assertThat(merge().code()).isEqualTo(ExitCode.DONE);
    }

    @Test
    void aDamagedPartThatIsNotNeededIsOnlyTold() throws IOException {
        render(1, 1);
        Path besides = Files.write(parts.resolve("z.part"), new byte[] {1, 2, 3});
        Run run = merge();
        assertThat(run.code()).isEqualTo(ExitCode.DONE);
        assertThat(run.err()).contains("note: " + besides + ": cut off, it has 3 bytes");
    }

    @Test
    void anEmptyDirectoryAndNoneAreTold() throws IOException {
        assertThat(merge().code()).isEqualTo(ExitCode.WRONG_USAGE);
        Files.createDirectories(parts);
        assertThat(refused().err()).contains("there is no part of a picture in it; paprsek render SCENE --shard I/N -o");
    }

    @Test
    void framesOfWhatIsNoFilmAreTold() throws IOException {
        render(1, 1);
        Run run = merge("--frames", "1-2");
        assertThat(run.code()).isEqualTo(ExitCode.PARTS_LACKING);
        assertThat(run.err()).isEqualTo(parts + ": none of its parts is of the frames asked for; without --frames, all that is there is put together\n");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aPictureThatHasNoRoomIsBlamedAndNotItsParts() {
        render(1, 1);
        picture = Path.of("/dev/full");
        Run run = merge("--format", "png");
        assertThat(run.code()).isEqualTo(ExitCode.FAILED);
        assertThat(run.err()).isEqualTo("/dev/full: no space left on device\n");
    }

    @Test
    void aFormatThatCannotHoldWhatThePartsHaveIsRefused() throws IOException {
        render(1, 1, "--aov", "depth");
        assertThat(merge().err()).contains("png has no layers, which these parts have; let the output end in .exr");
        assertThat(Run.cli("merge", parts, "-o", folder.resolve("a.exr")).code()).isEqualTo(ExitCode.DONE);
    }

    @Test
    void aScriptReadsWhatIsMissing() throws IOException {
        render(1, 3);
        Run run = merge("--json");
        assertThat(run.code()).isEqualTo(ExitCode.PARTS_LACKING);
        assertThat(run.out()).contains("\"outcome\":\"parts lacking\",\"parts\":4,\"problems\":[", "for i in 2 3; do");
        render(2, 3);
        render(3, 3);
        assertThat(merge("--json").out()).contains("\"outcome\":\"done\",\"output\":\"" + picture + "\",\"width\":100,\"height\":70,\"parts\":12}");
    }

    @Test
    void whoWaitsIsServedAsSoonAsAllIsThere() throws Exception {
        render(1, 2);
        Thread other = new Thread(() -> render(2, 2));
        other.start();
        assertThat(merge("--wait", 60).code()).isEqualTo(ExitCode.DONE);
        other.join();
    }

    @Test
    @Timeout(30)
    void nobodyWaitsWhilePartsOfAnotherPictureLieThere() throws IOException {
        render(1, 2);
        Path other = folder.resolve("other");
        assertThat(Run.cli("render", scene, "--size", SIZE, "--max-depth", 3, "--shard", "1/64", "-o", other).code()).isEqualTo(ExitCode.DONE);
        Files.copy(only(other), parts.resolve("c.part"));
        Run run = merge("--wait", 600);
        assertThat(run.code()).isEqualTo(ExitCode.PARTS_LACKING);
        assertThat(run.err()).contains("c.part is rendered with");
    }

    /** The scene's own text is the same. */
    @Test
    void partsOfASceneWhoseIncludedFileHasChangedAreForeign() throws IOException {
        Path defined = Files.writeString(folder.resolve("defs.xml"), INCLUDED.formatted(1));
        scene = Scenes.scene(folder.resolve("including.xml"), "<include file=\"defs.xml\"/>");
        render(1, 2);
        Files.writeString(defined, INCLUDED.formatted(2));
        Run other = Run.cli("render", scene, "--size", SIZE, "--shard", "2/2", "-o", folder.resolve("others"));
        assertThat(other.code()).as(other.err()).isEqualTo(ExitCode.DONE);
        try (Stream<Path> files = Files.list(folder.resolve("others"))) {
            for (Path file : files.toList()) {
                Files.copy(file, parts.resolve(file.getFileName()));
            }
        }
        assertThat(refused().err()).contains(" is of another scene, or of other files beside it");
    }

    private static final String INCLUDED = """
            <scene xmlns="urn:paprsek:scene:1"><camera position="0 0 9" target="0 0 0"/><sphere radius="%d"/></scene>
            """;

    @Test
    void whatAKilledShareLeftHalfWrittenIsRemoved() throws IOException {
        Files.createDirectories(parts);
        Path left = Files.writeString(parts.resolve("tile-00000-00000-32x32.part.999999999999-a1.tmp"), "half");
        Files.setLastModifiedTime(left, FileTime.from(Instant.now().minusSeconds(3600)));
        render(1, 1);
        assertThat(left).doesNotExist();
        assertThat(files()).hasSize(12);
    }

    /** Whatever is in a file: a sentence, in a moment, and no more memory than the file is long. */
    @Test
    void noDamageIsMoreThanASentence() throws IOException {
        render(1, 1);
        byte[] right = Files.readAllBytes(files().get(0));
        assertThat(PartFile.read(files().get(0), Pixels.IGNORED).tile().width()).isEqualTo(32);
        Path file = folder.resolve("damaged.part");
        Random random = new Random(7);
        for (int i = 0; i < Integer.getInteger("paprsek.damages", 300); i++) {
            byte[] wrong = damaged(right, random);
            if (!Arrays.equals(wrong, right)) {
                Files.write(file, wrong);
                assertThatThrownBy(() -> PartFile.read(file, Pixels.IGNORED)).isInstanceOf(IOException.class).message().isNotBlank().doesNotContain("Exception", "null");
            }
        }
    }

    private static byte[] damaged(byte[] right, Random random) {
        // Most of what can go wrong is in the head.
        int at = random.nextInt(random.nextBoolean() ? 800 : right.length);
        byte[] wrong = right.clone();
        switch (random.nextInt(4)) {
            case 0 -> wrong[at] ^= (byte) (1 << random.nextInt(8));
            case 1 -> Arrays.fill(wrong, at, Math.min(right.length, at + 1 + random.nextInt(8)), (byte) (random.nextBoolean() ? 0xFF : '9'));
            case 2 -> wrong = Arrays.copyOf(right, at);
            default -> {
                ByteArrayOutputStream more = new ByteArrayOutputStream();
                more.write(right, 0, at);
                more.write(right, random.nextInt(500), 1 + random.nextInt(300));
                more.write(right, at, right.length - at);
                wrong = more.toByteArray();
            }
        }
        return wrong;
    }
}
