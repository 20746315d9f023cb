package cz.paprsek.render.surface;

import cz.paprsek.material.Rgb;
import cz.paprsek.render.light.Glows;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.TreeBuilder;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** A scene as rays meet it: shapes placed in the world, materials resolved, the tree built. Immutable; any number of workers may use it at once. */
public final class World {
    /** Of more transparent solids than this, each may touch others: comparing all their boxes would take long. */
    private static final int MANY_MEDIA = 100;

    private final Scene scene;
    private final PartTable parts;
    /** The placed shape of each object, and whether no light gets through it. */
    private final Surface[] surfaces;
    private final boolean[] opaque;
    private final Bodies bodies;
    private final Lamp[] lamps;
    private final Glows glows;
    /** Whether each object is transparent, has an inside, and may touch another such object. */
    private final boolean[] mayTouch;
    /** What the inside of each object takes of light: nothing in place of null. */
    private final @Nullable Absorption[] absorbing;
    private final boolean absorbs;
    /** The first part of every solid without end. */
    private final int[] endless;
    private final int[] aroundCamera;

    /**
     * Places a scene.
     *
     * @param stop whether to give up, which throws a {@link java.util.concurrent.CancellationException}
     */
    public World(Scene scene, BooleanSupplier stop) {
        this.scene = scene;
        this.parts = new PartTable(scene, stop);
        this.lamps = scene.lights().stream().map(Lamp::of).toArray(Lamp[]::new);
        this.surfaces = new Surface[scene.objects().size()];
        this.opaque = new boolean[surfaces.length];
        this.absorbing = new Absorption[surfaces.length];
        // Of what lies in one place the lowest part is met first: other things lie on bodies of glass, never a hair's breadth in them.
        place(false, stop);
        place(true, stop);
        this.absorbs = Stream.of(absorbing).anyMatch(Objects::nonNull);
        this.bodies = Bodies.of(surfaces, opaque, stop);
        this.glows = Glows.of(scene.lights(), parts.size());
        this.mayTouch = touching();
        this.endless = findEndless();
        this.aroundCamera = new Surroundings(this).around(scene.camera().position());
    }

    private void place(boolean media, BooleanSupplier stop) {
        for (int i = 0; i < surfaces.length; i++) {
            TreeBuilder.stopIfAsked(i, stop);
            SceneObject object = scene.objects().get(i);
            if ((isSolid(i) && parts.letsLightThrough(object.material(), object.shape())) == media) {
                int first = parts.size();
                surfaces[i] = parts.place(i, object);
                opaque[i] = isOpaque(first, parts.size());
                absorbing[i] = isSolid(i) ? absorbing(first, parts.size()) : null;
            }
        }
    }

    /** Takes over the bodies of another prepared scene, which has the same. */
    public World(Scene scene, World other) {
        this.scene = scene;
        this.parts = other.parts;
        this.surfaces = other.surfaces;
        this.opaque = other.opaque;
        this.bodies = other.bodies;
        this.absorbing = other.absorbing;
        this.absorbs = other.absorbs;
        this.mayTouch = other.mayTouch;
        this.endless = other.endless;
        this.glows = Glows.of(scene.lights(), parts.size());
        this.lamps = scene.lights().stream().map(Lamp::of).toArray(Lamp[]::new);
        this.aroundCamera = new Surroundings(this).around(scene.camera().position());
    }

    /** The scene this was made of. */
    public Scene scene() {
        return scene;
    }

    public PartTable parts() {
        return parts;
    }

    public Bodies bodies() {
        return bodies;
    }

    public Lamp[] lamps() {
        return lamps;
    }

    /** The lights that are seen. */
    public Glows glows() {
        return glows;
    }

    public Rgb background() {
        return scene.background();
    }

    public Rgb ambient() {
        return scene.ambient();
    }

    public boolean isSolid(int object) {
        return scene.objects().get(object).shape() instanceof Solid;
    }

    /** Whether no light gets through any of an object. */
    public boolean isOpaque(int object) {
        return opaque[object];
    }

    /** Whether an object is a solid that light gets through. */
    public boolean isMedium(int object) {
        return !opaque[object] && isSolid(object);
    }

    /** Whether a solid that light gets through may touch another one. */
    public boolean mayTouchMedium(int object) {
        return mayTouch[object];
    }

    /** Whether the inside of any object takes something of light. */
    public boolean absorbs() {
        return absorbs;
    }

    /**
     * What the inside of an object takes of light; null if that is nothing.
     *
     * @param object −1 for what is around all objects
     */
    public @Nullable Absorption absorption(int object) {
        return object < 0 ? null : absorbing[object];
    }

    public Surface surface(int object) {
        return surfaces[object];
    }

    /** The first part of every solid that the camera's position is in. */
    int[] aroundCamera() {
        return aroundCamera;
    }

    /** Of all solids without end, the first part. */
    int[] endless() {
        return endless;
    }

    private boolean isOpaque(int firstPart, int endPart) {
        for (int i = firstPart; i < endPart; i++) {
            if (parts.finish(i).transparency > 0) {
                return false;
            }
        }
        return true;
    }

    /** One body has one inside: that of its first part which light gets through. */
    private @Nullable Absorption absorbing(int firstPart, int endPart) {
        for (int i = firstPart; i < endPart; i++) {
            if (parts.finish(i).transparency > 0) {
                Absorption inside = new Absorption(parts.finish(i).material);
                return inside.isAny() ? inside : null;
            }
        }
        return null;
    }

    private int[] findEndless() {
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

    /**
     * Sets the media beyond the surface that a ray has hit. A flat figure has no inside.
     *
     * @param leaving whether the ray comes from the inside
     * @return their refractive index
     */
    public double enterBeyond(Level level, Finish finish, boolean leaving, Media beyond) {
        beyond.set(level.media);
        int object = parts.object(level.ray.part);
        if (level.ray.max > level.ray.contact || !level.beyond) {
            beyond.forgetPassed();
        }
        if (isSolid(object)) {
            if (leaving) {
                beyond.leave(object);
                beyond.pass(object);
            } else {
                beyond.enter(object, finish.refractiveIndex);
            }
        }
        return beyond.refractiveIndex();
    }
}
