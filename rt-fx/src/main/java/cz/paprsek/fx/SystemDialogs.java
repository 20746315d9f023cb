package cz.paprsek.fx;

import cz.paprsek.format.ForeignFormat;
import cz.paprsek.fx.view.dialog.Deaf;
import cz.paprsek.fx.view.dialog.FileBox;
import cz.paprsek.fx.view.explain.TreeChooser;
import cz.paprsek.fx.view.library.LibraryFiles;
import cz.paprsek.fx.view.picture.PictureChooser;
import cz.paprsek.fx.view.texts.Texts;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javafx.geometry.Insets;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonBar.ButtonData;
import javafx.scene.control.ButtonType;
import javafx.scene.control.DialogPane;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.TextArea;
import javafx.scene.layout.StackPane;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import javafx.stage.Window;

/** The questions as dialogs of the system and of JavaFX. */
final class SystemDialogs implements Dialogs {
    private static final String SCENE = "*.xml";
    /** Wide enough for three buttons with whole words, one of which gets them when the dialog has its size. */
    private static final double FAULT_WIDTH = 500;
    /** Around the details, which stand as far from the edges as the text above them. */
    private static final Insets DETAILS = new Insets(12, 14, 0, 14);

    private final Window owner;
    private final Supplier<Texts> texts;

    SystemDialogs(Window owner, Supplier<Texts> texts) {
        this.owner = owner;
        this.texts = texts;
    }

    @Override
    public Optional<Path> fileToOpen(Optional<Path> folder) {
        FileChooser chooser = chooser(texts.get().of("dialog.open"), toOpen(texts.get()));
        folder.filter(Files::isDirectory).ifPresent(path -> chooser.setInitialDirectory(path.toFile()));
        return FileBox.toOpen(chooser, owner);
    }

    @Override
    public Optional<Path> fileToSave(Optional<Path> suggestion) {
        return toSave(chooser(texts.get().of("dialog.save"), toSave(texts.get())), suggestion);
    }

    @Override
    public Optional<Path> povToSave(Path suggestion) {
        return toSave(chooser(texts.get().of("dialog.export-pov"), List.of(new ExtensionFilter(texts.get().of("dialog.pov"), "*.pov"))), Optional.of(suggestion));
    }

    private Optional<Path> toSave(FileChooser chooser, Optional<Path> suggestion) {
        suggestion.ifPresent(path -> {
            chooser.setInitialFileName(String.valueOf(path.getFileName()));
            Optional.ofNullable(path.getParent()).filter(Files::isDirectory).ifPresent(folder -> chooser.setInitialDirectory(folder.toFile()));
        });
        return FileBox.toSave(chooser, owner, texts.get());
    }

    @Override
    public Optional<Path> pictureToOpen(Path folder) {
        FileChooser chooser = new FileChooser();
        chooser.setTitle(texts.get().of("sheet.choose-picture"));
        if (Files.isDirectory(folder)) {
            chooser.setInitialDirectory(folder.toFile());
        }
        chooser.getExtensionFilters().addAll(
                new ExtensionFilter(texts.get().of("dialog.pictures"), "*.png", "*.jpg", "*.jpeg", "*.hdr", "*.exr", "*.tif", "*.tiff", "*.bmp", "*.ppm", "*.pfm"),
                new ExtensionFilter(texts.get().of("dialog.all"), "*.*"));
        return FileBox.toOpen(chooser, owner);
    }

    @Override
    public Optional<Path> meshToOpen(Optional<Path> folder) {
        FileChooser chooser = new FileChooser();
        chooser.setTitle(texts.get().of("dialog.mesh"));
        folder.filter(Files::isDirectory).ifPresent(path -> chooser.setInitialDirectory(path.toFile()));
        chooser.getExtensionFilters().addAll(new ExtensionFilter(texts.get().of("dialog.meshes"), endings(ForeignFormat::isMesh)), new ExtensionFilter(texts.get().of("dialog.all"), "*.*"));
        return FileBox.toOpen(chooser, owner);
    }

    @Override
    public Optional<Path> fontToOpen(Path folder) {
        FileChooser chooser = new FileChooser();
        chooser.setTitle(texts.get().of("sheet.choose-font"));
        if (Files.isDirectory(folder)) {
            chooser.setInitialDirectory(folder.toFile());
        }
        chooser.getExtensionFilters().addAll(new ExtensionFilter(texts.get().of("dialog.fonts"), "*.ttf"), new ExtensionFilter(texts.get().of("dialog.all"), "*.*"));
        return FileBox.toOpen(chooser, owner);
    }

    @Override
    public boolean isToCopy(Path picture, Path folder) {
        ButtonType copy = new ButtonType(texts.get().of("dialog.copy.yes"), ButtonData.YES);
        ButtonType no = new ButtonType(texts.get().of("dialog.copy.no"), ButtonData.CANCEL_CLOSE);
        Alert alert = new Alert(Alert.AlertType.CONFIRMATION, texts.get().of("dialog.copy.text", folder), copy, no);
        alert.setTitle("Paprsek");
        alert.setHeaderText(texts.get().of("dialog.copy.header", picture.getFileName()));
        return Deaf.ask(alert, owner).filter(copy::equals).isPresent();
    }

    private static FileChooser chooser(String title, List<ExtensionFilter> filters) {
        FileChooser chooser = new FileChooser();
        chooser.setTitle(title);
        chooser.getExtensionFilters().addAll(filters);
        return chooser;
    }

    /** What is shown of a folder to open something there: all that can be opened, at first. */
    static List<ExtensionFilter> toOpen(Texts texts) {
        List<String> models = endings(format -> true);
        List<String> both = Stream.concat(Stream.of(SCENE), models.stream()).toList();
        return List.of(new ExtensionFilter(texts.of("dialog.both"), both), new ExtensionFilter(texts.of("dialog.scenes"), SCENE),
                new ExtensionFilter(texts.of("dialog.models"), models), new ExtensionFilter(texts.of("dialog.all"), "*.*"));
    }

    /** Only scenes are saved. */
    static List<ExtensionFilter> toSave(Texts texts) {
        return List.of(new ExtensionFilter(texts.of("dialog.scenes"), SCENE), new ExtensionFilter(texts.of("dialog.all"), "*.*"));
    }

    /** In small letters and in large ones, between which some systems tell. */
    private static List<String> endings(Predicate<ForeignFormat> which) {
        return Arrays.stream(ForeignFormat.values()).filter(which).flatMap(format -> format.endings().stream())
                .flatMap(ending -> Stream.of("*." + ending, "*." + ending.toUpperCase(Locale.ROOT))).toList();
    }

    @Override
    public Unsaved aboutUnsaved(String title) {
        ButtonType save = new ButtonType(texts.get().of("dialog.unsaved.save"), ButtonData.YES);
        ButtonType discard = new ButtonType(texts.get().of("dialog.unsaved.discard"), ButtonData.NO);
        ButtonType stay = new ButtonType(texts.get().of("dialog.unsaved.stay"), ButtonData.CANCEL_CLOSE);
        Alert alert = new Alert(Alert.AlertType.CONFIRMATION, texts.get().of("dialog.unsaved.text"), save, discard, stay);
        alert.setTitle("Paprsek");
        alert.setHeaderText(texts.get().of("dialog.unsaved.header", title));
        ButtonType answer = Deaf.ask(alert, owner).orElse(stay);
        return answer.equals(save) ? Unsaved.SAVE : answer.equals(discard) ? Unsaved.DISCARD : Unsaved.STAY;
    }

    @Override
    public PictureChooser pictureChooser(Texts language) {
        return PictureChooser.ofSystem(language);
    }

    @Override
    public LibraryFiles libraryFiles(Texts language) {
        return LibraryFiles.ofSystem(language);
    }

    @Override
    public TreeChooser treeChooser(Texts language) {
        return TreeChooser.ofSystem(language);
    }

    @Override
    public void fault(Throwable fault, Runnable saveCopy) {
        StringWriter trace = new StringWriter();
        fault.printStackTrace(new PrintWriter(trace));
        ButtonType save = new ButtonType(texts.get().of("dialog.fault.save"), ButtonData.LEFT);
        ButtonType goOn = new ButtonType(texts.get().of("dialog.fault.continue"), ButtonData.OK_DONE);
        Alert alert = new Alert(Alert.AlertType.ERROR, texts.get().of("dialog.fault.text"), save, goOn);
        Deaf.over(alert, owner);
        alert.setTitle("Paprsek");
        alert.setHeaderText(texts.get().of("dialog.fault.header"));
        alert.getDialogPane().setMinWidth(FAULT_WIDTH);
        TextArea details = new TextArea(trace.toString());
        details.setEditable(false);
        // The pane itself leaves no room between its text and what can be shown below.
        StackPane room = new StackPane(details);
        room.setPadding(DETAILS);
        alert.getDialogPane().setExpandableContent(room);
        alert.resultProperty().addListener((property, old, answer) -> {
            if (save.equals(answer)) {
                saveCopy.run();
            }
        });
        alert.show();
        translate(alert.getDialogPane());
    }

    /** What shows the details has words of the system's language, if JavaFX has any in that, and not of the window's. */
    private void translate(DialogPane pane) {
        if (pane.lookup(".details-button") instanceof Hyperlink link) {
            Runnable say = () -> link.setText(texts.get().of(pane.isExpanded() ? "dialog.fault.less" : "dialog.fault.more"));
            pane.expandedProperty().addListener(property -> say.run());
            say.run();
        }
    }
}
