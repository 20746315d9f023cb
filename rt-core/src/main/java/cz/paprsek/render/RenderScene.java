package cz.paprsek.render;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.account.Explainer;
import cz.paprsek.render.account.PathExplainer;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.Pixel.PathPixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.PartPaths;
import cz.paprsek.render.surface.World;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.stream.IntStream;

/** A scene prepared for tracing: shapes placed in the world, materials resolved, the hierarchy built. Any number of renders may use it at once. */
public final class RenderScene {
    /** Into how many instants the time is cut that a shutter is open. */
    public static final int INSTANTS = 128;

    private final World world;
    /** While the shutter is open, from the first instant to the last; empty for a moment alone. */
    private final List<World> instants;
    private final double buildSeconds;

    private RenderScene(World world, List<World> instants, double buildSeconds) {
        this.world = world;
        this.instants = instants;
        this.buildSeconds = buildSeconds;
    }

    /**
     * Prepares a scene.
     *
     * @throws CancellationException if the calling thread is interrupted before the scene is ready; it stays interrupted
     * @throws IllegalStateException if there is too little memory, saying how much would do
     */
    public static RenderScene of(Scene scene) {
        return of(scene, RenderMonitor.NONE);
    }

    /**
     * Prepares a scene unless the monitor cancels.
     *
     * @throws CancellationException if the monitor cancels or the calling thread is interrupted before the scene is ready
     * @throws IllegalStateException if the monitor throws anything, or there is too little memory: with what was thrown as its cause
     */
    public static RenderScene of(Scene scene, RenderMonitor monitor) {
        return of(scene, Assets.none(), monitor);
    }

    /**
     * Prepares a scene with pictures and meshes unless the monitor cancels.
     *
     * @param assets where its pictures and meshes come from
     * @throws java.io.UncheckedIOException if one of them cannot be read: with a sentence that says its name
     * @throws CancellationException as {@link #of(Scene, RenderMonitor)}
     * @throws IllegalStateException as there
     */
    public static RenderScene of(Scene scene, Assets assets, RenderMonitor monitor) {
        Textures textures = new Textures(Objects.requireNonNull(assets, "assets"));
        return prepared(scene, monitor, stop -> new World(read(scene, assets), textures, stop));
    }

    private static Scene read(Scene scene, Assets assets) {
        try {
            return MeshFiles.read(scene, assets);
        } catch (IOException e) {
            throw new UncheckedIOException(e.getMessage(), e);
        }
    }

    private static RenderScene prepared(Scene scene, RenderMonitor monitor, Function<BooleanSupplier, World> how) {
        long begin = System.nanoTime();
        return new RenderScene(watched(monitor, how, exhausted -> Memory.exceeded(scene, exhausted)), List.of(), (System.nanoTime() - begin) / 1e9);
    }

    private static <T> T watched(RenderMonitor monitor, Function<BooleanSupplier, T> work, Function<OutOfMemoryError, IllegalStateException> exceeded) {
        Preparation watch = new Preparation(monitor);
        try {
            return work.apply(watch::cancelled);
        } catch (CancellationException cancelled) {
            watch.throwFault();
            throw cancelled;
        } catch (OutOfMemoryError exhausted) {
            throw exceeded.apply(exhausted);
        }
    }

    private static <T> T explained(RenderMonitor monitor, Function<BooleanSupplier, T> work) {
        return watched(monitor, work, Memory::exceededByRays);
    }

    /**
     * Prepares a scene that was made from this one by changes, with the same pictures as if it were prepared anew. What has not changed is taken over: cameras,
     * lights and surroundings take no time, and objects that were moved, resized, made of something else, added or removed only their own, however many others
     * there are. All are prepared anew if more than a sixteenth has changed since that was done, or if one has been made, between two others, of very many parts.
     *
     * @throws CancellationException as {@link #of(Scene, RenderMonitor)}
     * @throws IllegalStateException as there
     */
    public RenderScene changedTo(Scene changed, RenderMonitor monitor) {
        return prepared(changed, monitor, stop -> world.changedTo(read(changed, world.assets()), stop));
    }

    /**
     * Prepares what is seen while a shutter is open: {@value #INSTANTS} instants, evenly spread. Each ray from the eye is traced in one of them, which is random. All that does not change from one to the next is prepared once.
     *
     * @param at the scene after a share of the time that the shutter is open, 0 to 1
     * @throws IllegalArgumentException if there is no scene at such a time
     * @throws CancellationException as {@link #of(Scene, RenderMonitor)}
     * @throws IllegalStateException as there
     */
    public RenderScene exposed(DoubleFunction<Scene> at, RenderMonitor monitor) {
        Objects.requireNonNull(at, "at");
        Objects.requireNonNull(monitor, "monitor");
        List<Scene> scenes = IntStream.range(0, INSTANTS).mapToObj(i -> at.apply((i + 0.5) / INSTANTS)).toList();
        long begin = System.nanoTime();
        List<World> worlds = watched(monitor, stop -> scenes.stream().map(scene -> world.changedTo(read(scene, world.assets()), stop)).toList(),
                exhausted -> Memory.exceeded(scenes.get(0), exhausted));
        return new RenderScene(worlds.get(0), worlds, (System.nanoTime() - begin) / 1e9);
    }

    /** The scene this was made of. */
    public Scene scene() {
        return world.scene();
    }

    /** The time it took to prepare the scene. */
    public double buildSeconds() {
        return buildSeconds;
    }

    /** Why a pixel has its colour, in the picture that the scene asks for; column and row are counted from 0 at the top left. */
    public Pixel explain(int column, int row) {
        return explain(scene().settings(), column, row);
    }

    /**
     * Why a pixel has its colour, in a picture of these settings.
     *
     * @throws IllegalArgumentException if there is no such pixel, or if more than 100 000 rays or a million shadow rays are behind it
     * @throws CancellationException if the calling thread is interrupted meanwhile; it stays interrupted
     * @throws IllegalStateException if there is too little memory
     */
    public Pixel explain(RenderSettings settings, int column, int row) {
        return explained(RenderMonitor.NONE, stop -> Explainer.pixel(world, settings, false, column, row, stop));
    }

    /**
     * Why a pixel has its colour, in the picture that would be rendered with these options: of them, size, depth and what is said of samples counts.
     *
     * @throws IllegalArgumentException as {@link #explain(RenderSettings, int, int)}
     * @throws CancellationException as there, or if the monitor cancels
     * @throws IllegalStateException as there, or if the monitor throws anything
     */
    public Pixel explain(RenderOptions options, int column, int row, RenderMonitor monitor) {
        return explained(monitor, stop -> Explainer.pixel(world, options.settings(), options.fixedSampler(), column, row, stop));
    }

    /** As {@link #explain(RenderOptions, int, int, RenderMonitor)}, without a monitor. */
    public Pixel explain(RenderOptions options, int column, int row) {
        return explain(options, column, row, RenderMonitor.NONE);
    }

    /**
     * What brings the light of a pixel of paths, in the picture that would be rendered with these options.
     *
     * @throws IllegalArgumentException if there is no such pixel, the options are not of paths, or more than 131 072 paths are behind it
     * @throws CancellationException as {@link #explain(RenderSettings, int, int)}, or if the monitor cancels
     * @throws IllegalStateException as there, or if the monitor throws anything
     */
    public PathPixel explainPaths(RenderOptions options, int column, int row, RenderMonitor monitor) {
        return explained(monitor, stop -> PathExplainer.pixel(world, options.settings(), options.fixedSampler(), column, row, stop));
    }

    /**
     * What the ray through one point of the picture sees.
     *
     * @param x in pixels from the left edge of a picture of these settings; the middle of the first column is 0.5
     * @param y in pixels from the top
     */
    public TracedRay explainPoint(RenderSettings settings, double x, double y) {
        return explained(RenderMonitor.NONE, stop -> Explainer.point(world, settings, x, y, stop));
    }

    /**
     * What a ray sees that starts anywhere.
     *
     * @param origin world space; if it is inside of transparent solids, so is the ray
     * @param direction of any length but 0
     * @param maxDepth levels of rays, this one being level 1
     */
    public TracedRay explainRay(Vec3 origin, Vec3 direction, int maxDepth) {
        return explained(RenderMonitor.NONE, stop -> Explainer.ray(world, origin, direction, maxDepth, stop));
    }

    World world() {
        return world;
    }

    /** While the shutter is open; empty for a moment alone. */
    List<World> instants() {
        return instants;
    }

    /**
     * What is seen at a point of the picture.
     *
     * @param place of the object, or within an operation the primitive, whose surface is seen, or of the light that is seen as a body
     * @param point where the surface is, world space
     * @param distance from the eye, scene units
     */
    public record Pick(ScenePath place, Vec3 point, double distance) {
        public Pick {
            Objects.requireNonNull(place, "place");
            Objects.requireNonNull(point, "point");
        }

        /**
         * Looks along the ray through a point of the picture.
         *
         * @param settings the picture's size
         * @param x columns from the left edge; the centre of the first pixel is 0.5
         * @param y rows from the top edge
         * @return empty if nothing is hit
         */
        public static Optional<Pick> at(RenderScene scene, RenderSettings settings, double x, double y) {
            Ray ray = new Ray(new Spans());
            if (!Eye.of(scene.scene().camera(), settings.width(), settings.height()).start(ray, x, y)) {
                return Optional.empty();
            }
            scene.world().bodies().nearest(ray, scene.world().bodies().whole(), scene.world().bodies().newFinder());
            scene.world().glows().nearest(ray);
            if (ray.part < 0) {
                return Optional.empty();
            }
            Vec3 point = new Vec3(ray.ox + ray.max * ray.dx, ray.oy + ray.max * ray.dy, ray.oz + ray.max * ray.dz);
            return Optional.of(new Pick(place(scene, ray.part), point, ray.max));
        }

        private static ScenePath place(RenderScene scene, int part) {
            World world = scene.world();
            return world.glows().has(part) ? ScenePath.light(world.glows().lamp(part))
                    : PartPaths.of(scene.scene(), world.index(world.parts().object(part))).get(world.parts().placeInObject(part));
        }
    }
}
