package cz.paprsek.fx;

import cz.paprsek.fx.view.explain.TreeChooser;
import cz.paprsek.fx.view.library.LibraryFiles;
import cz.paprsek.fx.view.picture.PictureChooser;
import cz.paprsek.fx.view.texts.Texts;
import java.nio.file.Path;
import java.util.Optional;

/** Questions that stop everything until they are answered, behind an interface so that tests can answer them. */
interface Dialogs {
    /** What to do with unsaved changes. */
    enum Unsaved { SAVE, DISCARD, STAY }

    /** Asks for a file to open; empty if the user thought better of it. */
    Optional<Path> fileToOpen(Optional<Path> folder);

    /** Asks where to save; empty if the user thought better of it. */
    Optional<Path> fileToSave(Optional<Path> suggestion);

    /** Asks where a scene for POV-Ray is to be written; empty if the user thought better of it. */
    Optional<Path> povToSave(Path suggestion);

    /** Asks for a picture that the scene is to have; empty if the user thought better of it. */
    Optional<Path> pictureToOpen(Path folder);

    /** Asks for a file of triangles that the scene is to have; empty if the user thought better of it. */
    Optional<Path> meshToOpen(Optional<Path> folder);

    /** Asks for a font that the scene is to have; empty if the user thought better of it. */
    Optional<Path> fontToOpen(Path folder);

    /** Asks whether a picture or mesh from elsewhere is to be copied into the scene's folder. */
    boolean isToCopy(Path picture, Path folder);

    /** Asks what to do with unsaved changes of a scene. */
    Unsaved aboutUnsaved(String title);

    /** Asks where pictures are to be saved. */
    PictureChooser pictureChooser(Texts texts);

    /** Asks for databases, and where tables go. */
    LibraryFiles libraryFiles(Texts texts);

    /** Asks where trees of rays are to be saved. */
    TreeChooser treeChooser(Texts texts);

    /** Shows that the program has a fault; with a way to save a copy of the scene. */
    void fault(Throwable fault, Runnable saveCopy);
}
