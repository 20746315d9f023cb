package cz.paprsek.cli.shard;

import cz.paprsek.cli.value.Shard;
import cz.paprsek.render.Tile;
import cz.paprsek.render.join.JoinedPasses;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;

/**
 * What a part file tells of itself before its pixels.
 *
 * @param card which picture or film it is of
 * @param told what the picture tells of itself
 * @param frame of a film, from 1; 0 of a picture that is none
 * @param pass which of the passes of these pixels, from 1; 0 for all of them
 * @param tile which pixels of the picture it holds
 * @param span of which frames a share was
 * @param shard whose work it was
 * @param words of the command line that made it, without those that say whose work it is and where it goes: to say how it can be made again
 */
record PartHead(Card card, Told told, int frame, int pass, Tile tile, Span span, Shard shard, List<String> words) {
    PartHead {
        words = List.copyOf(words);
    }

    String text() {
        StringBuilder text = new StringBuilder(card.text());
        told.put(text);
        Fields.put(text, "frame", frame);
        Fields.put(text, "pass", pass);
        Fields.put(text, "tile", Card.text(tile));
        span.put(text);
        Fields.put(text, "shard", shard.number() + " " + shard.count());
        words.forEach(word -> Fields.put(text, "word", word));
        return text.toString();
    }

    /**
     * What was written by {@link #text}, and nothing else.
     *
     * @throws IOException with a sentence that tells what is wrong
     */
    static PartHead read(String text) throws IOException {
        try {
            Fields fields = new Fields(Arrays.asList(text.split("\n", -1)));
            Card card = Card.read(fields);
            Told told = Told.read(fields);
            int frame = fields.numbers("frame", 1)[0];
            int pass = fields.numbers("pass", 1)[0];
            Tile tile = Card.tile(fields, "tile");
            Span span = Span.read(fields);
            int[] shard = fields.numbers("shard", 2);
            PartHead head = new PartHead(card, told, frame, pass, tile, span, new Shard(shard[0], shard[1]), fields.all("word"));
            if (!head.text().equals(text)) {
                throw new IOException("its head is not as it was written");
            }
            if (!span.has(frame) || !Grid.has(card.region(), tile) || pass < 0 || pass > card.passes()) {
                throw new IOException("its head tells of pixels that there cannot be");
            }
            return head;
        } catch (IllegalArgumentException refused) {
            throw new IOException("its head cannot be: " + refused.getMessage(), refused);
        }
    }

    /** How many numbers each pixel has: those of a finished one, or those that are kept of a pass. */
    int channels() {
        return pass == 0 ? card.channels() : JoinedPasses.size(card.filter());
    }

    /** How many bytes its pixels take. */
    long pixelBytes() {
        return (long) Float.BYTES * channels() * tile.width() * tile.height();
    }
}
