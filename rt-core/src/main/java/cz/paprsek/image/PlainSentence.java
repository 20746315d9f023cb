package cz.paprsek.image;

import cz.paprsek.io.PlainText;
import java.io.EOFException;
import java.io.IOException;

/** What the platform says of a picture, in one line. */
final class PlainSentence {
    private static final int LONGEST = 300;

    private PlainSentence() {}

    static String of(IOException failure) {
        String message = failure.getMessage();
        if (message == null || failure instanceof EOFException) {
            return failure instanceof EOFException ? "the file is cut off" : "the picture is damaged";
        }
        return PlainText.of(message.replaceAll("\\s+", " ").strip(), LONGEST);
    }
}
