package cz.paprsek.fx.view.library;

import cz.paprsek.fx.view.dialog.FileBox;
import cz.paprsek.fx.view.texts.Texts;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import javafx.stage.Window;

/** Asks for files, and waits for the answer; empty if the user thought better of it. */
public interface LibraryFiles {
    /** A database that is there. */
    Optional<Path> toOpen(Window owner);

    /** A database that is to be. */
    Optional<Path> toCreate(Window owner);

    /** Where a table goes, as JSON if the name ends so, else as CSV. */
    Optional<Path> toExport(Window owner, String table);

    /** Asks in the system's own dialogs. */
    static LibraryFiles ofSystem(Texts texts) {
        ExtensionFilter database = new ExtensionFilter(texts.of("library.database"), "*.xml");
        ExtensionFilter csv = new ExtensionFilter(texts.of("library.csv"), "*.csv");
        ExtensionFilter json = new ExtensionFilter(texts.of("library.json"), "*.json");
        return new LibraryFiles() {
            @Override
            public Optional<Path> toOpen(Window owner) {
                return FileBox.toOpen(chooser("", database), owner);
            }

            @Override
            public Optional<Path> toCreate(Window owner) {
                return FileBox.toSave(chooser("database.xml", database), owner, texts);
            }

            @Override
            public Optional<Path> toExport(Window owner, String table) {
                return FileBox.toSave(chooser(table + ".csv", csv, json), owner, texts);
            }

            private FileChooser chooser(String name, ExtensionFilter... filters) {
                FileChooser chooser = new FileChooser();
                chooser.setTitle(texts.of("library.title"));
                chooser.setInitialFileName(name);
                chooser.getExtensionFilters().addAll(Arrays.asList(filters));
                return chooser;
            }
        };
    }
}
