package cz.paprsek.fx.view.render;

import cz.paprsek.fx.model.picture.UnfinishedPictures;
import cz.paprsek.fx.view.render.fields.Remembered;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.concurrent.Worker;

/** What outlives the pane of renders, which is made anew for each language: the pictures that are rendered one after the other, and what was said last about how. For JavaFX's thread. */
public final class RenderDesk {
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
