package cz.paprsek.xml.text;

/** A text that cannot be changed piece by piece; it has to be written anew. */
public final class Unpatchable extends RuntimeException {
    private static final long serialVersionUID = 1;

    public Unpatchable(String message) {
        super(message);
    }
}
