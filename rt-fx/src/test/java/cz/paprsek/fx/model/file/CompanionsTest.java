package cz.paprsek.fx.model.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A scene that is saved in another folder takes its pictures along. */
class CompanionsTest {
    @TempDir
    private Path folder;
    private final Document document = new Document(new EditorModel(Scene.EMPTY));

    @BeforeEach
    void openASceneWithAPicture() throws Exception {
        Path file = folder.resolve("a/scene.xml");
        Files.createDirectories(folder.resolve("a/pictures"));
        Files.createDirectories(folder.resolve("b"));
        Files.writeString(folder.resolve("a/pictures/oak.png"), "oak");
        SceneFiles.write(Scene.EMPTY.plus("oak", Material.DEFAULT.withPattern(Pattern.Picture.of("pictures/oak.png")))
                .plus("gone", Material.DEFAULT.withPattern(Pattern.Picture.of("gone.png"))), file);
        document.opened(SceneSource.of(file).read());
    }

    @Test
    void picturesComeAlongAndAreFoundThere() throws Exception {
        document.save(SceneSource.file(folder.resolve("b/scene.xml")));
        assertThat(folder.resolve("b/pictures/oak.png")).hasContent("oak");
        assertThat(folder.resolve("b/gone.png")).doesNotExist();
        Files.delete(folder.resolve("a/pictures/oak.png"));
        assertThat(document.model().assets().bytes("pictures/oak.png").remaining()).isEqualTo(3);
    }

    @Test
    void whatIsThereAlreadyStays() throws Exception {
        Files.createDirectories(folder.resolve("b/pictures"));
        Files.writeString(folder.resolve("b/pictures/oak.png"), "another");
        assertThatThrownBy(() -> document.save(SceneSource.file(folder.resolve("b/scene.xml")))).isInstanceOf(IOException.class)
                .hasMessage("there is another picture pictures/oak.png beside it; give one of them another name");
        assertThat(folder.resolve("b/pictures/oak.png")).hasContent("another");
        assertThat(folder.resolve("b/scene.xml")).doesNotExist();
    }

    @Test
    void besideItNothingIsCopied() throws Exception {
        document.save(SceneSource.file(folder.resolve("a/copy.xml")));
        assertThat(folder.resolve("a/copy.xml")).exists();
    }
}
