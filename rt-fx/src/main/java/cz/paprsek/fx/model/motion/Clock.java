package cz.paprsek.fx.model.motion;

import cz.paprsek.format.MeshFiles;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleFunction;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import org.jspecify.annotations.Nullable;

/**
 * Which time of the scene is looked at. At rest that is none: the scene as it is written, which is what is edited. An edit that cannot be seen at the time that is looked at leads to rest, so
 * that nobody changes what he does not see. For JavaFX's thread only.
 */
public final class Clock {
    /** Of a scene in which only formulas know the time, seconds. */
    private static final double USUAL_LENGTH = 4;

    private final EditorModel model;
    private final ReadOnlyObjectWrapper<OptionalDouble> seconds = new ReadOnlyObjectWrapper<>(OptionalDouble.empty());
    /** What was looked at until an edit that could not be seen then. */
    private OptionalDouble left = OptionalDouble.empty();
    private final BooleanProperty open = new SimpleBooleanProperty();
    private Optional<Span> chosen = Optional.empty();
    private Scene film = Scene.EMPTY;
    private @Nullable DoubleFunction<Scene> moments;
    private @Nullable EditorState shown;
    private EditorState shownOf;
    private OptionalDouble shownAt = OptionalDouble.empty();
    private String refusal = "";
    /** Whether another scene has been opened that is not shown yet. */
    private boolean isOpened;

    /**
     * Frames of a film.
     *
     * @param from the first, from 1
     * @param to the last, not before that, and at most {@link #LAST}
     */
    public record Span(int from, int to) {
        /** The last frame there can be. */
        public static final int LAST = 10_000_000;

        /** @throws IllegalArgumentException if there is no such film */
        public Span {
            if (from < 1 || to < from || to > LAST) {
                throw new IllegalArgumentException("a range must be two frames from 1 to " + LAST + ", such as 1-100");
            }
        }
    }

    /** What there is to be seen at a time, and why it is not what was asked for, or nothing. */
    private record Look(EditorState state, String refusal) {}

    public Clock(EditorModel model) {
        this.model = model;
        shownOf = model.state();
        model.stateProperty().addListener((property, old, now) -> changed(old, now));
        model.openingsProperty().addListener((property, old, now) -> opened());
    }

    /** The time that is looked at, seconds; empty at rest. Changes after what {@link #shown} gives. */
    public ReadOnlyObjectProperty<OptionalDouble> secondsProperty() {
        return seconds.getReadOnlyProperty();
    }

    /** Whether the timeline is to be seen. */
    public BooleanProperty openProperty() {
        return open;
    }

    /** The time that is looked at, or 0 at rest. */
    public double time() {
        return seconds.get().orElse(0);
    }

    /** For which time keys are set: that which is looked at, or was until an edit that could not be seen then; or 0. */
    public double keyTime() {
        return seconds.get().orElse(left.orElse(0));
    }

    /** Looks at a time. */
    public void look(double time) {
        left = OptionalDouble.empty();
        seconds.set(OptionalDouble.of(Math.max(0, time)));
    }

    /** Looks at the frame with this number. */
    public void lookAtFrame(int frame) {
        look(model.scene().settings().seconds(Math.max(1, frame)));
    }

    /** Looks at the scene as it is written. */
    public void rest() {
        left = OptionalDouble.empty();
        seconds.set(OptionalDouble.empty());
    }

    /** The number of the frame that is nearest to the time looked at. */
    public int frame() {
        return frame(time());
    }

    /** The number of the frame that is nearest to a time. */
    public int frame(double time) {
        return (int) Math.rint(Math.min(1e9, time * model.scene().settings().fps())) + 1;
    }

    /** Which frames are played: those chosen, or from the first to that of the last key. */
    public Span span() {
        return chosen.orElseGet(() -> new Span(1, Math.max(2, Math.min(Span.LAST, frame(end(model.scene()))))));
    }

    /** Has other frames played; those that there are for none. */
    public void choose(Optional<Span> frames) {
        chosen = frames;
    }

    private static double end(Scene scene) {
        return scene.animations().stream().mapToDouble(Clock::end).filter(time -> time > 0).max().orElse(USUAL_LENGTH);
    }

    private static double end(Animation one) {
        List<Animation.Key> keys = one.keys();
        return keys.isEmpty() ? 0 : keys.get(keys.size() - 1).t();
    }

    /** The state as it is looked at: at the time, in which nothing moves; as it is at rest, and where a time makes no scene. */
    @SuppressWarnings("ReferenceEquality")
    public EditorState shown() {
        EditorState state = model.state();
        EditorState known = shown;
        if (known != null && shownOf == state && shownAt.equals(seconds.get())) {
            return known;
        }
        Look fresh = at(state, seconds.get());
        shown = fresh.state();
        refusal = fresh.refusal();
        shownOf = state;
        shownAt = seconds.get();
        return fresh.state();
    }

    /** Why {@link #shown} is not what is there at the time that is looked at; empty if it is. */
    public String refusal() {
        shown();
        return refusal;
    }

    private Look at(EditorState state, OptionalDouble time) {
        if (time.isEmpty() || !SceneFiles.moves(state.scene())) {
            return new Look(state, "");
        }
        try {
            return new Look(state.withScene(moment(state.scene(), time.getAsDouble())), "");
        } catch (IllegalArgumentException none) {
            return new Look(state, String.valueOf(none.getMessage()));
        }
    }

    @SuppressWarnings("ReferenceEquality")
    private Scene moment(Scene scene, double time) {
        DoubleFunction<Scene> known = moments;
        if (known == null || film != scene) {
            known = SceneFiles.frames(scene);
            moments = known;
            film = scene;
        }
        RenderSettings settings = scene.settings();
        Scene moment = known.apply(time * settings.fps() + 1);
        // What is made anew knows its meshes by their names only.
        return scene.recipe().isNone() ? moment : MeshFiles.read(moment, model.assets(), (place, problem) -> {});
    }

    private void opened() {
        chosen = Optional.empty();
        moments = null;
        isOpened = true;
        rest();
    }

    @SuppressWarnings("ReferenceEquality")
    private void changed(EditorState old, EditorState now) {
        // How the file makes it need not be the same.
        boolean isOther = old.scene() != now.scene() && !old.scene().withRecipe(Recipe.NONE).equals(now.scene().withRecipe(Recipe.NONE));
        if (isOpened) {
            isOpened = false;
            open.set(SceneFiles.moves(now.scene()));
        } else if (isOther && old.scene().animations().isEmpty() && !now.scene().animations().isEmpty()) {
            open.set(true);
        }
        if (seconds.get().isPresent() && isOther && old.scene().animations().equals(now.scene().animations())) {
            EditorState before = shownOf == old && shown != null ? shown : at(old, seconds.get()).state();
            // Formulas and all else that is not seen may differ: what counts is what is.
            if (before.scene().equals(shown().scene())) {
                left = seconds.get();
                seconds.set(OptionalDouble.empty());
            }
        }
    }
}
