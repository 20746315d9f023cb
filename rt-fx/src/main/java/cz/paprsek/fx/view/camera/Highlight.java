package cz.paprsek.fx.view.camera;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.fx.view.rays.BodyOutline;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.Optional;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;

/** The outline of a body above the picture of a camera. */
final class Highlight extends Canvas {
    Highlight() {
        setMouseTransparent(true);
        setManaged(false);
    }

    /** Draws a body's outline, or none any more. */
    void show(Scene scene, Optional<BodyAt> at) {
        GraphicsContext g = getGraphicsContext2D();
        g.clearRect(0, 0, getWidth(), getHeight());
        at.ifPresent(body -> BodyOutline.draw(g, new CameraView(scene.camera(), getWidth(), getHeight())::line, scene, body));
    }
}
