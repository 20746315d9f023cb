package cz.paprsek.fx.view.picture;

import cz.paprsek.fx.model.item.Bodies;
import cz.paprsek.fx.model.item.Item.BodyAt;
import cz.paprsek.fx.view.texts.ItemNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Says of a pixel where it is, what colour it has, and what is seen there. */
public final class PixelText {
    private final Texts texts;

    public PixelText(Texts texts) {
        this.texts = texts;
    }

    /** @param image the picture in linear light */
    public String of(PicturePoint point, Image image) {
        int x = point.column();
        int y = point.row();
        int argb = image.argb(x, y);
        return String.format(texts.locale(), "%d, %d    sRGB %d %d %d    %s %.4f %.4f %.4f    %s", x, y,
                argb >> 16 & 0xFF, argb >> 8 & 0xFF, argb & 0xFF,
                texts.of("picture.linear"), image.red(x, y), image.green(x, y), image.blue(x, y), seen(point));
    }

    /** The names on the way to what is seen: of the object, and of the operands within it; or of the light. */
    private String seen(PicturePoint point) {
        return point.body().map(body -> IntStream.rangeClosed(1, body.path().size())
                .mapToObj(length -> name(point.scene().scene(), new BodyAt(body.path().subList(0, length))))
                .collect(Collectors.joining(" › ")))
                .or(() -> point.light().map(light -> ItemNames.of(point.scene().scene(), light, texts))).orElseGet(() -> texts.of("picture.background"));
    }

    /** The name of a body; its kind if it has none. */
    private String name(Scene scene, BodyAt at) {
        Body body = Bodies.find(scene, at).orElseThrow();
        return body.name().isEmpty() ? texts.kind(body.shape()) : body.name();
    }
}
