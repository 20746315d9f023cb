package cz.paprsek.fx.view.dialog;

import cz.paprsek.fx.view.texts.Texts;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javafx.scene.control.Alert;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBar.ButtonData;
import javafx.scene.control.ButtonType;
import javafx.stage.FileChooser;
import javafx.stage.Window;
import org.jspecify.annotations.Nullable;

/** Asks for files in the system's own dialog, and leaves the windows behind it as large as they are. */
public final class FileBox {
    private static final String ANY = "*.*";

    private FileBox() {}

    /** Asks for a file that is there; empty if the user thought better of it. */
    public static Optional<Path> toOpen(FileChooser chooser, Window owner) {
        return ask(chooser::showOpenDialog, owner);
    }

    /** Asks for a file to be written; empty if the user thought better of it. A name without an ending that the chooser has gets the one that is chosen there. */
    public static Optional<Path> toSave(FileChooser chooser, Window owner, Texts texts) {
        List<String> endings = chooser.getExtensionFilters().stream().flatMap(filter -> filter.getExtensions().stream()).filter(ending -> !ending.equals(ANY))
                .map(ending -> ending.substring(1)).toList();
        return toSave(chooser, owner, texts, name -> endings.stream().anyMatch(name.toLowerCase(Locale.ROOT)::endsWith));
    }

    /** The same, where a name may have other endings, too. */
    public static Optional<Path> toSave(FileChooser chooser, Window owner, Texts texts, Predicate<String> isComplete) {
        return ask(chooser::showSaveDialog, owner).flatMap(chosen -> completed(chosen, chooser, isComplete, file -> isToReplace(file, texts, owner)));
    }

    /** With its ending. What is there by that name is asked for: the system has asked only of the name as it was typed. */
    static Optional<Path> completed(Path chosen, FileChooser chooser, Predicate<String> isComplete, Predicate<Path> isToReplace) {
        if (isComplete.test(String.valueOf(chosen.getFileName()))) {
            return Optional.of(chosen);
        }
        String ending = Stream.concat(Stream.ofNullable(chooser.getSelectedExtensionFilter()), chooser.getExtensionFilters().stream())
                .map(filter -> filter.getExtensions().get(0)).filter(pattern -> !pattern.equals(ANY)).findFirst().orElse(" ").substring(1);
        return Optional.of(Path.of(chosen + ending)).filter(file -> !Files.exists(file) || isToReplace.test(file));
    }

    private static boolean isToReplace(Path file, Texts texts, Window owner) {
        ButtonType replace = new ButtonType(texts.of("dialog.replace.yes"), ButtonData.YES);
        ButtonType no = new ButtonType(texts.of("dialog.unsaved.stay"), ButtonData.CANCEL_CLOSE);
        Alert alert = new Alert(Alert.AlertType.CONFIRMATION, texts.of("dialog.replace.text"), replace, no);
        alert.setTitle("Paprsek");
        alert.setHeaderText(texts.of("dialog.replace.header", file.getFileName()));
        // Who presses Enter once more than needed keeps what is there.
        ((Button) alert.getDialogPane().lookupButton(replace)).setDefaultButton(false);
        ((Button) alert.getDialogPane().lookupButton(no)).setDefaultButton(true);
        return Deaf.ask(alert, owner).filter(replace::equals).isPresent();
    }

    private static Optional<Path> ask(Function<@Nullable Window, @Nullable File> dialog, Window owner) {
        @Nullable Window named = fixesOwners(System.getProperty("os.name", "")) ? null : owner;
        return Deaf.during(() -> Optional.ofNullable(dialog.apply(named)).map(File::toPath));
    }

    /**
     * Whether a dialog that has an owner would fix the size of that, and of the owner of that: under GTK. A dialog without one stands above all windows of the
     * program there, as it is modal.
     */
    static boolean fixesOwners(String system) {
        return system.toLowerCase(Locale.ROOT).contains("linux");
    }
}
