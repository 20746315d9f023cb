package cz.paprsek.fx.view.look;

import javafx.scene.paint.Color;

/**
 * The colours of a projection.
 *
 * @param background behind everything
 * @param minor lines of the fine grid
 * @param major lines of the coarse grid
 * @param text labels of the grid and names
 * @param x the x axis
 * @param y the y axis
 * @param z the z axis
 * @param outline objects
 * @param ghost operands that are taken away
 * @param selected what is selected, and handles
 * @param light lights
 * @param camera the camera and its view
 */
public record Palette(Color background, Color minor, Color major, Color text, Color x, Color y, Color z, Color outline, Color ghost, Color selected,
        Color light, Color camera) {
    static final Palette LIGHT = new Palette(
            Color.web("#ffffff"), Color.web("#eef0f3"), Color.web("#d5dae1"), Color.web("#57606a"),
            Color.web("#d1242f"), Color.web("#1a7f37"), Color.web("#0969da"),
            Color.web("#3b434d"), Color.web("#9a6a9e"), Color.web("#e36209"), Color.web("#b08800"), Color.web("#6639ba"));
    static final Palette DARK = new Palette(
            Color.web("#0d1117"), Color.web("#171d26"), Color.web("#2a323d"), Color.web("#8b949e"),
            Color.web("#f85149"), Color.web("#3fb950"), Color.web("#58a6ff"),
            Color.web("#b6c0cc"), Color.web("#a371c7"), Color.web("#ff9b3d"), Color.web("#e3b341"), Color.web("#b392f0"));
}
