package cz.paprsek.cli.output;

import cz.paprsek.image.ImageFormat;
import cz.paprsek.origin.Origins;
import cz.paprsek.scene.Scene;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

/** A scene's digest, which pictures tell: of thousands of bodies it takes as long as some pictures, and can be made while one is rendered. */
final class Digest {
    private final Scene scene;
    private final FutureTask<String> text;
    private boolean isBegun;

    /** @param format of the picture, which may tell no digest */
    Digest(Scene scene, ImageFormat format) {
        this.scene = scene;
        text = new FutureTask<>(() -> Origins.digest(scene));
        isBegun = !Origins.areToldIn(format);
    }

    /** Has it made from now on, by a thread of its own, if pictures of the format tell it; once. */
    synchronized void begin() {
        if (!isBegun) {
            isBegun = true;
            Thread thread = new Thread(text, "paprsek-digest");
            thread.setDaemon(true);
            thread.start();
        }
    }

    /** As {@link Origins#digest} says it; waited for, or made now if nobody has begun. */
    String text() {
        text.run();
        try {
            return text.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return Origins.digest(scene);
        } catch (ExecutionException e) {
            // Whatever it was, whoever asks is told: here it is the same, or goes well.
            return Origins.digest(scene);
        }
    }
}
