package cz.paprsek.cli.shard;

import cz.paprsek.image.ImageOptions.Origin;
import java.io.IOException;

/**
 * What the file of a picture tells of itself beside what is the same for all frames of a film.
 *
 * @param scene the scene's name
 * @param digest of the scene, as it is told
 */
public record Told(String scene, String digest) {
    public static Told of(Origin origin) {
        return new Told(origin.scene(), origin.digest());
    }

    static Told read(Fields fields) throws IOException {
        return new Told(fields.next("name"), fields.next("source"));
    }

    void put(StringBuilder text) {
        Fields.put(text, "name", scene);
        Fields.put(text, "source", digest);
    }

    /** All of it. */
    Origin origin(Card card) {
        return new Origin(scene, digest, card.program(), card.settings());
    }
}
