package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.picture.PictureBuffer;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.Layers;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.Tile;
import cz.paprsek.text.Numbers;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * Mixes the lights of a finished picture anew, off JavaFX's thread, and paints what becomes of it. Of wishes that come faster than they are done, the last one counts.
 * All methods may be called from any thread.
 */
final class Mixer {
    /** A light as it is: its shares of red, green and blue. */
    private static final Vec3 WHOLE = new Vec3(1, 1, 1);

    /**
     * How a light is set.
     *
     * @param shines whether there is any of it
     * @param stops how much brighter, as a power of two
     * @param through the colour of a filter before it
     */
    record Setting(boolean shines, double stops, Rgb through) {
        /** A light as it is. */
        static final Setting WHOLE = new Setting(true, 0, Rgb.WHITE);

        /** Of red, green and blue. */
        Vec3 share() {
            double gain = shines ? Math.pow(2, stops) : 0;
            return new Vec3(gain * through.linearRed(), gain * through.linearGreen(), gain * through.linearBlue());
        }
    }

    private final RenderResult result;
    private final PictureBuffer buffer;
    private final ImageOptions how;
    private Map<String, Setting> settings = Map.of();
    private Optional<Map<String, Setting>> wanted = Optional.empty();
    private Consumer<Optional<Throwable>> onMixed = failure -> {};
    private boolean isRunning;
    private Image image;
    /** How the lights of that image are set. */
    private Map<String, Setting> mixedBy = Map.of();

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

    /** How a light is set, also while it does not shine. */
    synchronized Setting setting(String light) {
        return settings.getOrDefault(light, Setting.WHOLE);
    }

    /** Who hears, on any thread, after each mixing what made it fail, such as too little memory; empty if nothing did. */
    synchronized void setOnMixed(Consumer<Optional<Throwable>> listener) {
        onMixed = listener;
    }

    /** The picture as it was mixed last. */
    synchronized Image image() {
        return image;
    }

    /** What else is known of the pixels of that picture: what each light brings to it. */
    synchronized Layers layers() {
        return result.layers().ofMix(shares(mixedBy));
    }

    /** What was changed, in words for a file; empty if nothing was. */
    synchronized String told() {
        return shares(settings).entrySet().stream().filter(entry -> !entry.getValue().equals(WHOLE))
                .map(entry -> entry.getKey() + " × " + rounded(entry.getValue().x()) + " " + rounded(entry.getValue().y()) + " " + rounded(entry.getValue().z()))
                .collect(Collectors.joining(", "));
    }

    private static String rounded(double share) {
        return Numbers.text(Math.rint(share * 1000) / 1000);
    }

    private static Map<String, Vec3> shares(Map<String, Setting> settings) {
        Map<String, Vec3> shares = new LinkedHashMap<>();
        settings.forEach((light, setting) -> shares.put(light, setting.share()));
        return shares;
    }

    /** Sets one light otherwise. */
    synchronized void set(String light, Setting setting) {
        Map<String, Setting> next = new LinkedHashMap<>(settings);
        next.put(light, setting);
        mix(next);
    }

    /** All lights as they were rendered. */
    synchronized void reset() {
        mix(Map.of());
    }

    private synchronized void mix(Map<String, Setting> next) {
        settings = next;
        wanted = Optional.of(next);
        if (!isRunning) {
            Thread thread = new Thread(this::work, "paprsek-mix");
            thread.setDaemon(true);
            thread.start();
            isRunning = true;
        }
    }

    private void work() {
        for (Optional<Map<String, Setting>> next = take(); next.isPresent(); next = take()) {
            Optional<Throwable> failure = Optional.empty();
            try {
                Image mixed = result.layers().mixed(result.image(), shares(next.get()));
                show(mixed, next.get());
                buffer.paint(mixed, new Tile(0, 0, mixed.width(), mixed.height()), 1, how);
            } catch (RuntimeException | OutOfMemoryError failed) {
                failure = Optional.of(failed);
            }
            listener().accept(failure);
        }
    }

    private synchronized Consumer<Optional<Throwable>> listener() {
        return onMixed;
    }

    private synchronized void show(Image mixed, Map<String, Setting> by) {
        image = mixed;
        mixedBy = by;
    }

    private synchronized Optional<Map<String, Setting>> take() {
        Optional<Map<String, Setting>> next = wanted;
        wanted = Optional.empty();
        isRunning = next.isPresent();
        return next;
    }
}
