package cz.paprsek.image;

import cz.paprsek.io.PlainText;

/** What the platform says of a picture, in one line. */
final class PlainSentence {
    private static final int LONGEST = 300;

    private PlainSentence() {}

    static String of(Exception failure) {
        String message = failure.getMessage();
        return PlainText.of(message == null ? failure.getClass().getSimpleName() : message.replaceAll("\\s+", " ").strip(), LONGEST);
    }
}
