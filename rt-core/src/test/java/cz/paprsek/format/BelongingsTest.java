package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What goes along with a scene, and what does not: a scene of a stranger's says what it likes. */
class BelongingsTest {
    @TempDir
    Path folder;

    private Path from;
    private Path to;

    @BeforeEach
    void folders() throws IOException {
        from = Files.createDirectories(folder.resolve("theirs/below"));
        to = Files.createDirectories(folder.resolve("mine/below"));
    }

    private static Scene showing(String picture) throws Exception {
        return SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1"><camera position="0 0 5" target="0 0 0"/>
                <rectangle min="-1 -1" max="1 1"><material><image file="%s"/></material></rectangle></scene>""".formatted(picture));
    }

    private Belongings of(String picture) throws Exception {
        return new Belongings(showing(picture), Assets.beside(from.resolve("scene.xml")));
    }

    @Test
    void nothingIsWrittenOutsideOfTheFolder() throws Exception {
        Files.writeString(folder.resolve("theirs/profile"), "theirs");
        assertThat(of("../profile").take(to.resolve("scene.xml"))).containsExactly("\"../profile\": only files in the scene's folder and below can be read, and .. leads out");
        Files.createDirectory(from.resolve("deep"));
        assertThat(of("deep/../../profile").take(to.resolve("scene.xml"))).hasSize(1);
        assertThat(folder.resolve("mine/profile")).doesNotExist();
    }

    @Test
    void nothingIsFetchedFromOutsideOfTheFolder() throws Exception {
        Path secret = Files.writeString(folder.resolve("secret"), "mine");
        Files.createSymbolicLink(from.resolve("a.png"), secret);
        assertThat(of("a.png").take(to.resolve("scene.xml"))).singleElement().asString().startsWith("\"a.png\": this is a link that leads out");
        assertThat(of(secret.toString()).take(to.resolve("scene.xml"))).singleElement().asString().endsWith("this one is absolute");
        assertThat(to).isEmptyDirectory();
    }

    @Test
    void whatTheSceneShowsGoesAlongWhereverItComesFrom() throws Exception {
        Files.writeString(from.resolve("a.png"), "beside the scene");
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
        Files.writeString(elsewhere.resolve("a.png"), "what is shown");
        assertThat(new Belongings(showing("a.png"), Assets.in(elsewhere)).take(to.resolve("scene.xml"))).isEmpty();
        assertThat(to.resolve("a.png")).hasContent("what is shown");
    }

    @Test
    void aFileIsTakenAsItIsNowAndIfItIsGoneAsItWasRead() throws Exception {
        Assets assets = Assets.beside(from.resolve("scene.xml"));
        Files.writeString(from.resolve("a.png"), "read");
        assets.bytes("a.png");
        Files.writeString(from.resolve("a.png"), "now");
        new Belongings(showing("a.png"), assets).take(to.resolve("scene.xml"));
        assertThat(to.resolve("a.png")).hasContent("now");
        Files.delete(from.resolve("a.png"));
        Files.delete(to.resolve("a.png"));
        new Belongings(showing("a.png"), assets).take(to.resolve("scene.xml"));
        assertThat(to.resolve("a.png")).hasContent("read");
    }

    /** Nor does one of two that another program would call the same. */
    @Test
    void neitherOfTwoThatAreCalledTheSameIsTakenForTheOther() throws Exception {
        Files.writeString(from.resolve("a.png"), "one");
        Files.writeString(from.resolve("b.png"), "other");
        Scene both = showing("a.png").plus(showing("b.png").objects().get(0));
        assertThatThrownBy(() -> new Belongings(both, Assets.in(from)).takeUnpacked(to.resolve("scene.pov"), name -> "c.png")).hasMessageStartingWith("there is another picture b.png");
        assertThat(to).isEmptyDirectory();
        Files.writeString(from.resolve("b.png"), "one");
        assertThat(new Belongings(both, Assets.in(from)).takeUnpacked(to.resolve("scene.pov"), name -> "c.png")).isEmpty();
        assertThat(to.resolve("c.png")).hasContent("one");
    }

    @Test
    void anotherFileOfTheSameNameStays() throws Exception {
        byte[] large = new byte[200_000];
        Files.write(from.resolve("a.png"), large);
        Files.write(to.resolve("a.png"), large);
        assertThat(of("a.png").take(to.resolve("scene.xml"))).isEmpty();
        large[large.length - 1] = 1;
        Files.write(to.resolve("a.png"), large);
        assertThatThrownBy(() -> of("a.png").take(to.resolve("scene.xml"))).isInstanceOf(IOException.class)
                .hasMessage("there is another picture a.png beside it; give one of them another name");
        assertThat(to.resolve("a.png")).hasBinaryContent(large);
    }
}
