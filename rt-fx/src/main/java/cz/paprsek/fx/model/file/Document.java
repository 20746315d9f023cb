package cz.paprsek.fx.model.file;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.Belongings;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.SceneFile;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import cz.paprsek.xml.SceneText;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** The model's scene as something kept in a file, or not yet. For JavaFX's thread only. */
public final class Document {
    private final EditorModel model;
    private final ReadOnlyObjectWrapper<Optional<SceneSource>> source = new ReadOnlyObjectWrapper<>(Optional.empty());
    private Optional<FileStamp> stamp = Optional.empty();
    /** The scene as the file had it when that was looked at last; empty if there is no file. */
    private Optional<Scene> known = Optional.empty();
    private KeptText text = KeptText.NONE;

    public Document(EditorModel model) {
        this.model = model;
    }

    public EditorModel model() {
        return model;
    }

    /** Where the scene is kept; empty if it has never been saved. */
    public ReadOnlyObjectProperty<Optional<SceneSource>> sourceProperty() {
        return source.getReadOnlyProperty();
    }

    /** The text that the scene has where it is kept; none if it has never been saved. */
    public KeptText text() {
        return text.with(model.state().typed());
    }

    /** Takes a scene that was read from its source. */
    public void opened(SceneSource.Kept read) {
        source.set(Optional.of(read.source()));
        stamp = FileStamp.of(read.source().file());
        known = Optional.of(read.scene());
        text = read.text();
        model.setAssets(Assets.beside(read.source().file()));
        model.open(read.scene());
    }

    /** Takes a scene that is in no file, whose pictures come from elsewhere; they are taken along when it is saved. */
    public void openedWithoutFile(Scene scene, Assets pictures) {
        source.set(Optional.empty());
        stamp = Optional.empty();
        known = Optional.empty();
        text = KeptText.NONE;
        model.setAssets(pictures);
        model.open(scene);
    }

    /** Takes a scene that was made of another program's file, and is in none of its own yet. */
    public void brought(Scene scene, Assets assets) {
        source.set(Optional.empty());
        stamp = Optional.empty();
        known = Optional.empty();
        text = KeptText.NONE;
        model.setAssets(assets);
        model.openUnsaved(scene);
    }

    /** Takes a scene that was to be saved at a source, or at none, and was not, with its comments and wording. */
    public void recovered(Optional<SceneSource> from, OriginalText copy) {
        Scene scene = copy.contents().scenes().get(0);
        text = from.equals(source.get()) ? text : KeptText.NONE;
        source.set(from);
        stamp = from.flatMap(place -> FileStamp.of(place.file()));
        known = Optional.empty();
        model.setAssets(from.map(place -> Assets.beside(place.file())).orElseGet(Assets::none));
        // Without anything of its own, it is not written over the text of a database.
        boolean isPlain = from.flatMap(SceneSource::inDatabase).isPresent() && SceneText.of(Optional.of(copy), scene).characters().equals(SceneFiles.format(scene));
        if (isPlain || copy.contents().isDatabase()) {
            model.openUnsaved(scene);
        } else {
            model.openUnsaved(scene, copy.asTyped());
        }
    }

    /**
     * Saves the scene where it is kept from now on. If that is in another folder, the pictures and meshes that it names are taken along.
     *
     * @throws IOException if it cannot be written; the old file is still there
     * @throws SceneFileException if it is to go into a file that others have changed and that is not valid
     * @throws IllegalArgumentException if the scene has what no file can hold
     */
    public void save(SceneSource to) throws IOException, SceneFileException {
        Scene scene = model.scene();
        Assets there = source.get().filter(place -> place.isBeside(to)).isPresent() ? model.assets() : taken(scene, to);
        Optional<OriginalText> untyped = untyped(to);
        SceneSource.Kept written = to.write(scene, source.get().equals(Optional.of(to)) ? known : Optional.empty(), text());
        source.set(Optional.of(written.source()));
        stamp = FileStamp.of(to.file());
        known = Optional.of(written.scene());
        // Undoing what was written leads back to the text that was opened.
        text = model.state().typed().isPresent() ? written.text().with(untyped) : written.text();
        model.setAssets(there);
        model.saved(scene);
    }

    /** The text that the scene goes back to when what was written in it is undone; in a database it then counts for more than what is there. */
    private Optional<OriginalText> untyped(SceneSource to) {
        Optional<OriginalText> own = text.file().map(SceneFile::text);
        return to.inDatabase().isEmpty() ? own
                : text.typed().or(() -> own.or(() -> known.flatMap(scene -> text.database().map(database -> database.text().alone(scene))))
                        .map(OriginalText::asTyped));
    }

    private Assets taken(Scene scene, SceneSource to) throws IOException {
        new Belongings(scene, model.assets()).take(to.file());
        return Assets.beside(to.file());
    }

    /**
     * The name by which the scene can have a picture: relative to its folder. Empty if the picture is neither there nor below.
     *
     * @throws IOException if there is no such file
     */
    public Optional<String> nameOf(Path picture) throws IOException {
        Path folder = folder().toRealPath();
        Path real = picture.toRealPath();
        if (!real.startsWith(folder)) {
            return Optional.empty();
        }
        readAnew();
        return Optional.of(folder.relativize(real).toString().replace(File.separatorChar, '/'));
    }

    /**
     * The name by which a scene that is not saved yet can have a file: that in its folder, from which then all its files come. Empty if it has others from
     * elsewhere. Where the scene is saved, they are taken along.
     */
    public Optional<String> nameBeforeSaving(Path file) throws IOException {
        String name = String.valueOf(file.getFileName());
        Assets beside = Assets.beside(file.toAbsolutePath());
        for (String used : model.scene().files()) {
            if (!beside.bytes(used).equals(model.assets().bytes(used))) {
                return Optional.empty();
            }
        }
        model.setAssets(beside);
        return Optional.of(name);
    }

    /**
     * Copies a picture into the scene's folder, under its own name, or if another has that, with a number.
     *
     * @return the name by which the scene can have it
     * @throws IOException if it cannot be read, is larger than scenes can have, or cannot be written
     */
    public String takeIn(Path picture) throws IOException {
        String name = String.valueOf(picture.getFileName());
        if (Files.size(picture) > Assets.LARGEST) {
            throw new IOException(name + " is larger than the " + (Assets.LARGEST >> 20) + " MiB that a picture of a scene can have");
        }
        byte[] content = Files.readAllBytes(picture);
        int dot = name.lastIndexOf('.');
        Path copy = folder().resolve(name);
        for (int i = 2; Files.exists(copy) && !Arrays.equals(Files.readAllBytes(copy), content); i++) {
            copy = folder().resolve(dot > 0 ? name.substring(0, dot) + "-" + i + name.substring(dot) : name + "-" + i);
        }
        if (!Files.exists(copy)) {
            AtomicFile.write(copy, out -> out.write(content));
        }
        readAnew();
        return String.valueOf(copy.getFileName());
    }

    private Path folder() {
        return Objects.requireNonNull(source.get().orElseThrow().file().toAbsolutePath().getParent());
    }

    /** What was looked for and not there may be by now. */
    private void readAnew() {
        model.setAssets(Assets.beside(source.get().orElseThrow().file()));
    }

    /** Takes note that the scene is kept at a source from now on, which has it as it is now, or soon will. */
    public void kept(SceneSource at, Scene scene) {
        source.set(Optional.of(at));
        known = Optional.of(scene);
        text = KeptText.NONE;
        model.setAssets(Assets.beside(at.file()));
        model.saved(scene);
    }

    /** Takes over what the scene is called where it is kept, its tags and its description, so far as they are others than before. */
    public void relabelled(SceneSource at, Scene before, Scene now) {
        boolean wasSaved = !model.unsavedProperty().get();
        source.set(Optional.of(at));
        known = known.map(scene -> labelled(scene, before, now));
        model.edit(Label.of(Label.Edit.RENAME, now.name()), scene -> labelled(scene, before, now));
        if (wasSaved) {
            model.saved(model.scene());
        }
    }

    private static Scene labelled(Scene scene, Scene before, Scene now) {
        return scene.withName(scene.name().equals(before.name()) ? now.name() : scene.name())
                .withTags(scene.tags().equals(before.tags()) ? now.tags() : scene.tags())
                .withDescription(scene.description().equals(before.description()) ? now.description() : scene.description());
    }

    /** Whether the file has had this scene ever since it was looked at last; and the same text, if somebody has written in it here. */
    public boolean knows(SceneSource.Kept onDisk) {
        boolean isSameText = text.file().isEmpty() || onDisk.text().file().filter(text.file().get()::isAs).isPresent();
        return known.equals(Optional.of(onDisk.scene())) && (isSameText || model.state().typed().isEmpty());
    }

    /** Whether the file is there, and another one than was read or written last. Says so once: after {@link #noticeDisk} it counts as known. */
    public boolean hasChangedOnDisk() {
        Optional<FileStamp> now = source.get().flatMap(place -> FileStamp.of(place.file()));
        return now.isPresent() && !now.equals(stamp);
    }

    /** Takes note of the file as it is on disk now, and of the scene that it has. */
    public void noticeDisk(SceneSource.Kept onDisk) {
        known = Optional.of(onDisk.scene());
        text = onDisk.text();
        noticeDisk();
    }

    /** Takes note of the file as it is on disk now. */
    public void noticeDisk() {
        stamp = source.get().flatMap(place -> FileStamp.of(place.file()));
    }

    /** Takes the scene as it is on disk now in the place of this one, as a step that can be undone. */
    public void reloaded(Label label, SceneSource.Kept read) {
        noticeDisk(read);
        model.reload(label, read.scene());
    }
}
