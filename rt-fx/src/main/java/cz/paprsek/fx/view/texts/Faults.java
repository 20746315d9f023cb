package cz.paprsek.fx.view.texts;

/** Says in a sentence what went wrong. */
public final class Faults {
    private Faults() {}

    public static String sentence(Throwable fault) {
        String message = fault.getMessage();
        return message == null ? fault.getClass().getSimpleName() : message;
    }
}
