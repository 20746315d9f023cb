package cz.paprsek.fx.view;

import java.util.Objects;

/** The style sheet of pictures. */
final class PictureStyle {
    private PictureStyle() {}

    /** Where it is. */
    static String sheet() {
        return Objects.requireNonNull(PictureStyle.class.getResource("picture.css")).toExternalForm();
    }
}
