package cz.paprsek.cli.output;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles.GrowingPng;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import java.util.Optional;
import java.util.OptionalInt;

/** What is done beside the rays, by processors they leave over, and would be waited for in the end: the scene's digest, and of a PNG that takes about a second the rows that are complete. */
final class Beside implements AutoCloseable {
    /** Of larger ones, and of those of more rays, it matters more to know how long they take than that they are written a little sooner. */
    private static final int MOST_PIXELS = 1_000_000;

    /** After so large a part of the tiles rays are traced by compiled methods, and whoever compiles needs no processor any more. */
    private static final int DIGEST_AFTER = 8;

    private final Digest digest;
    /** Of the PNG. */
    private final OptionalInt bits;
    private Optional<GrowingPng> png = Optional.empty();

    private Beside(Digest digest, OptionalInt bits) {
        this.digest = digest;
        this.bits = bits;
    }

    /** @param how the picture is written if it has a file of its own */
    static Beside of(Digest digest, Target target, RenderOptions options, Optional<ImageOptions> how) {
        boolean isShort = !options.isInPasses() && options.settings().samples() == 1 && (long) options.region().width() * options.region().height() <= MOST_PIXELS;
        boolean isPlain = target.file().isPresent() && target.format() == ImageFormat.PNG && options.settings().exposure() == 0 && options.settings().tone() == Tone.NONE;
        return new Beside(digest, how.isPresent() && isShort && isPlain ? OptionalInt.of(how.get().bitsOf(ImageFormat.PNG)) : OptionalInt.empty());
    }

    Digest digest() {
        return digest;
    }

    /** The picture, if its rows have been compressed, and are written like this. */
    Optional<GrowingPng> png(Image image, ImageOptions how) {
        return png.filter(growing -> growing.isOf(image, how));
    }

    private synchronized void finished(Tile tile, Image image, int done, int tiles) {
        if (done >= tiles / DIGEST_AFTER) {
            digest.begin();
        }
        if (bits.isPresent()) {
            GrowingPng growing = png.orElseGet(() -> new GrowingPng(image, bits.getAsInt()));
            png = Optional.of(growing);
            growing.finished(tile.y(), tile.width(), tile.height());
        }
    }

    /** Tells all to another monitor. */
    RenderMonitor telling(RenderMonitor other) {
        return new Telling(other, this);
    }

    @Override
    public void close() {
        png.ifPresent(GrowingPng::close);
    }

    private record Telling(RenderMonitor own, Beside beside) implements RenderMonitor.PassingOn {
        @Override
        public boolean wantsRows() {
            return beside.bits.isPresent();
        }

        @Override
        public void found(Tile tile, Image image, int done, int total) {
            beside.finished(tile, image, done, total);
            own.found(tile, image, done, total);
        }

        @Override
        public void finished(Tile tile, Image image, int done, int total) {
            beside.finished(tile, image, done, total);
            own.finished(tile, image, done, total);
        }
    }
}
