package cz.paprsek.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.render.TileStore;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.resume.Checkpoint;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ResumeTest {
    private static final int DAMAGES = Integer.getInteger("paprsek.damages", 15);
    private static final Path SCENE = Path.of("../scenes/lens.xml");

    @TempDir
    Path folder;

    private Path picture;
    private Path tiles;
    private byte[] whole;

    @BeforeEach
    void renderWhole() throws Exception {
        picture = folder.resolve("picture.pfm");
        tiles = folder.resolve("picture.pfm.resume");
        assertThat(render("100x70").code()).isEqualTo(ExitCode.DONE);
        whole = Files.readAllBytes(picture);
        Files.delete(picture);
    }

    @Test
    void tilesAreGoneWhenThePictureIsWritten() {
        assertThat(render("100x70", "--resume").code()).isEqualTo(ExitCode.DONE);
        assertThat(picture).hasBinaryContent(whole);
        assertThat(tiles).doesNotExist();
    }

    @Test
    void goingOnGivesTheSameBytesWhereverTheFileOfTilesWasCut() throws Exception {
        byte[] all = allTiles();
        Random random = new Random(5);
        for (int i = 0; i < DAMAGES; i++) {
            int length = i == 0 ? all.length : random.nextInt(all.length);
            Files.write(tiles, Arrays.copyOf(all, length));
            Run run = render("100x70", "--resume");
            assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
            assertThat(picture).hasBinaryContent(whole);
            Files.delete(picture);
        }
    }

    @Test
    void damagedTilesAreRenderedAnew() throws Exception {
        byte[] all = allTiles();
        Random random = new Random(6);
        for (int i = 0; i < DAMAGES; i++) {
            byte[] damaged = all.clone();
            damaged[48 + random.nextInt(damaged.length - 48)] ^= (byte) (1 << random.nextInt(8));
            Files.write(tiles, damaged);
            assertThat(render("100x70", "--resume").code()).isEqualTo(ExitCode.DONE);
            assertThat(picture).hasBinaryContent(whole);
        }
    }

    @Test
    void tilesOfAnotherPictureAreRefusedAndLeftAlone() throws Exception {
        byte[] all = allTiles();
        Run run = render("100x71", "--resume");
        assertThat(run.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(run.err()).contains("picture.pfm.resume: holds tiles of another picture");
        assertThat(tiles).hasBinaryContent(all);
        assertThat(picture).doesNotExist();
    }

    @Test
    void tilesOfAnotherVersionAreRefusedAndLeftAlone() throws Exception {
        byte[] all = allTiles();
        all[14]--;
        Files.write(tiles, all);
        Run run = render("100x70", "--resume");
        assertThat(run.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(run.err()).contains("picture.pfm.resume: holds tiles written by another version, with which this one cannot go on; delete it");
        assertThat(tiles).hasBinaryContent(all);
    }

    @Test
    void whatIsDoneIsTold() throws Exception {
        allTiles();
        assertThat(render("100x70", "--resume").err()).contains("100 % is done already");
    }

    @Test
    void standardOutputCannotBeResumed() {
        Run run = Run.cli("render", SCENE, "-o", "-", "--resume");
        assertThat(run.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(run.err()).contains("--resume needs a file");
    }

    /** Of a part of a picture, whose pixels take as many samples as they need. */
    @Test
    void goingOnWithAPartOfAnAdaptivePictureGivesTheSameBytes() throws Exception {
        String[] part = {"--region", "13,9,70,55", "--samples", "2..4", "--filter", "gauss"};
        assertThat(render("100x70", part).code()).isEqualTo(ExitCode.DONE);
        byte[] expected = Files.readAllBytes(picture);
        Files.delete(picture);
        Scene scene = SceneFiles.read(SCENE);
        byte[] all = allTiles(scene, RenderOptions.of(scene.settings().withSize(100, 70).withSamples(2, 4).withFilter(PixelFilter.GAUSS))
                .withRegion(new Tile(13, 9, 70, 55)));
        Files.write(tiles, Arrays.copyOf(all, 2 * all.length / 3));
        Run run = render("100x70", Stream.concat(Stream.of(part), Stream.of("--resume")).toArray(String[]::new));
        assertThat(run.err()).contains("% is done already").doesNotContain("100 %");
        assertThat(picture).hasBinaryContent(expected);
    }

    /** The kept tiles hold whatever of a pixel there is. */
    @Test
    void goingOnWithLayersAndOpacityGivesTheSameBytes() throws Exception {
        Path file = picture.resolveSibling("layers.exr");
        Object[] words = {"render", SCENE, "-o", file, "--size", "100x70", "--transparent", "--aov", "normal,depth,object,samples"};
        assertThat(Run.cli(words).code()).isEqualTo(ExitCode.DONE);
        byte[] expected = Files.readAllBytes(file);
        Files.delete(file);
        picture = file;
        tiles = Checkpoint.fileFor(file);
        Scene scene = SceneFiles.read(SCENE);
        byte[] all = allTiles(scene, RenderOptions.of(scene.settings().withSize(100, 70)).withTransparency()
                .withLayers(List.of(Layer.NORMAL, Layer.DEPTH, Layer.OBJECT, Layer.SAMPLES)));
        Files.write(tiles, Arrays.copyOf(all, 2 * all.length / 3));
        Run run = Run.cli(Stream.concat(Stream.of(words), Stream.of("--resume")).toArray());
        assertThat(run.err()).contains("% is done already").doesNotContain("100 %");
        assertThat(file).hasBinaryContent(expected);
        assertThat(tiles).doesNotExist();
        Files.write(tiles, all);
        Run other = Run.cli("render", SCENE, "-o", file, "--size", "100x70", "--transparent", "--resume");
        assertThat(other.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(other.err()).contains("holds tiles of another picture");
    }

    private byte[] allTiles() throws IOException, SceneFileException {
        Scene scene = SceneFiles.read(SCENE);
        return allTiles(scene, RenderOptions.of(scene.settings().withSize(100, 70)));
    }

    /** Renders the whole picture without writing it: what is left of a process killed at the last moment. */
    private byte[] allTiles(Scene scene, RenderOptions options) throws IOException {
        try (Checkpoint checkpoint = Checkpoint.open(picture, scene, cz.paprsek.asset.Assets.none(), options, false)) {
            Renderer.render(scene, options, RenderMonitor.NONE, new TileStore() {
                @Override
                public boolean load(Tile tile, int pass, Film into) {
                    return false;
                }

                @Override
                public void save(Tile tile, int pass, Film from) throws IOException {
                    checkpoint.save(tile, from);
                }
            });
        }
        return Files.readAllBytes(tiles);
    }

    private Run render(String size, String... more) {
        return Run.cli(Stream.concat(Stream.of("render", SCENE, "-o", picture, "--size", size), Arrays.stream(more)).toArray());
    }
}
