package cz.paprsek.render.texture;

import cz.paprsek.asset.Assets;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** The pictures of one scene, each made ready once. */
public final class Textures {
    private record Wanted(String file, boolean isLight) {}

    private final Assets assets;
    private final Map<Wanted, Texture> ready = new ConcurrentHashMap<>();

    public Textures(Assets assets) {
        this.assets = assets;
    }

    public Assets assets() {
        return assets;
    }

    /**
     * A picture.
     *
     * @param isLight as of {@link Texture#of}
     * @throws UncheckedIOException if it cannot be read: with a sentence that says its name
     */
    public Texture texture(String file, boolean isLight) {
        return ready.computeIfAbsent(new Wanted(file, isLight), wanted -> {
            try {
                return Texture.of(assets.picture(file), isLight);
            } catch (IOException e) {
                throw new UncheckedIOException(String.valueOf(e.getMessage()), e);
            }
        });
    }
}
