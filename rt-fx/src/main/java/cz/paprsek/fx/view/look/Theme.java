package cz.paprsek.fx.view.look;

import atlantafx.base.theme.PrimerDark;
import atlantafx.base.theme.PrimerLight;
import javafx.application.Application;
import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import javafx.scene.Parent;
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
        if (!stylesheet.equals(Application.getUserAgentStylesheet())) {
            Application.setUserAgentStylesheet(stylesheet);
        }
        if (isTransparent) {
            scene.getStylesheets().remove(OPAQUE);
        } else if (!scene.getStylesheets().contains(OPAQUE)) {
            scene.getStylesheets().add(OPAQUE);
        }
        mark(scene.getRoot());
        // What a window shows before it is painted first.
        scene.setFill(palette().background());
    }

    /** Has a root bear the theme's name as a style class; best before a window shows it, which then looks for styles once. */
    public void mark(Parent root) {
        if (!root.getStyleClass().contains(styleClass())) {
            root.getStyleClass().removeAll(LIGHT.styleClass(), DARK.styleClass());
            root.getStyleClass().add(styleClass());
        }
    }

    private String styleClass() {
        return this == LIGHT ? "light" : "dark";
    }
}
