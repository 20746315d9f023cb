package cz.paprsek.fx.view.render;

import cz.paprsek.fx.model.picture.UnfinishedPictures;
import cz.paprsek.fx.view.picture.Framing;
import cz.paprsek.fx.view.render.fields.RegionFields;
import cz.paprsek.fx.view.render.fields.Remembered;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.RenderSettings;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javafx.beans.value.ObservableValue;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.concurrent.Worker;

/** What outlives the pane of renders, which is made anew for each language: the pictures that are rendered one after the other, and what was said last about how. For JavaFX's thread. */
public final class RenderDesk {
    /** The names of what is said about the size and the part. */
    private static final String SIZE = "size";
    static final String REGION = "region";
    private static final Pattern SIZES = Pattern.compile("([1-9]\\d{0,4})x([1-9]\\d{0,4})");

    private final Remembered said;
    private final UnfinishedPictures unfinished;
    private final ObservableList<RenderTask> queue = FXCollections.observableArrayList();

    /**
     * A desk without pictures.
     *
     * @param said what was said last of how to render
     * @param unfinished where pictures are kept for a program that ends before they are done
     */
    public RenderDesk(Remembered said, UnfinishedPictures unfinished) {
        this.said = said;
        this.unfinished = unfinished;
    }

    /** Where pictures are kept for a program that ends before they are done. */
    UnfinishedPictures unfinished() {
        return unfinished;
    }

    /** What was said last about how to render, where it is not as the scene asks. */
    Remembered said() {
        return said;
    }

    /** As {@link #framing}, to be followed as what was said changes. */
    public ObservableValue<Map<String, String>> saidProperty() {
        return said.answersProperty();
    }

    /** How large a picture of a scene is to be, and which part of it is rendered; as the scene asks if what was said is of another shape. */
    public Framing framing(RenderSettings asked) {
        String own = word(asked.width(), asked.height());
        String size = Optional.ofNullable(said.answers().get(SIZE)).filter(word -> isOfShape(word, asked)).orElse(own);
        int at = size.indexOf('x');
        return new Framing(Integer.parseInt(size.substring(0, at)), Integer.parseInt(size.substring(at + 1)),
                Optional.ofNullable(said.answers().get(REGION)).flatMap(word -> RegionFields.parse(word, size)));
    }

    /**
     * From now on only a part of pictures as large is rendered.
     *
     * @param asked what the scene asks for, whose size is kept to as long as it is that
     * @param part of whole pictures if it is empty
     */
    public void setRegion(Framing picture, RenderSettings asked, Optional<Tile> part) {
        if (part.isEmpty()) {
            said.forget(REGION);
            return;
        }
        String size = word(picture.columns(), picture.rows());
        Map<String, String> now = new HashMap<>(said.answers());
        if (size.equals(word(asked.width(), asked.height()))) {
            now.remove(SIZE);
        } else {
            now.put(SIZE, size);
        }
        now.put(REGION, RegionFields.word(part.get(), size));
        said.set(now);
        follow(asked);
    }

    /** Forgets the part if it is none of what the scene asks for now, such as a picture of another shape. */
    public void follow(RenderSettings asked) {
        if (said.answers().containsKey(REGION) && framing(asked).part().isEmpty()) {
            said.forget(REGION);
        }
    }

    private static String word(int columns, int rows) {
        return columns + "x" + rows;
    }

    /** Within what whole pixels make of it. */
    private static boolean isOfShape(String word, RenderSettings asked) {
        Matcher m = SIZES.matcher(word);
        if (!m.matches()) {
            return false;
        }
        double columns = Integer.parseInt(m.group(1));
        double rows = Integer.parseInt(m.group(2));
        return Math.abs(columns * asked.height() - rows * asked.width()) <= asked.width() + asked.height();
    }

    /** The picture under way, and those that wait for it, in their turn; not to be changed by others. */
    ObservableList<RenderTask> queue() {
        return queue;
    }

    /** Renders a picture as soon as those before it are done. */
    void add(RenderTask task) {
        task.stateProperty().addListener((property, old, now) -> {
            if (task.isOver()) {
                queue.remove(task);
                next();
            }
        });
        queue.add(task);
        next();
    }

    private void next() {
        if (!queue.isEmpty() && queue.get(0).getState() == Worker.State.READY) {
            start(queue.get(0), "paprsek-render");
        }
    }

    /** Whether a picture waits, and can be so many places later, or earlier if that is negative. */
    boolean canMove(RenderTask task, int by) {
        int at = queue.indexOf(task);
        return at > 0 && at + by > 0 && at + by < queue.size();
    }

    /** Has a picture that waits be rendered later, or earlier. */
    void move(RenderTask task, int by) {
        if (canMove(task, by)) {
            int to = queue.indexOf(task) + by;
            queue.remove(task);
            queue.add(to, task);
        }
    }

    /** Cancels all that runs and waits. */
    void cancelAll() {
        for (int i = queue.size() - 1; i >= 0; i--) {
            queue.get(i).cancel();
        }
    }

    /** Runs something on a thread that ends with the program. */
    static void start(Runnable task, String name) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
    }
}
