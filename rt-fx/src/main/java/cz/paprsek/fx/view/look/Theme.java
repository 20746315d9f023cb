package cz.paprsek.fx.view.look;

import atlantafx.base.theme.PrimerDark;
import atlantafx.base.theme.PrimerLight;
import javafx.application.Application;
import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import javafx.scene.Scene;

/** How the window looks. */
public enum Theme {
    LIGHT(new PrimerLight().getUserAgentStylesheet()),
    DARK(new PrimerDark().getUserAgentStylesheet());

    /** Menus and hints without shadows and round corners, which would be white without a compositor. */
    private static final String OPAQUE = String.valueOf(Theme.class.getResource("opaque.css"));

    private final String stylesheet;

    Theme(String stylesheet) {
        this.stylesheet = stylesheet;
    }

    /** The colours of what is drawn rather than made of controls. */
    public Palette palette() {
        return this == LIGHT ? Palette.LIGHT : Palette.DARK;
    }

    /** Makes all windows look so, and this one's root bear the theme's name in lower case as a style class. */
    public void applyTo(Scene scene) {
        applyTo(scene, Platform.isSupported(ConditionalFeature.TRANSPARENT_WINDOW));
    }

    /** @param isTransparent whether a window can be seen through, as the shadow about a menu is */
    void applyTo(Scene scene, boolean isTransparent) {
        Application.setUserAgentStylesheet(stylesheet);
        scene.getStylesheets().remove(OPAQUE);
        if (!isTransparent) {
            scene.getStylesheets().add(OPAQUE);
        }
        for (Theme theme : values()) {
            scene.getRoot().getStyleClass().remove(theme.styleClass());
        }
        scene.getRoot().getStyleClass().add(styleClass());
        // What a window shows before it is painted first.
        scene.setFill(palette().background());
    }

    private String styleClass() {
        return this == LIGHT ? "light" : "dark";
    }
}
