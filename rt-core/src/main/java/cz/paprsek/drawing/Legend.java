package cz.paprsek.drawing;

import cz.paprsek.image.Image;
import cz.paprsek.material.Rgb;
import cz.paprsek.render.mode.RenderMode.HeatScale;

/**
 * The scale of a heat map, as a strip below the picture: the colours, and what counts they stand for, a factor of 4 from mark to mark; of errors also the colour of those
 * that cannot be trusted.
 */
public final class Legend {
    /** How many rows the strip has. */
    public static final int HEIGHT = 24;

    private static final int BAR = 11;
    private static final int MARGIN = 12;
    private static final int DIGIT_WIDTH = 4;
    /** For what is on no scale. */
    private static final int[] QUESTION = {7, 1, 2, 0, 2};
    /** A stroke and ten digits, each three columns wide and five rows high, a row in three bits. */
    private static final int[][] DIGITS = {
        {1, 1, 2, 4, 4}, {7, 5, 5, 5, 7}, {2, 6, 2, 2, 7}, {7, 1, 7, 4, 7}, {7, 1, 3, 1, 7}, {5, 5, 7, 1, 1},
        {7, 4, 7, 1, 7}, {7, 4, 7, 5, 7}, {7, 1, 2, 2, 2}, {7, 5, 7, 5, 7}, {7, 5, 7, 1, 7}
    };

    private final Image image;
    private final HeatScale scale;
    private final int top;

    private Legend(Image image, HeatScale scale, int top) {
        this.image = image;
        this.scale = scale;
        this.top = top;
    }

    /** A copy of the picture with the strip below it. */
    public static Image below(Image picture, HeatScale scale) {
        Image longer = new Image(picture.width(), picture.height() + HEIGHT);
        for (int y = 0; y < picture.height(); y++) {
            for (int x = 0; x < picture.width(); x++) {
                longer.set(x, y, picture.red(x, y), picture.green(x, y), picture.blue(x, y));
            }
        }
        new Legend(longer, scale, picture.height()).draw();
        return longer;
    }

    private void draw() {
        int length = image.width() - 2 * MARGIN;
        for (int x = 0; x < length; x++) {
            for (int y = 2; y < BAR; y++) {
                set(MARGIN + x, y, scale.at((double) x / Math.max(1, length - 1)));
            }
        }
        if (scale.equals(HeatScale.ERROR)) {
            for (int i = 0; i < 8 * (BAR - 2); i++) {
                set(image.width() - 10 + i % 8, 2 + i / 8, HeatScale.UNTRUSTED);
            }
            write("?", image.width() - 8, BAR + 4);
        }
        int free = 0;
        for (double count = scale.smallest(); count <= scale.largest(); count *= 4) {
            int x = MARGIN + (int) Math.round((length - 1) * StrictMath.log(count / scale.smallest()) / StrictMath.log(scale.largest() / scale.smallest()));
            String text = count < 1 ? "1/" + Math.round(1 / count) : Long.toString(Math.round(count));
            int left = x - text.length() * DIGIT_WIDTH / 2;
            for (int y = BAR; y < BAR + 2; y++) {
                set(x, y, Rgb.WHITE);
            }
            if (left >= free) {
                write(text, left, BAR + 4);
                free = left + (text.length() + 1) * DIGIT_WIDTH;
            }
        }
    }

    private void write(String text, int left, int y) {
        for (int i = 0; i < text.length(); i++) {
            int[] rows = text.charAt(i) == '?' ? QUESTION : DIGITS[text.charAt(i) - '/'];
            for (int row = 0; row < rows.length; row++) {
                for (int column = 0; column < 3; column++) {
                    if ((rows[row] >> (2 - column) & 1) != 0) {
                        set(left + i * DIGIT_WIDTH + column, y + row, Rgb.WHITE);
                    }
                }
            }
        }
    }

    private void set(int x, int y, Rgb color) {
        if (x >= 0 && x < image.width()) {
            image.set(x, top + y, color.linearRed(), color.linearGreen(), color.linearBlue());
        }
    }
}
