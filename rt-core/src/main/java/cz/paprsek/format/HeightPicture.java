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

/** Pictures as heights: numbers as they stand in the file, of coloured ones their luminance. */
final class HeightPicture {
    static final Assets.Decoder<HeightField.Content> DECODER = HeightPicture::read;

    private HeightPicture() {}

    private static HeightField.Content read(String name, InputStream input, long size) throws IOException {
        byte[] bytes = input.readNBytes((int) Assets.LARGEST + 1);
        if (bytes.length > Assets.LARGEST) {
            throw new IOException("is larger than the " + Assets.LARGEST + " bytes that a picture may have here");
        }
        StoredImage picture = ImageFiles.readStored(bytes, name);
        Image image = picture.image();
        int most = picture.precision() == Precision.EIGHT_BIT ? 255 : picture.precision() == Precision.SIXTEEN_BIT ? 65_535 : 0;
        float[] steps = new float[image.width() * image.height()];
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                steps[y * image.width() + x] = step(image, x, y, most);
            }
        }
        try {
            return HeightField.Content.of(image.width(), image.height(), steps, most == 0 ? 1 : 1.0 / most);
        } catch (IllegalArgumentException refused) {
            throw new IOException(refused.getMessage(), refused);
        }
    }

    /** @param most the number of white in the file; 0 if it holds light */
    private static float step(Image image, int x, int y, int most) {
        double red = number(image.red(x, y), most);
        double green = number(image.green(x, y), most);
        double blue = number(image.blue(x, y), most);
        return (float) (red == green && green == blue ? red : 0.2126 * red + 0.7152 * green + 0.0722 * blue);
    }

    private static double number(float light, int most) {
        return most == 0 ? light : Math.rint(Rgb.encoded(light) / 255 * most);
    }
}
