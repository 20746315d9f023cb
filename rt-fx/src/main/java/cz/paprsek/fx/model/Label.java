package cz.paprsek.fx.model;

/**
 * What an edit did, for "Undo …".
 *
 * @param edit the kind of edit, which has a text in every language
 * @param subject what it was done to, as the user reads it: a name, a kind of object or a property; empty for none
 */
public record Label(Edit edit, String subject) {

    /** Kinds of edit. */
    public enum Edit {
        ADD, DELETE, DUPLICATE, PASTE, CUT, MOVE, ROTATE, RESIZE, REORDER, RENAME, CHANGE, COMBINE, DISSOLVE, GROUP, HIDE, SHOW, LOCK, UNLOCK,
        CAMERA, RELOAD, WRITE
    }

    public static Label of(Edit edit) {
        return new Label(edit, "");
    }

    public static Label of(Edit edit, String subject) {
        return new Label(edit, subject);
    }
}
