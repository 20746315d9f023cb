package cz.paprsek.fx.view.picture;

import java.util.Objects;

/** The style sheet of pictures. */
public final class PictureStyle {
    private PictureStyle() {}

    /** Where it is. */
    public static String sheet() {
        return Objects.requireNonNull(PictureStyle.class.getResource("picture.css")).toExternalForm();
    }
}
