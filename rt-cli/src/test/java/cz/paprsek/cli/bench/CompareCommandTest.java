package cz.paprsek.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.Scenes;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CompareCommandTest {
    @TempDir
    Path folder;

    private Path scene;

    @BeforeEach
    void writeTheBall() throws IOException {
        scene = Scenes.ball(folder.resolve("ball.xml"));
    }

    private Path rendered(String name, Object... more) {
        Object[] words = new Object[4 + more.length];
        Path picture = folder.resolve(name);
        System.arraycopy(new Object[] {"render", scene, "-o", picture}, 0, words, 0, 4);
        System.arraycopy(more, 0, words, 4, more.length);
        Run.cli(words);
        return picture;
    }

    @Test
    void onePictureInDifferentFormatsIsTheSame() {
        for (String name : new String[] {"a.png", "a.ppm", "a.ppm16", "a.tif", "a.pgm", "a.txt", "a.lum"}) {
            Run run = Run.cli("compare", rendered("a.pfm"), rendered(name));
            assertThat(run.code()).as(run.out()).isZero();
            assertThat(run.out()).startsWith("the same").contains("0 of 128 pixels, 0.000 %");
        }
    }

    @Test
    void sixteenBitsAreLinearWhereTheFileSaysSoAndSrgbElsewhere() {
        assertThat(Run.cli("compare", rendered("a.pfm"), rendered("b.ppm", "--format", "ppm16")).code()).isZero();
        Path others = Path.of("../rt-core/src/test/resources/cz/paprsek/image");
        Run run = Run.cli("compare", others.resolve("srgb16.png"), others.resolve("srgb16.ppm"), "--tolerance", "0");
        assertThat(run.code()).as(run.out()).isZero();
    }

    @Test
    void differentPicturesAreToldByTheExitCodeAndShown() throws IOException {
        Image changed = ImageFiles.read(rendered("a.png"));
        changed.set(3, 2, 1, 0, 1);
        ImageFiles.write(changed, folder.resolve("b.png"));
        Path map = folder.resolve("map.png");
        Run run = Run.cli("compare", folder.resolve("a.png"), folder.resolve("b.png"), "--heatmap", map);
        assertThat(run.code()).isEqualTo(1);
        assertThat(run.out()).isEqualTo("""
                different, in steps of 1/255 of sRGB:
                  largest           255 at column 3, row 2
                  mean              1.328
                  root mean square  18.403
                  beyond 1          1 of 128 pixels, 0.781 %
                """);
        assertThat(ImageFiles.read(map).red(3, 2)).isEqualTo(1);
        assertThat(ImageFiles.read(map).red(4, 2)).isZero();
        assertThat(Run.cli("compare", folder.resolve("a.png"), folder.resolve("b.png"), "--at-most", "0.8%").code()).isZero();
        assertThat(Run.cli("compare", folder.resolve("a.png"), folder.resolve("b.png"), "--at-most", "0.007", "-q").code()).isEqualTo(1);
        Run json = Run.cli("compare", folder.resolve("a.png"), folder.resolve("b.png"), "--json", "--tolerance", "255");
        assertThat(json.code()).isZero();
        assertThat(json.out()).contains("\"same\":true", "\"largest\":255,\"x\":3,\"y\":2", "\"beyond\":0,\"pixels\":128").hasLineCount(1);
    }

    @Test
    void whatCannotBeComparedIsSaidInOneLine() throws IOException {
        Path good = rendered("a.png");
        Run sizes = Run.cli("compare", good, rendered("b.png", "--size", "8x8"));
        assertThat(sizes.code()).isEqualTo(1);
        assertThat(sizes.err()).contains("the pictures differ in size: 16x8 and 8x8").hasLineCount(1);
        Run missing = Run.cli("compare", good, folder.resolve("c.png"));
        assertThat(missing.code()).isEqualTo(3);
        assertThat(missing.err()).isEqualTo(folder.resolve("c.png") + ": no such file\n");
        Run text = Run.cli("compare", good, Files.writeString(folder.resolve("d.png"), "hello"));
        assertThat(text.code()).isEqualTo(3);
        assertThat(text.err()).contains("not a picture of a kind that can be read").hasLineCount(1);
        Run scene = Run.cli("compare", good, Files.writeString(folder.resolve("d.xml"), "<scene xmlns='urn:paprsek:scene:1'/>"));
        assertThat(scene.err()).endsWith("not a picture of a kind that can be read, but looks like a scene; render it, and compare the picture\n").hasLineCount(1);
        assertThat(Run.cli("compare", good, good, "--tolerance", "-1").err()).contains("--tolerance must be 0 or above, but is -1");
        assertThat(Run.cli("compare", good, good, "--at-most", "2").err()).contains("expected a share such as 0.001 or 0.1%, but found '2'");
        assertThat(Run.cli("compare", good, good, "--heatmap", good.resolve("map.png")).code()).isEqualTo(1);
    }
}
