package cz.paprsek.fx.view.look;

import atlantafx.base.theme.PrimerDark;
import atlantafx.base.theme.PrimerLight;
import javafx.application.Application;
import javafx.scene.Scene;

/** How the window looks. */
public enum Theme {
    LIGHT(new PrimerLight().getUserAgentStylesheet()),
    DARK(new PrimerDark().getUserAgentStylesheet());

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
        Application.setUserAgentStylesheet(stylesheet);
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
