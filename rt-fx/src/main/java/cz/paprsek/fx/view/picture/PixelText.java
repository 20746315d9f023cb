package cz.paprsek.fx.view.picture;

import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Says of a pixel where it is, what colour it has, and what is seen there. */
public final class PixelText {
    private final Texts texts;

    public PixelText(Texts texts) {
        this.texts = texts;
    }

    /**
     * @param image the picture in linear light, or a part of it
     * @param part where that lies in the picture
     * @param how it is shown
     * @param value the number that the colour stands for, in words; empty if it is a colour
     */
    public String of(PicturePoint point, Image image, Tile part, ImageOptions how, Optional<String> value) {
        int x = point.column();
        int y = point.row();
        return String.format(texts.locale(), "%d, %d    %s    %s", x, y, value.orElseGet(() -> color(image, x - part.x(), y - part.y(), how)), seen(point));
    }

    private String color(Image image, int x, int y, ImageOptions how) {
        int argb = how.shown(image).applyAsInt(x, y);
        return String.format(texts.locale(), "sRGB %d %d %d    %s %.4f %.4f %.4f",
                argb >> 16 & 0xFF, argb >> 8 & 0xFF, argb & 0xFF,
                texts.of("picture.linear"), image.red(x, y), image.green(x, y), image.blue(x, y));
    }

    /** The names on the way to what is seen: of the object, and of the operands within it; or of the light. */
    private String seen(PicturePoint point) {
        return point.place().map(place -> (place instanceof BodyAt body ? body.way() : Stream.of(place))
                .map(step -> PathNames.of(point.scene().scene(), step, texts)).collect(Collectors.joining(" › ")))
                .orElseGet(() -> texts.of("picture.background"));
    }
}
