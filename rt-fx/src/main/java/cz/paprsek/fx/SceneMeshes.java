package cz.paprsek.fx;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.ForeignFormat;
import cz.paprsek.format.ForeignScene;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.model.file.Document;
import cz.paprsek.fx.model.file.SceneSource;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.io.Failures;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.height.HeightField;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/** Brings meshes and relief into the scene: from its folder or below, or from elsewhere, copied there. They stand upright, and in a size that is seen. */
record SceneMeshes(Document document, Dialogs dialogs, Notices notices, Texts texts, Edits edits) {
    /** Pieces of a circle, more than those with which a mesh is drawn roughly. */
    private static final int DRAWN = 72;

    /** Asks for a file and brings it in. */
    void choose(Sight sight) {
        Optional<Path> folder = document.sourceProperty().get().flatMap(source -> Optional.ofNullable(source.file().toAbsolutePath().getParent()));
        dialogs.meshToOpen(folder).ifPresent(file -> bring(List.of(file), sight));
    }

    /** Asks for a picture and brings it in as relief, four times as wide as white is high. */
    void chooseHeights(Sight sight) {
        Optional<Path> folder = document.sourceProperty().get().flatMap(source -> Optional.ofNullable(source.file().toAbsolutePath().getParent()));
        dialogs.pictureToOpen(folder.orElseGet(() -> Path.of(System.getProperty("user.home")))).ifPresent(picture -> bringHeights(picture, sight));
    }

    private void bringHeights(Path picture, Sight sight) {
        try {
            Optional<String> known = name(picture);
            if (known.isEmpty()) {
                notices.say(texts.of("mesh.unsaved"));
                return;
            }
            Vec3 size = new Vec3(sight.size(), sight.size() / 4, sight.size());
            Assets assets = document.model().assets();
            Background.run("paprsek-heights", () -> HeightField.of(known.get(), size).read(MeshFiles.heights(known.get(), assets)), field -> edits.add(field, sight),
                    fault -> notices.wrong(fault instanceof Exception unreadable ? Failures.sentence(unreadable) : String.valueOf(fault)));
        } catch (IOException unreadable) {
            notices.wrong(Failures.sentence(unreadable));
        }
    }

    /** Whether a file is one of triangles, which can be part of a scene. */
    static boolean isMesh(Path file) {
        return ForeignFormat.ofName(String.valueOf(file.getFileName())).filter(ForeignFormat::isMesh).isPresent();
    }

    /** A file of another program, ready to be drawn. */
    static ForeignScene brought(String name, ForeignFormat format, Assets assets) throws IOException {
        ForeignScene read = ForeignScene.read(name, format, assets);
        drawable(read.scene());
        return read;
    }

    /** Finds the lines of meshes: large ones take a second, in which the window is not to stand still. */
    static Scene drawable(Scene read) {
        ScenePath.bodies(read).map(place -> place.in(read).shape()).filter(Mesh.class::isInstance).forEach(mesh -> mesh.outline(Vec3.Z, DRAWN));
        return read;
    }

    /** Meshes that have been read, and sentences about those that cannot be. */
    private record Brought(List<SceneObject> meshes, List<String> faults) {}

    /** Adds what files hold, each with its middle where the user looks; what is wrong with some does not keep the others away. */
    void bring(List<Path> files, Sight sight) {
        Brought brought = new Brought(new ArrayList<>(), new ArrayList<>());
        List<String> names = new ArrayList<>();
        for (Path file : files) {
            if (isMesh(file)) {
                try {
                    name(file).ifPresentOrElse(names::add, () -> brought.faults.add(texts.of("mesh.unsaved")));
                } catch (IOException unreadable) {
                    brought.faults.add(texts.sentence(Failures.sentence(unreadable)));
                }
            } else {
                brought.faults.add(texts.of("mesh.other", file.getFileName(), ForeignFormat.meshes()));
            }
        }
        if (names.isEmpty()) {
            notices.say(String.join("; ", brought.faults));
            return;
        }
        Assets assets = document.model().assets();
        notices.say(texts.of("file.opening", String.join(", ", names)));
        Background.run("paprsek-mesh", () -> read(names, assets, brought), all -> {
            notices.say(String.join("; ", all.faults));
            all.meshes.forEach(object -> edits.add(seen(object, sight), sight));
        }, fault -> notices.wrong(fault instanceof Exception known ? Failures.sentence(known) : String.valueOf(fault)));
    }

    private Brought read(List<String> names, Assets assets, Brought into) {
        for (String name : names) {
            try {
                into.meshes.add(brought(name, ForeignFormat.ofName(name).orElseThrow(), assets).scene().objects().get(0));
            } catch (IOException unreadable) {
                into.faults.add(texts.sentence(Failures.sentence(unreadable)));
            }
        }
        return into;
    }

    /** The name by which the scene can have a file; empty if it can have none. */
    private Optional<String> name(Path file) throws IOException {
        Optional<SceneSource> source = document.sourceProperty().get();
        if (source.isEmpty()) {
            return document.nameBeforeSaving(file);
        }
        Optional<String> name = document.nameOf(file);
        if (name.isPresent()) {
            return name;
        }
        Path folder = Objects.requireNonNull(source.get().file().toAbsolutePath().getParent());
        if (!dialogs.isToCopy(file, folder)) {
            throw new IOException(texts.of("picture.outside", file.getFileName(), folder));
        }
        return Optional.of(document.takeIn(file));
    }

    /** By a power of ten larger or smaller if it is ten times smaller or larger than what is seen well. */
    private static SceneObject seen(SceneObject object, Sight sight) {
        Bounds box = object.shape().bounds();
        double size = Math.max(box.maxX() - box.minX(), Math.max(box.maxY() - box.minY(), box.maxZ() - box.minZ()));
        double wanted = sight.size() / size;
        if (!(wanted > 10 || wanted < 0.1)) {
            return object;
        }
        double scale = Double.parseDouble("1e" + (int) Math.rint(Math.log10(wanted)));
        return object.placed(object.placement().withScale(new Vec3(scale, scale, scale)));
    }
}
