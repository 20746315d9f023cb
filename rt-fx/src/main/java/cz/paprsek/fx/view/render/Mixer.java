package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.picture.PictureBuffer;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.Tile;
import cz.paprsek.text.Numbers;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Mixes the lights of a finished picture anew, off JavaFX's thread, and paints what becomes of it. Of wishes that come faster than they are done, the last one counts.
 * All methods may be called from any thread.
 */
final class Mixer {
    /** A light as it is: its shares of red, green and blue. */
    static final Vec3 WHOLE = new Vec3(1, 1, 1);

    private final RenderResult result;
    private final PictureBuffer buffer;
    private final ImageOptions how;
    private Map<String, Vec3> shares = Map.of();
    private Optional<Map<String, Vec3>> wanted = Optional.empty();
    private boolean isRunning;
    private Image image;

    /**
     * @param result with a layer of each light
     * @param buffer where it is shown
     * @param how it is shown
     */
    Mixer(RenderResult result, PictureBuffer buffer, ImageOptions how) {
        this.result = result;
        this.buffer = buffer;
        this.how = how;
        this.image = result.image();
    }

    /** The words of all lights that there are layers of. */
    List<String> lights() {
        return result.layers().lights();
    }

    /** How much of a light there is, or will soon be. */
    synchronized Vec3 share(String light) {
        return shares.getOrDefault(light, WHOLE);
    }

    /** The picture as it was mixed last. */
    synchronized Image image() {
        return image;
    }

    /** What was changed, in words for a file; empty if nothing was. */
    synchronized String told() {
        return shares.entrySet().stream().filter(entry -> !entry.getValue().equals(WHOLE))
                .map(entry -> entry.getKey() + " × " + rounded(entry.getValue().x()) + " " + rounded(entry.getValue().y()) + " " + rounded(entry.getValue().z()))
                .collect(Collectors.joining(", "));
    }

    private static String rounded(double share) {
        return Numbers.text(Math.rint(share * 1000) / 1000);
    }

    /** Has another share of one light. */
    synchronized void set(String light, Vec3 share) {
        Map<String, Vec3> next = new LinkedHashMap<>(shares);
        next.put(light, share);
        mix(next);
    }

    /** All lights as they were rendered. */
    synchronized void reset() {
        mix(Map.of());
    }

    private synchronized void mix(Map<String, Vec3> next) {
        shares = next;
        wanted = Optional.of(next);
        if (!isRunning) {
            isRunning = true;
            Thread thread = new Thread(this::work, "paprsek-mix");
            thread.setDaemon(true);
            thread.start();
        }
    }

    private void work() {
        for (Optional<Map<String, Vec3>> next = take(); next.isPresent(); next = take()) {
            Image mixed = result.layers().mixed(result.image(), next.get());
            show(mixed);
            buffer.paint(mixed, new Tile(0, 0, mixed.width(), mixed.height()), 1, how);
        }
    }

    private synchronized void show(Image mixed) {
        image = mixed;
    }

    private synchronized Optional<Map<String, Vec3>> take() {
        Optional<Map<String, Vec3>> next = wanted;
        wanted = Optional.empty();
        isRunning = next.isPresent();
        return next;
    }
}
