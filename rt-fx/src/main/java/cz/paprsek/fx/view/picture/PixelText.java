package cz.paprsek.fx.view.picture;

import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Says of a pixel where it is, what colour it has, and what is seen there. */
public final class PixelText {
    private final Texts texts;

    public PixelText(Texts texts) {
        this.texts = texts;
    }

    /**
     * @param image the picture in linear light
     * @param how it is shown
     */
    public String of(PicturePoint point, Image image, ImageOptions how) {
        int x = point.column();
        int y = point.row();
        int argb = how.shown(image).applyAsInt(x, y);
        return String.format(texts.locale(), "%d, %d    sRGB %d %d %d    %s %.4f %.4f %.4f    %s", x, y,
                argb >> 16 & 0xFF, argb >> 8 & 0xFF, argb & 0xFF,
                texts.of("picture.linear"), image.red(x, y), image.green(x, y), image.blue(x, y), seen(point));
    }

    /** The names on the way to what is seen: of the object, and of the operands within it; or of the light. */
    private String seen(PicturePoint point) {
        return point.place().map(place -> (place instanceof BodyAt body ? body.way() : Stream.of(place))
                .map(step -> PathNames.of(point.scene().scene(), step, texts)).collect(Collectors.joining(" › ")))
                .orElseGet(() -> texts.of("picture.background"));
    }
}
