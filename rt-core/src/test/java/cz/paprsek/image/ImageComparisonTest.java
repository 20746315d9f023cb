package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.ImageComparison.Unit;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.material.Rgb;
import org.junit.jupiter.api.Test;

class ImageComparisonTest {
    private static final double STEP = 1 / 65_535.0;

    private static Image grey(double light) {
        Image image = new Image(4, 2);
        for (int i = 0; i < 8; i++) {
            image.set(i % 4, i / 4, light, light, light);
        }
        return image;
    }

    @Test
    void differencesAreCountedInChannelsAndPixelsBeyond() {
        Image a = grey(0.5);
        Image b = grey(0.5);
        b.set(1, 0, 0.5, 0.5 + 3 * STEP, 0.5 - STEP);
        b.set(3, 1, 0.5, 0.5, 0.5 - 6 * STEP);
        ImageComparison found = ImageComparison.of(StoredImage.of(a), StoredImage.of(b), 2.5);
        assertThat(found.largest()).isCloseTo(6, within(0.01));
        assertThat(new int[] {found.x(), found.y()}).containsExactly(3, 1);
        assertThat(found.mean()).isCloseTo(10 / 24.0, within(0.001));
        assertThat(found.rootMeanSquare()).isCloseTo(Math.sqrt(46 / 24.0), within(0.001));
        assertThat(found.beyond()).isEqualTo(2);
        assertThat(found.shareBeyond()).isEqualTo(0.25);
        assertThat(ImageComparison.of(StoredImage.of(a), StoredImage.of(b), 3.1).beyond()).isEqualTo(1);
        assertThat(ImageComparison.of(StoredImage.of(a), StoredImage.of(a), 0).beyond()).isZero();
    }

    @Test
    void theCoarserPictureSaysWhatAStepIs() {
        StoredImage floats = StoredImage.of(grey(1.5));
        StoredImage sixteen = new StoredImage(grey(1), Precision.SIXTEEN_BIT, false);
        StoredImage eight = new StoredImage(grey(Rgb.linear(254)), Precision.EIGHT_BIT, false);
        assertThat(ImageComparison.of(floats, sixteen, 2).unit()).isEqualTo(Unit.LINEAR);
        assertThat(ImageComparison.of(floats, sixteen, 2).largest()).as("clamped").isZero();
        assertThat(ImageComparison.of(eight, floats, 1).unit()).isEqualTo(Unit.SRGB);
        assertThat(ImageComparison.of(eight, floats, 1).largest()).isEqualTo(1);
        assertThat(ImageComparison.of(floats, StoredImage.of(grey(1)), 2).largest()).as("not clamped").isCloseTo(32_767.5, within(0.1));
    }

    @Test
    void aGreyPictureIsComparedInBrightness() {
        Image red = new Image(1, 1);
        red.set(0, 0, 1, 0, 0);
        Image grey = new Image(1, 1);
        grey.set(0, 0, 0.2126, 0.2126, 0.2126);
        ImageComparison found = ImageComparison.of(StoredImage.of(red), new StoredImage(grey, Precision.FLOAT, true), 0);
        assertThat(found.isGrey()).isTrue();
        assertThat(found.largest()).isCloseTo(0, within(0.01));
    }

    @Test
    void aValueThatIsNotANumberDiffersFromEverything() {
        Image bad = grey(0.5);
        bad.set(2, 1, 0.5, Double.NaN, 0.5);
        ImageComparison found = ImageComparison.of(StoredImage.of(bad), StoredImage.of(bad), 1e9);
        assertThat(found.beyond()).isEqualTo(1);
        assertThat(found.largest()).isInfinite();
        assertThat(ImageComparison.of(StoredImage.of(bad), new StoredImage(grey(0.5), Precision.SIXTEEN_BIT, false), 1e9).beyond()).isEqualTo(1);
    }

    @Test
    void picturesOfDifferentSizesAreRefused() {
        StoredImage a = StoredImage.of(grey(1));
        StoredImage b = StoredImage.of(new Image(2, 4));
        assertThatThrownBy(() -> ImageComparison.of(a, b, 1)).hasMessage("the pictures differ in size: 4x2 and 2x4");
        assertThatThrownBy(() -> ImageComparison.heatmap(a, b, 1)).hasMessage("the pictures differ in size: 4x2 and 2x4");
    }

    @Test
    void theHeatmapIsBlackThenBlueThenRedThenWhite() {
        Image a = grey(0);
        Image b = grey(0);
        b.set(1, 0, STEP, 0, 0);
        b.set(2, 0, 3 * STEP, 0, 0);
        b.set(3, 0, 1, 0, 0);
        Image map = ImageComparison.heatmap(StoredImage.of(a), StoredImage.of(b), 2);
        assertThat(map.argb(0, 0)).isEqualTo(0xFF000000);
        assertThat(map.red(1, 0)).isZero();
        assertThat(map.blue(1, 0)).isGreaterThan(0.2f);
        assertThat(map.red(2, 0)).isEqualTo(1);
        assertThat(map.green(2, 0)).isLessThan(0.1f);
        assertThat(map.argb(3, 0)).isEqualTo(0xFFFFFFFF);
    }
}
