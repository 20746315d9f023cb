package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever is written, its folder is made if it is not there. */
class FoldersTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"convert ball.xml OUT.pov", "convert ball.xml OUT.xml", "convert ball.png OUT.jpg", "worksheet ball.xml --pixel 4,4 -o OUT.html", "explain ball.xml 4,4 --svg OUT.svg",
        "compare ball.png ball.png --heatmap OUT.png", "schema -o OUT.xsd", "db init OUT.xml", "db add OUT.xml ball.xml"})
    void aFolderIsMade(String words) throws Exception {
        Path scene = Scenes.ball(folder.resolve("ball.xml"));
        Run.cli("render", scene, "--size", "8x8", "-q", "-o", folder.resolve("ball.png"));

        Run made = run(words, folder.resolve("no/such/x"));
        assertThat(made.code()).as(made.err()).isZero();
        try (Stream<Path> files = Files.list(folder.resolve("no/such"))) {
            assertThat(files.filter(Files::isRegularFile)).hasSize(1);
        }

        Files.writeString(folder.resolve("file"), "no folder");
        Run refused = run(words, folder.resolve("file/x"));
        assertThat(refused.code()).isPositive();
        assertThat(refused.err()).contains(folder.resolve("file") + " is not a directory, so nothing can be written there").hasLineCount(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"plan ball.xml --shards 2 --slurm -o OUT", "generate-man -o OUT", "crosscheck ball.xml --recorded --heatmaps OUT", "db extract scenes.xml ball -o OUT/", "render ball.xml -o OUT/", "render ball.xml --shard 1/1 -o OUT/"})
    void nothingIsPutIntoAFile(String words) throws Exception {
        Path scene = Scenes.ball(folder.resolve("ball.xml"));
        Run.cli("db", "init", folder.resolve("scenes.xml"));
        Run.cli("db", "add", folder.resolve("scenes.xml"), scene);
        Path file = Files.writeString(folder.resolve("file"), "no folder");

        for (Path out : List.of(file, file.resolve("below"), file.resolve("far/below"))) {
            Run refused = run(words, out);
            assertThat(refused.code()).isPositive();
            assertThat(refused.err()).contains(file + " is not a directory, so no");
        }
        assertThat(file).hasContent("no folder");
    }

    private Run run(String words, Path out) {
        return Run.cli(List.of(words.split(" ")).stream().map(word -> word.startsWith("OUT") ? out + word.substring(3) : word.startsWith("ball.") || word.startsWith("scenes") ? folder.resolve(word) : word).toArray());
    }
}
