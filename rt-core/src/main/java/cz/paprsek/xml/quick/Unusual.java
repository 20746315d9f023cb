package cz.paprsek.xml.quick;

/** A file, or a piece of one, that {@link QuickReader} leaves to the thorough way: wrong, or right in a manner that it does not know. */
public final class Unusual extends IllegalArgumentException {
    private static final long serialVersionUID = 1;

    public Unusual() {
        super("not for the quick reader");
    }

    static void unless(boolean condition) {
        if (!condition) {
            throw new Unusual();
        }
    }

    /** It is thrown where files are right but rare, and need not be slow for that. */
    @Override
    public synchronized Throwable fillInStackTrace() {
        return this;
    }
}
