package cz.paprsek.xml.recipe;

import cz.paprsek.text.Numbers;
import cz.paprsek.xml.mistake.Problems;
import cz.paprsek.xml.recipe.Names.ToldAlready;

/** Counts the copies that are made of bodies, and what is written with them: there may not be any number of them. */
final class Copies {
    /** How many copies there may be in a scene: repetition within repetition makes endless ones of a few lines. */
    static final int MOST = 4_000_000;

    private final Output out;
    private final Mistakes mistakes;
    private final long mostCharacters;
    private int made;

    /** @param mostCharacters of all that is written */
    Copies(Output out, Mistakes mistakes, long mostCharacters) {
        this.out = out;
        this.mistakes = mistakes;
        this.mostCharacters = mostCharacters;
    }

    /**
     * One more is to be made.
     *
     * @throws Problems.Stop if there are too many, which has been told
     */
    void next(Node where) {
        if (++made > MOST || out.length() > mostCharacters) {
            throw tooMany(where);
        }
    }

    /** Tells that there are too many. */
    Problems.Stop tooMany(Node where) {
        mistakes.add(where, "these are too many copies: more than " + (out.length() > mostCharacters ? mostCharacters + " bytes when written out" : MOST + " in one scene"));
        return new Problems.Stop();
    }

    /**
     * How many are wished for.
     *
     * @param written the number, as it is written out
     * @throws ToldAlready if it is none, which has been told
     */
    int count(Node repeat, String written) {
        String text = written.strip();
        double count = Numbers.parsed(text).orElse(-1);
        if (count >= 0 && count == Math.rint(count) && count <= MOST) {
            return (int) count;
        }
        mistakes.add(repeat, "count", "count must be a whole number from 0 to " + MOST + ", but is " + (text.isEmpty() ? "empty" : text));
        throw new ToldAlready();
    }
}
