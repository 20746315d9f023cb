package cz.paprsek.format;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.material.Rgb;
import cz.paprsek.shape.height.HeightField;
import java.io.IOException;
import java.io.InputStream;

/**
 * Pictures as heights: numbers as they stand in the file, of coloured ones their luminance. Those for the same limit are equal.
 *
 * @param largest how many bytes a picture may have
 */
record HeightPicture(long largest) implements Assets.Decoder<HeightField.Content> {
    /** Powers beyond these leave too little of a number in the light that it stands for. */
    private static final double LEAST_POWER = 0.1;
    private static final double MOST_POWER = 7;

    @Override
    public HeightField.Content decode(String name, InputStream input, long size) throws IOException {
        byte[] bytes = input.readNBytes((int) largest + 1);
        if (bytes.length > largest) {
            throw new IOException("is larger than the " + largest + " bytes that a picture may have here");
        }
        StoredImage picture = ImageFiles.readStored(bytes, name);
        double power = picture.power();
        if (power != StoredImage.SRGB && !(power >= LEAST_POWER && power <= MOST_POWER)) {
            throw new IOException("for heights, a picture's gamma must be from 1/" + (int) MOST_POWER + " to " + (int) (1 / LEAST_POWER) + ", but is " + 1 / power + "; save it without");
        }
        Image image = picture.image();
        int most = picture.precision() == Precision.EIGHT_BIT ? 255 : picture.precision() == Precision.SIXTEEN_BIT ? 65_535 : 0;
        try {
            return HeightField.Content.of(image.width(), image.height(), (x, y) -> step(image, x, y, most, power), most == 0 ? 1 : 1.0 / most);
        } catch (IllegalArgumentException refused) {
            throw new IOException(refused.getMessage(), refused);
        }
    }

    /**
     * A height.
     *
     * @param most the number of white in the file; 0 if it holds light
     * @param power that turned numbers into light
     */
    private static float step(Image image, int x, int y, int most, double power) {
        double red = number(image.red(x, y), most, power);
        double green = number(image.green(x, y), most, power);
        double blue = number(image.blue(x, y), most, power);
        return (float) (red == green && green == blue ? red : 0.2126 * red + 0.7152 * green + 0.0722 * blue);
    }

    private static double number(float light, int most, double power) {
        if (most == 0) {
            return light;
        }
        double share = power == StoredImage.SRGB ? Rgb.encoded(light) / 255 : power == 1 ? light : StrictMath.pow(light, 1 / power);
        return Math.rint(share * most);
    }
}
