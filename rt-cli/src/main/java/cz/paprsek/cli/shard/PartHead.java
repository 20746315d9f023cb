package cz.paprsek.cli.shard;

import cz.paprsek.cli.value.Shard;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;

/**
 * What a part file tells of itself before its pixels.
 *
 * @param card which picture it is of
 * @param frame of an animation, from 1; 0 of a picture that is none
 * @param tile which pixels of the picture it holds
 * @param shard whose work it was
 * @param words of the command line that made it, without those that say whose work it is and where it goes: to say how it can be made again
 */
record PartHead(Card card, int frame, Tile tile, Shard shard, List<String> words) {
    PartHead {
        words = List.copyOf(words);
    }

    String text() {
        StringBuilder text = new StringBuilder(card.text());
        Fields.put(text, "frame", frame);
        Fields.put(text, "tile", Card.text(tile));
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
            int frame = fields.numbers("frame", 1)[0];
            Tile tile = Card.tile(fields, "tile");
            int[] shard = fields.numbers("shard", 2);
            PartHead head = new PartHead(card, frame, tile, new Shard(shard[0], shard[1]), fields.all("word"));
            if (!head.text().equals(text)) {
                throw new IOException("its head is not as it was written");
            }
            if (frame < 0 || !Grid.has(card.region(), tile)) {
                throw new IOException("its head tells of pixels that the picture does not have");
            }
            return head;
        } catch (IllegalArgumentException refused) {
            throw new IOException("its head cannot be: " + refused.getMessage(), refused);
        }
    }

    /** How many bytes its pixels take. */
    long pixelBytes() {
        return (long) Float.BYTES * card.channels() * tile.width() * tile.height();
    }
}
