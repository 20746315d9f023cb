package cz.paprsek.fx.view.motion;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.motion.Keys;
import cz.paprsek.fx.model.motion.Keys.KeyAt;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Palette;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Animation.Ease;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.text.Numbers;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableValue;
import javafx.geometry.VPos;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.shape.Rectangle;
import javafx.scene.text.Font;
import javafx.scene.text.TextAlignment;
import org.jspecify.annotations.Nullable;

/** The frames as a ruler, and below it the keys of each animation as diamonds in a line. The mouse scrubs in the ruler, and takes keys to other times. */
final class TrackCanvas extends Region {
    private static final double NAMES = 128;
    private static final double RULER = 20;
    private static final double ROW = 17;
    private static final double END = 14;
    private static final double GRAB = 7;
    private static final Font FONT = Font.font("System", 11);

    private final EditorModel model;
    private final Edits edits;
    private final Texts texts;
    private final Clock clock;
    private final ObservableValue<Theme> theme;
    private final Canvas canvas = new Canvas();
    private final ObjectProperty<Optional<KeyAt>> chosen = new SimpleObjectProperty<>(Optional.empty());
    /** The first track that is seen. */
    private int top;
    private @Nullable Gesture gesture;
    private @Nullable KeyAt grabbed;
    private boolean scrubs;

    TrackCanvas(Edits edits, Clock clock, ObservableValue<Theme> theme) {
        this.model = edits.model();
        this.edits = edits;
        this.texts = edits.texts();
        this.clock = clock;
        this.theme = theme;
        setId("timeline-tracks");
        setFocusTraversable(true);
        setAccessibleText(texts.of("timeline.title"));
        getChildren().add(canvas);
        Rectangle clip = new Rectangle();
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        setClip(clip);
        setMinSize(0, RULER + 2 * ROW);
        setOnMousePressed(this::pressed);
        setOnMouseDragged(this::dragged);
        setOnMouseReleased(event -> released());
        setOnScroll(this::scrolled);
        focusedProperty().addListener((property, old, now) -> draw());
        chosen.addListener((property, old, now) -> draw());
    }

    /** The key that is chosen. */
    ObjectProperty<Optional<KeyAt>> chosenProperty() {
        return chosen;
    }

    /** The animations that are shown, by their indexes. */
    List<Integer> tracks() {
        return Keys.tracks(model.scene(), model.selection());
    }

    /** Where a frame is, pixels from the left. */
    double x(double frame) {
        Clock.Span span = clock.span();
        return NAMES + (frame - span.from()) / Math.max(1, span.to() - span.from()) * room();
    }

    /** Where the middle of a track is, pixels from above. */
    double y(int track) {
        return RULER + (track - top + 0.5) * ROW;
    }

    private double room() {
        return Math.max(1, getWidth() - NAMES - END);
    }

    private int frame(double x) {
        Clock.Span span = clock.span();
        long frame = Math.round(span.from() + (x - NAMES) / room() * (span.to() - span.from()));
        return (int) Math.max(span.from(), Math.min(span.to(), frame));
    }

    private double x(Animation.Key key) {
        return x(key.t() * model.scene().settings().fps() + 1);
    }

    @Override
    protected double computePrefHeight(double width) {
        return RULER + ROW * Math.max(2, Math.min(5, tracks().size())) + 3;
    }

    @Override
    protected void layoutChildren() {
        canvas.setWidth(getWidth());
        canvas.setHeight(getHeight());
        draw();
    }

    private int rows() {
        return Math.max(1, (int) ((getHeight() - RULER) / ROW));
    }

    /** Draws all of it. */
    void draw() {
        if (getWidth() <= 0 || getHeight() <= 0) {
            return;
        }
        if (chosen.get().filter(key -> !key.isIn(model.scene())).isPresent()) {
            chosen.set(Optional.empty());
            return;
        }
        List<Integer> tracks = tracks();
        top = Math.max(0, Math.min(top, tracks.size() - rows()));
        Palette palette = theme.getValue().palette();
        GraphicsContext g = canvas.getGraphicsContext2D();
        g.setFill(palette.background());
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setFont(FONT);
        g.setTextBaseline(VPos.CENTER);
        ruler(g, palette);
        for (int row = 0; row < tracks.size() && row <= rows(); row++) {
            if (row + top < tracks.size()) {
                track(g, palette, tracks.get(row + top), y(row + top));
            }
        }
        if (tracks.isEmpty()) {
            g.setFill(palette.text());
            g.setTextAlign(TextAlignment.LEFT);
            g.fillText(texts.of("timeline.empty"), 8, RULER + ROW, getWidth() - 16);
        }
        head(g, palette);
        if (tracks.size() > rows()) {
            double height = getHeight() - RULER;
            g.setFill(palette.major());
            g.fillRect(getWidth() - 5, RULER + height * top / tracks.size(), 4, height * rows() / tracks.size());
        }
        if (isFocused()) {
            g.setStroke(palette.selected());
            g.setLineWidth(1);
            g.strokeRect(0.5, 0.5, getWidth() - 1, getHeight() - 1);
        }
    }

    private void ruler(GraphicsContext g, Palette palette) {
        Clock.Span span = clock.span();
        double pixels = room() / Math.max(1, span.to() - span.from());
        int step = step(56 / pixels);
        int small = step(7 / pixels);
        g.setLineWidth(1);
        g.setTextAlign(TextAlignment.CENTER);
        for (long frame = span.from() + small - 1L - (span.from() - 1 + small - 1) % small; frame <= span.to(); frame += small) {
            double x = Math.floor(x((int) frame)) + 0.5;
            g.setStroke(palette.minor());
            g.strokeLine(x, RULER, x, getHeight());
        }
        for (long frame = Math.floorDiv(span.from() + step - 1L, step) * step; frame <= span.to(); frame += step) {
            mark(g, palette, (int) frame);
        }
        if (span.from() < step * 0.6) {
            mark(g, palette, span.from());
        }
        g.setStroke(palette.major());
        g.strokeLine(0, RULER - 0.5, getWidth(), RULER - 0.5);
        g.strokeLine(NAMES - 8.5, RULER, NAMES - 8.5, getHeight());
    }

    private void mark(GraphicsContext g, Palette palette, int frame) {
        double x = Math.floor(x(frame)) + 0.5;
        g.setStroke(palette.major());
        g.strokeLine(x, RULER - 5, x, getHeight());
        g.setFill(palette.text());
        g.fillText(String.valueOf(frame), x, RULER / 2 - 2);
    }

    /** 1, 2, 5, 10 … frames, at least as many as given. */
    private static int step(double least) {
        int step = 1;
        for (int i = 0; step < least && i < 27; i++) {
            step = i % 3 == 1 ? step / 2 * 5 : step * 2;
        }
        return step;
    }

    private void track(GraphicsContext g, Palette palette, int animation, double y) {
        Scene scene = model.scene();
        Animation one = scene.animations().get(animation);
        g.setFill(palette.text());
        g.setTextAlign(TextAlignment.LEFT);
        g.fillText(name(scene, animation), 8, y, NAMES - 20);
        g.setStroke(palette.outline());
        g.setLineWidth(1.5);
        for (int i = 0; i + 1 < one.keys().size(); i++) {
            boolean holds = one.keys().get(i).ease() == Ease.HOLD;
            g.setLineDashes(holds ? new double[] {2, 4} : new double[0]);
            g.strokeLine(x(one.keys().get(i)), y, x(one.keys().get(i + 1)), y);
        }
        g.setLineDashes();
        for (int i = 0; i < one.keys().size(); i++) {
            boolean isChosen = chosen.get().equals(Optional.of(new KeyAt(animation, i)));
            diamond(g, x(one.keys().get(i)), y, isChosen ? 6.5 : 5, isChosen ? palette.selected() : palette.outline(), palette.background());
        }
    }

    private static void diamond(GraphicsContext g, double x, double y, double size, Color fill, Color edge) {
        double[] xs = {x - size, x, x + size, x};
        double[] ys = {y, y - size, y, y + size};
        g.setFill(fill);
        g.fillPolygon(xs, ys, 4);
        g.setStroke(edge);
        g.setLineWidth(1);
        g.strokePolygon(xs, ys, 4);
    }

    private void head(GraphicsContext g, Palette palette) {
        double x = Math.floor(x(clock.frame())) + 0.5;
        boolean isAtRest = clock.secondsProperty().get().isEmpty();
        if (x < NAMES - 1 || x > getWidth()) {
            return;
        }
        g.setStroke(palette.selected());
        g.setFill(isAtRest ? palette.background() : palette.selected());
        g.setLineWidth(1.5);
        if (!isAtRest) {
            g.strokeLine(x, RULER - 4, x, getHeight());
        }
        double[] xs = {x - 5, x + 5, x + 5, x, x - 5};
        double[] ys = {4, 4, RULER - 8, RULER - 3, RULER - 8};
        g.fillPolygon(xs, ys, 5);
        g.strokePolygon(xs, ys, 5);
    }

    /** What is animated, in words: "ball: position". */
    String name(Scene scene, int animation) {
        Animation one = scene.animations().get(animation);
        if (one.isOfParameter()) {
            return one.parameter();
        }
        String what = Keys.place(scene, animation).map(at -> at instanceof MaterialAt material ? material.name() : PathNames.of(scene, at, texts)).orElse("");
        return what + ": " + texts.attribute(one.attribute());
    }

    private Optional<KeyAt> keyAt(double x, double y) {
        List<Integer> tracks = tracks();
        int row = (int) Math.floor((y - RULER) / ROW) + top;
        if (y < RULER || row >= tracks.size()) {
            return Optional.empty();
        }
        List<Animation.Key> keys = model.scene().animations().get(tracks.get(row)).keys();
        Optional<KeyAt> nearest = Optional.empty();
        double least = GRAB;
        for (int i = 0; i < keys.size(); i++) {
            double distance = Math.abs(x(keys.get(i)) - x);
            if (distance <= least) {
                least = distance;
                nearest = Optional.of(new KeyAt(tracks.get(row), i));
            }
        }
        return nearest;
    }

    private void pressed(MouseEvent event) {
        requestFocus();
        event.consume();
        if (event.getButton() != MouseButton.PRIMARY) {
            return;
        }
        Optional<KeyAt> key = keyAt(event.getX(), event.getY());
        int row = (int) Math.floor((event.getY() - RULER) / ROW) + top;
        if (key.isPresent()) {
            choose(key.get());
            grabbed = key.get();
        } else if (event.getX() < NAMES - 8 && event.getY() >= RULER) {
            selectTrack(row);
        } else {
            scrubs = true;
            clock.lookAtFrame(frame(event.getX()));
            chosen.set(row >= 0 && event.getY() >= RULER && row < tracks().size() ? Keys.at(model.scene(), tracks().get(row), clock.time()) : Optional.empty());
        }
    }

    private void selectTrack(int row) {
        if (row < tracks().size()) {
            Keys.place(model.scene(), tracks().get(row)).ifPresent(place -> {
                if (place instanceof MaterialAt) {
                    model.select();
                } else {
                    model.select(place);
                }
            });
        }
    }

    /** Chooses a key and looks at its time. */
    void choose(KeyAt key) {
        chosen.set(Optional.of(key));
        clock.look(key.in(model.scene()).t());
    }

    private void dragged(MouseEvent event) {
        event.consume();
        if (scrubs) {
            clock.lookAtFrame(frame(event.getX()));
        }
        KeyAt key = grabbed;
        if (key != null) {
            Gesture open = gesture;
            if (open == null || !open.isOpen()) {
                open = model.begin(label(key.animation()));
                gesture = open;
            }
            moved(open, key, model.scene().settings().seconds(frame(event.getX())));
        }
    }

    private void moved(Gesture open, KeyAt key, double t) {
        if (edits.attempt(() -> open.preview(scene -> Keys.moved(scene, key, t)))) {
            clock.look(t);
            chosen.set(Keys.at(model.scene(), key.animation(), t));
        }
    }

    private void released() {
        scrubs = false;
        grabbed = null;
        if (gesture != null) {
            gesture.commit();
            gesture = null;
        }
    }

    /** Gives up what a drag has done. */
    boolean cancel() {
        boolean wasOpen = gesture != null && gesture.isOpen();
        if (gesture != null) {
            gesture.cancel();
        }
        grabbed = null;
        return wasOpen;
    }

    private void scrolled(ScrollEvent event) {
        top = Math.max(0, Math.min(tracks().size() - rows(), top - (int) Math.signum(event.getDeltaY())));
        event.consume();
        draw();
    }

    /** The name of an edit of keys. */
    Label label(int animation) {
        return Label.of(Edit.CHANGE, texts.of("timeline.keys-of", name(model.scene(), animation)));
    }

    /** A time as the user reads it. */
    static String seconds(double t) {
        return Numbers.text(Math.rint(t * 1000) / 1000);
    }
}
