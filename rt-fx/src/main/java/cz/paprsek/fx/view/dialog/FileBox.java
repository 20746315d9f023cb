package cz.paprsek.fx.view.dialog;

import java.io.File;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import javafx.stage.FileChooser;
import javafx.stage.Window;
import org.jspecify.annotations.Nullable;

/** Asks for files in the system's own dialog, and leaves the windows behind it as large as they are. */
public final class FileBox {
    private FileBox() {}

    /** Asks for a file that is there; empty if the user thought better of it. */
    public static Optional<Path> toOpen(FileChooser chooser, Window owner) {
        return ask(chooser::showOpenDialog, owner);
    }

    /** Asks for a file to be written; empty if the user thought better of it. */
    public static Optional<Path> toSave(FileChooser chooser, Window owner) {
        return ask(chooser::showSaveDialog, owner);
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
