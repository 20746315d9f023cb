package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Memory;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.FileStore;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Objects;

/** Whether there is room for a picture, in memory and on the disk: asked before it is traced. */
final class Room {
    private static final int LIGHT = 3;
    /** Two copies of 8-bit pixels, which the platform's writers need; OpenEXR's table of blocks comes before them. */
    private static final int ENCODED = 8;
    /** Numbers of a pixel that a denoiser works with. */
    private static final int DENOISED = 41;
    /** About what an object takes with all that is prepared of it. */
    private static final int OBJECT = 600;

    private Room() {}

    /** How many bytes of memory a picture takes until it is written. */
    static long memory(Scene scene, RenderOptions options, ImageFormat format) {
        boolean isEncoded = switch (format) {
            case JPG, BMP, TIF, EXR -> true;
            case PNG, PPM, PGM, PFM, TXT, RAW, PPM16, HDR -> false;
        };
        // Layers are copied when all is there; what is kept from pass to pass is not.
        long traced = Float.BYTES * ((long) options.channels(scene) + options.keptFrom(scene) - LIGHT + (options.denoised() ? DENOISED : 0));
        return (long) options.region().width() * options.region().height() * (isEncoded ? traced + ENCODED : traced);
    }

    /** What takes the memory, and what to do. */
    static String sentence(Scene scene, RenderOptions options, ImageFormat format) {
        long objects = (long) scene.objects().size() * OBJECT;
        long picture = memory(scene, options, format);
        boolean isPicture = picture >= objects;
        return Memory.sentence(isPicture ? "the picture of " + options.region().width() + "x" + options.region().height() + " pixels" : "the scene of " + scene.objects().size() + " objects",
                picture + objects) + (isPicture ? "; or render in parts with --region" : "");
    }

    /** @throws IOException if the disk has no room for a picture whose size is known beforehand */
    static void checkDisk(Path file, long bytes) throws IOException {
        Path folder = Objects.requireNonNull(file.toAbsolutePath().getParent());
        FileStore disk;
        try {
            disk = Files.getFileStore(folder);
        } catch (FileSystemException e) {
            throw e;
        } catch (IOException unknown) {
            // Below another root, as installers and containers have it, the system's list of disks may lack the one at hand: writing tells.
            return;
        }
        if (!Files.exists(file) || Files.isRegularFile(file)) {
            long free = disk.getUsableSpace();
            // Some systems know no number.
            if (free < bytes && disk.getTotalSpace() > 0) {
                throw new IOException(file + ": no space left on device: the picture takes at least " + megabytes(bytes) + ", but " + megabytes(free) + " are free");
            }
        }
    }

    private static String megabytes(long bytes) {
        return String.format(Locale.ROOT, "%.1f MB", bytes / 1e6);
    }
}
