package cz.paprsek.fx.view.dialog;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is saved as: the name as typed, with an ending. */
class FileBoxTest {
    private final FileChooser chooser = new FileChooser();
    private final ExtensionFilter scenes = new ExtensionFilter("Scenes", "*.xml");
    private final ExtensionFilter tables = new ExtensionFilter("Tables", "*.json");
    private final ExtensionFilter all = new ExtensionFilter("All", "*.*");
    private final List<Path> asked = new ArrayList<>();

    FileBoxTest() {
        chooser.getExtensionFilters().addAll(scenes, tables, all);
    }

    @Test
    void aNameGetsTheEndingThatIsChosenWhateverDotsThereAre() {
        assertThat(saved(Path.of("/home/jan.novak/lens"), false)).contains(Path.of("/home/jan.novak/lens.xml"));
        assertThat(saved(Path.of("/home/jan.novak/lesson 1.2"), false)).contains(Path.of("/home/jan.novak/lesson 1.2.xml"));
        assertThat(saved(Path.of("lens.xml"), false)).contains(Path.of("lens.xml"));
        chooser.setSelectedExtensionFilter(tables);
        assertThat(saved(Path.of("lens"), false)).contains(Path.of("lens.json"));
        chooser.setSelectedExtensionFilter(all);
        assertThat(saved(Path.of("lens.pov"), false)).contains(Path.of("lens.pov.xml"));
    }

    @Test
    void whatIsThereByTheWholeNameIsReplacedOnlyIfTheUserSaysSo(@TempDir Path folder) throws Exception {
        Path there = Files.createFile(folder.resolve("lens.xml"));
        assertThat(saved(folder.resolve("lens"), false)).isEmpty();
        assertThat(saved(folder.resolve("lens"), true)).contains(there);
        assertThat(asked).containsExactly(there, there);
        assertThat(saved(there, false)).as("the system has asked").contains(there);
        assertThat(asked).hasSize(2);
    }

    private Optional<Path> saved(Path typed, boolean replaces) {
        return FileBox.completed(typed, chooser, name -> name.endsWith(".xml"), file -> {
            asked.add(file);
            return replaces;
        });
    }
}
