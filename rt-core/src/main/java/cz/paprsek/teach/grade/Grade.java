package cz.paprsek.teach.grade;

import cz.paprsek.teach.mistake.Mistakes;
import java.util.List;
import java.util.Objects;

/**
 * What is to be said of a picture.
 *
 * @param verdict in one word
 * @param explanations the mistakes that explain it best: several if they cannot be told apart, none if it is right or nothing explains it
 * @param explained how much of what is wrong they explain, 0–1
 * @param samples rays along each side of a pixel that it seems to have been made with
 */
public record Grade(Verdict verdict, List<Mistakes> explanations, double explained, int samples) {
    public Grade {
        Objects.requireNonNull(verdict, "verdict");
        explanations = List.copyOf(explanations);
    }

    /** What a picture is. */
    public enum Verdict { RIGHT, MISTAKEN, UNEXPLAINED }
}
