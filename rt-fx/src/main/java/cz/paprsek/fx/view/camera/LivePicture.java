package cz.paprsek.fx.view.camera;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.view.picture.PictureBuffer;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.picture.RegionBand;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.Tile;
import cz.paprsek.render.live.LiveListener;
import cz.paprsek.render.live.LivePass;
import cz.paprsek.render.live.LiveRender;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.geometry.Point2D;
import javafx.scene.image.ImageView;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;
import org.jspecify.annotations.Nullable;

/**
 * A scene as its camera sees it, rendered again whenever another one is shown: in a frame of the shape that the final picture has, as large
 * as there is room for.
 */
final class LivePicture extends Region implements AutoCloseable {
    private final LiveRender live = new LiveRender(Runtime.getRuntime().availableProcessors());
    private final ImageView view = new ImageView();
    private final Rectangle frame = new Rectangle();
    private final Overlay rays = new Overlay("rays");
    private final Overlay overlay = new Overlay("overlay");
    private final ReadOnlyBooleanWrapper complete = new ReadOnlyBooleanWrapper();
    private final Consumer<Throwable> onFault;
    private Optional<RegionBand> band = Optional.empty();
    private Runnable onRefreshed = () -> {};
    private Scene scene;
    private Assets assets;
    private @Nullable PictureBuffer buffer;
    private @Nullable LivePass seen;
    /** How many pictures have been begun. */
    private int pictures;

    /** @param onFault is told, on JavaFX's thread, if the renderer fails */
    LivePicture(Scene scene, Assets assets, Consumer<Throwable> onFault) {
        this.scene = scene;
        this.assets = assets;
        this.onFault = onFault;
        frame.getStyleClass().add("picture-frame");
        frame.setMouseTransparent(true);
        getStyleClass().add("live-picture");
        // Else each of them, when it changes, would have the other laid out again.
        rays.setVisible(false);
        view.setManaged(false);
        frame.setManaged(false);
        getChildren().addAll(view, frame, overlay, rays);
        // While nobody can see it, it does not take the processor from what is seen.
        sceneProperty().addListener((property, old, now) -> restart());
        visibleProperty().addListener((property, old, now) -> restart());
    }

    /** Shows another scene, with pictures from there. */
    void show(Scene next, Assets from) {
        scene = next;
        assets = from;
        placeFrame();
        restart();
    }

    /** Whether the picture is that of the newest scene, with all its samples. */
    ReadOnlyBooleanProperty completeProperty() {
        return complete.getReadOnlyProperty();
    }

    /** How high the frame is in this node, in its own units. */
    double frameHeight() {
        return frame.getHeight();
    }

    /** The point of the picture at a point of this node; empty beside the frame, and as long as there is no picture. */
    Optional<PicturePoint> at(double x, double y) {
        double across = (x - frame.getX()) / frame.getWidth();
        double down = (y - frame.getY()) / frame.getHeight();
        return atShare(across, down);
    }

    /** The point of the picture at shares of its width and height; empty beside it, and as long as there is no picture. */
    Optional<PicturePoint> atShare(double across, double down) {
        boolean inside = across >= 0 && across < 1 && down >= 0 && down < 1;
        LivePass pass = seen;
        return inside && pass != null
                ? Optional.of(new PicturePoint(pass.scene(), pass.settings(), across * pass.settings().width(), down * pass.settings().height()))
                : Optional.empty();
    }

    /** The point in the middle of the picture. */
    Optional<PicturePoint> middle() {
        return at(frame.getX() + frame.getWidth() / 2, frame.getY() + frame.getHeight() / 2);
    }

    /** What is drawn above the picture. */
    Overlay overlay() {
        return overlay;
    }

    /** Shows a rectangle over the picture, in the place of the one before. */
    void setBand(RegionBand fresh) {
        band.ifPresent(getChildren()::remove);
        band = Optional.of(fresh);
        getChildren().add(fresh);
    }

    /** How large a pixel is in the frame if the picture has so many columns. */
    double zoom(int columns) {
        return frame.getWidth() / columns;
    }

    /** Where the mouse is in the frame, whether inside or beside. */
    Point2D inFrame(double x, double y) {
        return new Point2D(x - frame.getX(), y - frame.getY());
    }

    /** Draws rays above the picture. */
    void setRays(Optional<DrawnRays> drawn) {
        rays.setVisible(drawn.isPresent());
        rays.setPainter(g -> {
            drawn.ifPresent(known -> RayOverlay.paint(g, known));
            return Optional.empty();
        });
    }

    /** Is told when another picture has come to be seen. */
    void setOnRefreshed(Runnable listener) {
        onRefreshed = listener;
    }

    /** Ends rendering for ever. */
    @Override
    public void close() {
        live.close();
    }

    @Override
    protected void layoutChildren() {
        if (placeFrame()) {
            restart();
        }
    }

    /** Makes the frame as large as there is room for; whether it changed its size. */
    private boolean placeFrame() {
        double aspect = (double) scene.settings().width() / scene.settings().height();
        double width = Math.max(1, Math.rint(Math.min(getWidth(), getHeight() * aspect)));
        double height = Math.max(1, Math.rint(Math.min(getHeight(), getWidth() / aspect)));
        boolean otherSize = width != frame.getWidth() || height != frame.getHeight();
        frame.setX(snapPositionX((getWidth() - width) / 2));
        frame.setY(snapPositionY((getHeight() - height) / 2));
        frame.setWidth(width);
        frame.setHeight(height);
        view.setX(frame.getX());
        view.setY(frame.getY());
        view.setFitWidth(width);
        view.setFitHeight(height);
        rays.place(frame.getX(), frame.getY(), width, height);
        overlay.place(frame.getX(), frame.getY(), width, height);
        band.ifPresent(known -> known.place(frame.getX(), frame.getY(), zoom(known.columns())));
        return otherSize;
    }

    private void restart() {
        complete.set(false);
        pictures++;
        if (getScene() == null || !isVisible() || getWidth() < 1 || getHeight() < 1) {
            live.stop();
            return;
        }
        double pixels = getScene().getWindow() == null ? 1 : getScene().getWindow().getRenderScaleX();
        RenderSettings settings = scene.settings().withSize(
                (int) Math.min(RenderSettings.LARGEST_SIDE, Math.ceil(frame.getWidth() * pixels)),
                (int) Math.min(RenderSettings.LARGEST_SIDE, Math.ceil(frame.getHeight() * pixels)));
        PictureBuffer target = buffer;
        if (target == null || target.width() != settings.width() || target.height() != settings.height()) {
            target = new PictureBuffer(settings.width(), settings.height());
            buffer = target;
        }
        live.show(scene, assets, settings, new Painter(pictures, target));
    }

    private void seen(LivePass pass, PictureBuffer target) {
        if (target == buffer) {
            seen = pass;
            view.setImage(target.image());
            onRefreshed.run();
        }
    }

    /** Paints one picture. */
    private final class Painter implements LiveListener {
        private final int number;
        private final PictureBuffer target;
        private boolean begun;

        Painter(int number, PictureBuffer target) {
            this.number = number;
            this.target = target;
        }

        @Override
        public void painted(LivePass pass, Image image, Tile tile) {
            target.paint(image, tile, pass.step(), ImageOptions.shown(pass.settings().exposure(), pass.settings().tone()));
        }

        @Override
        public void completed(LivePass pass, RenderResult result) {
            if (!begun) {
                begun = true;
                Platform.runLater(() -> seen(pass, target));
            }
            if (pass.isLast()) {
                Platform.runLater(() -> complete.set(number == pictures));
            }
        }

        @Override
        public void failed(Throwable fault) {
            Platform.runLater(() -> onFault.accept(fault));
        }
    }
}
