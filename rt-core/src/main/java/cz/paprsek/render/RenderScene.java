package cz.paprsek.render;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.Ray;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Spans;
import cz.paprsek.shape.Surface;
import cz.paprsek.shape.Volume;
import cz.paprsek.tree.TreeBuilder;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;

/** A scene prepared for tracing: shapes placed in the world, materials resolved, the hierarchy built. Any number of renders may use it at once. */
public final class RenderScene {
    /** Of more transparent solids than this, each may touch others: comparing all their boxes would take long. */
    private static final int MANY_MEDIA = 100;

    private final Scene scene;
    private final PartTable parts;
    /** The placed shape of each object, and whether no light gets through it. */
    private final Surface[] surfaces;
    private final boolean[] opaque;
    private final Bodies bodies;
    private final Lamp[] lamps;
    /** Whether each object is transparent, has an inside, and may touch another such object. */
    private final boolean[] mayTouch;
    /** The first part of every solid without end. */
    private final int[] endless;
    private final int[] aroundCamera;
    private final double buildSeconds;

    private RenderScene(Scene scene, RenderMonitor monitor) {
        long begin = System.nanoTime();
        this.scene = scene;
        this.parts = new PartTable(scene, monitor::cancelled);
        this.lamps = scene.lights().stream().map(Lamp::of).toArray(Lamp[]::new);
        this.surfaces = new Surface[scene.objects().size()];
        this.opaque = new boolean[surfaces.length];
        for (int i = 0; i < surfaces.length; i++) {
            TreeBuilder.stopIfAsked(i, monitor::cancelled);
            int first = parts.size();
            surfaces[i] = parts.place(i, scene.objects().get(i));
            opaque[i] = isOpaque(first, parts.size());
        }
        this.bodies = Bodies.of(surfaces, opaque, monitor::cancelled);
        this.mayTouch = touching();
        this.endless = endless();
        this.aroundCamera = solidsAround(scene.camera().position());
        this.buildSeconds = (System.nanoTime() - begin) / 1e9;
    }

    /** Takes over the bodies of another prepared scene, which has the same. */
    private RenderScene(Scene scene, RenderScene other) {
        long begin = System.nanoTime();
        this.scene = scene;
        this.parts = other.parts;
        this.surfaces = other.surfaces;
        this.opaque = other.opaque;
        this.bodies = other.bodies;
        this.mayTouch = other.mayTouch;
        this.endless = other.endless;
        this.lamps = scene.lights().stream().map(Lamp::of).toArray(Lamp[]::new);
        this.aroundCamera = solidsAround(scene.camera().position());
        this.buildSeconds = (System.nanoTime() - begin) / 1e9;
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
        Preparation preparation = new Preparation(monitor);
        try {
            return new RenderScene(scene, preparation);
        } catch (CancellationException cancelled) {
            preparation.throwFault();
            throw cancelled;
        } catch (OutOfMemoryError exhausted) {
            throw Memory.exceeded(scene, exhausted);
        }
    }

    /**
     * Prepares a scene that was made from this one by a change. If camera, lights, background or ambient light are all that changed, that
     * takes no time.
     *
     * @throws CancellationException as {@link #of(Scene, RenderMonitor)}
     * @throws IllegalStateException as there
     */
    public RenderScene changedTo(Scene changed, RenderMonitor monitor) {
        // The lists of two scenes that share their objects are one list; comparing what is in them would take as long as preparing them.
        boolean sameBodies = changed.objects() == scene.objects() && changed.materials().equals(scene.materials());
        return sameBodies ? new RenderScene(changed, this) : of(changed, monitor);
    }

    /** The scene this was made of. */
    public Scene scene() {
        return scene;
    }

    /** The time it took to prepare the scene. */
    public double buildSeconds() {
        return buildSeconds;
    }

    /** Why a pixel has its colour, in the picture that the scene asks for; column and row are counted from 0 at the top left. */
    public Pixel explain(int column, int row) {
        return explain(scene.settings(), column, row);
    }

    /**
     * Why a pixel has its colour, in a picture of these settings.
     *
     * @throws IllegalArgumentException if there is no such pixel
     */
    public Pixel explain(RenderSettings settings, int column, int row) {
        return Explainer.pixel(this, settings, column, row);
    }

    /**
     * What the ray through one point of the picture sees.
     *
     * @param x in pixels from the left edge of a picture of these settings; the middle of the first column is 0.5
     * @param y in pixels from the top
     */
    public TracedRay explainPoint(RenderSettings settings, double x, double y) {
        return Explainer.point(this, settings, x, y);
    }

    /**
     * What a ray sees that starts anywhere.
     *
     * @param origin world space; if it is inside of transparent solids, so is the ray
     * @param direction of any length but 0
     * @param maxDepth levels of rays, this one being level 1
     */
    public TracedRay explainRay(Vec3 origin, Vec3 direction, int maxDepth) {
        return Explainer.ray(this, origin, direction, maxDepth);
    }

    PartTable parts() {
        return parts;
    }

    Bodies bodies() {
        return bodies;
    }

    Lamp[] lamps() {
        return lamps;
    }

    Rgb background() {
        return scene.background();
    }

    Rgb ambient() {
        return scene.ambient();
    }

    boolean isSolid(int object) {
        return scene.objects().get(object).shape() instanceof Solid;
    }

    /** Whether no light gets through any of an object. */
    boolean isOpaque(int object) {
        return opaque[object];
    }

    /** Whether an object is a solid that light gets through. */
    boolean isMedium(int object) {
        return !opaque[object] && isSolid(object);
    }

    /** Whether a solid that light gets through may touch another one. */
    boolean mayTouchMedium(int object) {
        return mayTouch[object];
    }

    Surface surface(int object) {
        return surfaces[object];
    }

    /** Puts the ray that leaves the camera into the media the camera stands in. */
    void enterMediaAroundCamera(Media media) {
        enter(aroundCamera, media);
    }

    /** Puts a ray into the media around the point it starts from. */
    void enterMediaAround(Vec3 point, Media media) {
        enter(solidsAround(point), media);
    }

    private void enter(int[] around, Media media) {
        media.clear();
        for (int part : around) {
            if (opaque[parts.object(part)]) {
                media.surround(parts.object(part));
            } else {
                media.enter(parts.object(part), parts.finish(part).refractiveIndex);
            }
        }
    }

    private boolean isOpaque(int firstPart, int endPart) {
        for (int i = firstPart; i < endPart; i++) {
            if (parts.finish(i).transparency > 0) {
                return false;
            }
        }
        return true;
    }

    private int[] endless() {
        return IntStream.range(0, parts.size())
                .filter(part -> part == 0 || parts.object(part - 1) != parts.object(part))
                .filter(part -> isSolid(parts.object(part)) && !surfaces[parts.object(part)].bounds().isFinite()).toArray();
    }

    private boolean[] touching() {
        boolean[] touching = new boolean[surfaces.length];
        int[] media = IntStream.range(0, surfaces.length).filter(this::isMedium).toArray();
        for (int i : media) {
            touching[i] = media.length > MANY_MEDIA;
        }
        for (int i = 1; i < media.length && media.length <= MANY_MEDIA; i++) {
            for (int j = 0; j < i; j++) {
                if (!surfaces[media[i]].bounds().padded().intersection(surfaces[media[j]].bounds().padded()).isEmpty()) {
                    touching[media[i]] = true;
                    touching[media[j]] = true;
                }
            }
        }
        return touching;
    }

    /** The first part of every solid that the point is in: the opaque ones, then the transparent ones, the largest first, as if entered from outside. */
    private int[] solidsAround(Vec3 point) {
        SortedMap<Integer, Integer> firstParts = new TreeMap<>();
        Ray ray = new Ray(new Spans());
        Spans ahead = new Spans();
        ray.start(point.x(), point.y(), point.z(), 1, 0, 0);
        bodies.crossings(ray, bodies.newGatherer(ahead));
        for (int i = 0; i < ahead.size(); i++) {
            int part = ahead.part(i);
            if (isSolid(parts.object(part)) && firstParts.remove(parts.object(part)) == null) {
                firstParts.put(parts.object(part), parts.firstOfObject(part));
            }
        }
        for (int part : endless) {
            firstParts.remove(parts.object(part));
            if (((Volume) surfaces[parts.object(part)]).holdsOrigin(ray)) {
                firstParts.put(parts.object(part), part);
            }
        }
        List<Integer> inside = new ArrayList<>(firstParts.values());
        inside.sort(Comparator.comparing((Integer part) -> !opaque[parts.object(part)])
                .thenComparing(Comparator.comparingDouble((Integer part) -> surfaces[parts.object(part)].bounds().volume()).reversed()));
        return inside.stream().mapToInt(Integer::intValue).toArray();
    }
}
