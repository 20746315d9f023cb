package cz.paprsek.fx;

import cz.paprsek.fx.view.explain.TreeChooser;
import cz.paprsek.fx.view.library.LibraryFiles;
import cz.paprsek.fx.view.picture.PictureChooser;
import cz.paprsek.fx.view.texts.Texts;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.stage.Window;

/** Answers questions as a test says beforehand, and remembers what was asked. */
final class TestDialogs implements Dialogs {
    Optional<Path> open = Optional.empty();
    Optional<Path> save = Optional.empty();
    Optional<Path> picture = Optional.empty();
    Optional<Path> tree = Optional.empty();
    Optional<Path> chosen = Optional.empty();
    boolean copies;
    Unsaved unsaved = Unsaved.STAY;
    final List<String> asked = new ArrayList<>();
    final List<Throwable> faults = new ArrayList<>();

    @Override
    public Optional<Path> fileToOpen(Optional<Path> folder) {
        asked.add("open");
        return open;
    }

    @Override
    public Optional<Path> fileToSave(Optional<Path> suggestion) {
        asked.add("save " + suggestion.map(path -> path.getFileName().toString()).orElse(""));
        return save;
    }

    @Override
    public Optional<Path> povToSave(Path suggestion) {
        asked.add("pov " + suggestion.getFileName());
        return save;
    }

    @Override
    public Optional<Path> pictureToOpen(Path folder) {
        asked.add("picture in " + folder.getFileName());
        return chosen;
    }

    @Override
    public Optional<Path> meshToOpen(Optional<Path> folder) {
        asked.add("mesh");
        return chosen;
    }

    @Override
    public Optional<Path> fontToOpen(Path folder) {
        asked.add("font in " + folder.getFileName());
        return chosen;
    }

    @Override
    public boolean isToCopy(Path file, Path folder) {
        asked.add("copy " + file.getFileName());
        return copies;
    }

    @Override
    public Unsaved aboutUnsaved(String title) {
        asked.add("unsaved " + title);
        return unsaved;
    }

    @Override
    public PictureChooser pictureChooser(Texts texts) {
        return (owner, name) -> picture;
    }

    @Override
    public LibraryFiles libraryFiles(Texts texts) {
        return new LibraryFiles() {
            @Override
            public Optional<Path> toOpen(Window owner) {
                return open;
            }

            @Override
            public Optional<Path> toCreate(Window owner) {
                return save;
            }

            @Override
            public Optional<Path> toExport(Window owner, String table) {
                return save;
            }
        };
    }

    @Override
    public TreeChooser treeChooser(Texts texts) {
        return (owner, name) -> {
            asked.add("tree " + name);
            return tree;
        };
    }

    @Override
    public void fault(Throwable fault, Runnable saveCopy) {
        faults.add(fault);
        saveCopy.run();
    }
}
