package cz.paprsek.fx.view.explain;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.camera.CameraPane;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.scene.RenderSettings;
import java.util.List;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** While it is on, the camera's picture tells why its pixels have their colours, and all views draw the rays. */
public final class ExplainMode {
    private final BooleanProperty on = new SimpleBooleanProperty();
    private final EditorModel model;
    private final CameraPane camera;
    private final ExplainPane pane;

    public ExplainMode(EditorModel model, CameraPane camera, List<ProjectionPane> projections, ExplainPane pane) {
        this.model = model;
        this.camera = camera;
        this.pane = pane;
        on.addListener((property, old, now) -> pane.clear());
        pane.setOnChosen(new SurfaceSelection(model)::select);
        pane.drawnProperty().addListener((property, old, now) -> {
            projections.forEach(projection -> projection.setRays(now));
            camera.setRays(now);
        });
        pane.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                key(event);
            }
        });
        camera.setClickedFirst(this::clicked);
        camera.setOnRefreshed(this::explainAgain);
        camera.pointedProperty().addListener((property, old, now) -> {
            if (on.get()) {
                pane.hover(now.map(this::ofThePicture));
            }
        });
        camera.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (on.get()) {
                pane.step(event);
            }
        });
    }

    public BooleanProperty onProperty() {
        return on;
    }

    /** Where the explanation stands. */
    public ExplainPane pane() {
        return pane;
    }

    /** E switches on and off, Escape off; unless something is being typed. */
    public void key(KeyEvent event) {
        boolean isPlain = !event.isShortcutDown() && !event.isAltDown() && !event.isShiftDown();
        boolean isTyping = event.getTarget() instanceof TextInputControl;
        if (isPlain && !isTyping && (event.getCode() == KeyCode.E || (event.getCode() == KeyCode.ESCAPE && on.get()))) {
            on.set(!on.get());
            event.consume();
        }
    }

    /** The pixel of the full picture, by the numbers that the command line has for it, rather than one of the preview. */
    private PicturePoint ofThePicture(PicturePoint previewed) {
        return previewed.in(model.state().seen().settings());
    }

    private boolean clicked(PicturePoint point) {
        if (on.get()) {
            pane.click(ofThePicture(point));
        }
        return on.get();
    }

    /** Explains a pixel of the full picture, counted from 0; nothing as long as there is no picture. */
    public void explain(int column, int row) {
        on.set(true);
        RenderSettings settings = model.state().seen().settings();
        camera.at((column + 0.5) / settings.width(), (row + 0.5) / settings.height()).map(this::ofThePicture).ifPresent(pane::show);
    }

    /** The same place of the picture, when the scene has changed or the picture has another size. */
    private void explainAgain() {
        pane.explained().flatMap(was -> camera.at(was.x() / was.settings().width(), was.y() / was.settings().height())).map(this::ofThePicture).ifPresent(pane::show);
    }
}
