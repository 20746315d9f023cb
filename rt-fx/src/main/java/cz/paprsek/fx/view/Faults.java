package cz.paprsek.fx.view;


/** Says in a sentence what went wrong. */
final class Faults {
    private Faults() {}

    static String sentence(Throwable fault) {
        String message = fault.getMessage();
        return message == null ? fault.getClass().getSimpleName() : message;
    }
}
