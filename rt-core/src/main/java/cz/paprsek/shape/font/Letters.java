package cz.paprsek.shape.font;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.outline.Outline;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Lines of text as letters in the plane z = 0: the first one begins at the origin and stands on y = 0. Those that show nothing are left out. */
public final class Letters {
    private static final int MOST_PIECES = 200_000;

    private final List<Letter> letters = new ArrayList<>();

    /**
     * A letter.
     *
     * @param outline in its own units, which {@code toText} takes to where it stands
     */
    public record Letter(Outline outline, Affine toText) {}

    /**
     * Sets a text.
     *
     * @param size that of the em: capitals are about 0.73 times as high
     * @throws IllegalArgumentException with a sentence if the font has not all of its letters, or is broken
     */
    public Letters(Font font, String text, double size) {
        Map<Integer, Optional<Outline>> outlines = new HashMap<>();
        double unit = size / font.unitsPerEm();
        double x = 0;
        int line = 0;
        int before = 0;
        int pieces = 0;
        for (int character : text.codePoints().toArray()) {
            if (character == '\n') {
                line++;
                x = 0;
                before = 0;
                continue;
            }
            int glyph = font.glyph(Character.isWhitespace(character) ? ' ' : character);
            if (glyph == 0) {
                throw new IllegalArgumentException("the font has no letter for " + (Character.isISOControl(character) ? "" : "\"" + Character.toString(character) + "\" ")
                        + String.format("(U+%04X)", character));
            }
            x += before == 0 ? 0 : font.kerning(before, glyph);
            Optional<Outline> outline = outlines.computeIfAbsent(glyph, unknown -> Optional.of(font.path(glyph)).filter(path -> !path.isEmpty()).map(Outline::wound));
            pieces += outline.map(Outline::count).orElse(0);
            if (pieces > MOST_PIECES) {
                throw new IllegalArgumentException("the letters have more than " + MOST_PIECES + " pieces of outlines together");
            }
            if (outline.isPresent() && outline.get().isArea()) {
                letters.add(new Letter(outline.get(), Affine.scalingAndMoving(new Vec3(unit, unit, 1), new Vec3(x * unit, -line * font.lineHeight() * unit, 0))));
            }
            x += font.width(glyph);
            before = glyph;
        }
        if (letters.isEmpty()) {
            throw new IllegalArgumentException("none of the letters shows anything");
        }
    }

    public List<Letter> all() {
        return List.copyOf(letters);
    }
}
