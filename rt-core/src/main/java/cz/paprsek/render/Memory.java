package cz.paprsek.render;

import cz.paprsek.render.denoise.Denoiser;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;

/** Says what takes the memory of a render that has run out of it, and how much would do. */
final class Memory {
    private static final long MEGABYTE = 1 << 20;
    private static final long GIGABYTE = 1 << 30;
    /** Bytes of a body, with all that is prepared for it and the most that this takes meanwhile: measured, see docs/performance.md, and rounded up. */
    private static final long BODY = 500;
    /** Bytes of a picture's pixel: three floats, and one number of the sRGB that is made of them to be written or shown. */
    private static final long PIXEL = 16;
    private static final int LIGHT = 3;

    private Memory() {}

    /** For a scene that could not be prepared. */
    static IllegalStateException exceeded(Scene scene, OutOfMemoryError cause) {
        long bodies = bodies(scene);
        return exceeded("a scene of " + bodies + (bodies == 1 ? " body" : " bodies") + " takes " + size(bodies * BODY), bodies * BODY, "", cause);
    }

    /** For rays that could not be written down. */
    static IllegalStateException exceededByRays(OutOfMemoryError cause) {
        return exceeded("what is written down of these rays takes more", 0, ", or explain fewer levels or samples", cause);
    }

    /** For a picture that could not be rendered. */
    static IllegalStateException exceeded(Scene scene, RenderOptions options, OutOfMemoryError cause) {
        if (String.valueOf(cause.getMessage()).contains("thread")) {
            return new IllegalStateException("the system does not allow " + options.threads() + " more threads; render with fewer", cause);
        }
        int width = options.region().width();
        int height = options.region().height();
        // Beyond the light: opacity, layers, of paths what is kept from pass to pass, and what a denoiser works with.
        long picture = (PIXEL + (long) Float.BYTES * (options.channels(scene) - LIGHT + (options.denoised() ? Denoiser.NUMBERS : 0))) * width * height;
        long bodies = bodies(scene);
        return exceeded("a picture of " + width + " × " + height + " pixels takes " + size(picture)
                + " and its scene of " + bodies + (bodies == 1 ? " body " : " bodies ") + size(bodies * BODY),
                picture + bodies * BODY, ", or render it in parts, region by region", cause);
    }

    private static IllegalStateException exceeded(String what, long bytes, String otherwise, OutOfMemoryError cause) {
        long limit = Runtime.getRuntime().maxMemory();
        // A third more, since a collector needs room to work in; and if that is there already, the rest of the program must have taken it.
        long enough = Math.max(bytes + bytes / 3 + 64 * MEGABYTE, limit + limit / 2);
        return new IllegalStateException("out of memory: " + what + ", but Java may use " + size(limit) + " for everything; -Xmx"
                + (enough + MEGABYTE - 1) / MEGABYTE + "m would do" + otherwise, cause);
    }

    private static String size(long bytes) {
        return bytes < GIGABYTE ? (bytes + MEGABYTE - 1) / MEGABYTE + " MB" : Math.ceil(10.0 * bytes / GIGABYTE) / 10 + " GB";
    }

    private static long bodies(Scene scene) {
        return scene.objects().stream().mapToLong(object -> bodies(object.shape())).sum();
    }

    private static long bodies(Shape shape) {
        return shape instanceof Csg csg ? csg.operands().stream().map(Operand::solid).mapToLong(Memory::bodies).sum() : 1;
    }
}
