package cz.paprsek.render.surface;

import cz.paprsek.asset.Assets;
import cz.paprsek.material.Rgb;
import cz.paprsek.render.glow.Glows;
import cz.paprsek.render.light.Emitters;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.placed.Surface;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** A scene as rays meet it: shapes placed in the world, materials resolved, the tree built. Never changes; any number of workers may use it at once. */
public final class World {
    private final Scene scene;
    private final Placed placed;
    private final PartTable parts;
    private final Bodies bodies;
    private final Backdrop sky;
    private final Lamp[] lamps;
    private final Glows glows;
    private final int[] aroundCamera;
    private final Shining shining;

    /**
     * Places a scene.
     *
     * @param textures its pictures
     * @param stop whether to give up, which throws a {@link java.util.concurrent.CancellationException}
     */
    public World(Scene scene, Textures textures, BooleanSupplier stop) {
        this(scene, new Placed(scene, textures, stop), new Shining(scene));
    }

    private World(Scene scene, Placed placed, Shining shining) {
        this.shining = shining;
        this.scene = scene;
        this.placed = placed;
        this.parts = placed.parts;
        this.sky = Backdrop.of(scene, placed.textures);
        this.bodies = placed.bodies;
        this.lamps = scene.lights().stream().map(Lamp::of).toArray(Lamp[]::new);
        this.glows = Glows.of(scene.lights(), parts.end());
        this.aroundCamera = new Surroundings(this).around(scene.camera().position());
    }

    /** A scene that was made from this one's by a change: what has not changed is taken over. */
    public World changedTo(Scene changed, BooleanSupplier stop) {
        boolean shinesAlike = changed.objects() == scene.objects() && changed.materials() == scene.materials() && changed.lights().size() == scene.lights().size();
        return new World(changed, placed.changedTo(changed, stop), shinesAlike ? shining : new Shining(changed));
    }

    /** The scene this was made of. */
    public Scene scene() {
        return scene;
    }

    /** Where its pictures and meshes come from. */
    public Assets assets() {
        return placed.textures.assets();
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

    /** The objects that shine and that paths look for. */
    public Emitters emitters() {
        return shining.found();
    }

    /** What shines in a scene: found when it is first asked for, as only paths ask, and then every worker; once for all scenes in which it is the same. */
    private static final class Shining {
        private final Scene scene;
        private @Nullable Emitters found;

        Shining(Scene scene) {
            this.scene = scene;
        }

        synchronized Emitters found() {
            if (found == null) {
                found = Emitters.of(scene);
            }
            return found;
        }
    }

    /** The lights that are seen. */
    public Glows glows() {
        return glows;
    }

    /** What rays see that hit nothing. */
    public Backdrop sky() {
        return sky;
    }

    public Rgb ambient() {
        return scene.ambient();
    }

    /** The index in the scene of an object, whose number it keeps when others are added or removed. */
    public int index(int object) {
        return placed.index(object);
    }

    /** The indexes of the objects that were placed beside those that were taken over from the scene that this one was made of. */
    public IntStream later() {
        return placed.later();
    }

    public boolean isSolid(int object) {
        return placed.isSolid(object);
    }

    /** Whether no light gets through any of an object. */
    public boolean isOpaque(int object) {
        return placed.isOpaque(object);
    }

    /** Whether an object is a solid that light gets through. */
    public boolean isMedium(int object) {
        return placed.isMedium(object);
    }

    /** Whether a solid that light gets through may touch another one. */
    public boolean mayTouchMedium(int object) {
        return placed.mayTouch(object);
    }

    /** Finds the place of the level's hit in a picture that covers the surface; of lights, which none covers, always the same one. */
    public void map(Level level) {
        int face = level.ray.face;
        if (glows.has(level.ray.part)) {
            level.hit.u = 0;
            level.hit.v = 0;
            return;
        }
        parts.part(level.ray.part, level.copied).map(face < 0 ? ~face : face, level.hit);
    }

    /** Whether rays are to know how far their neighbours are: if a picture is seen, on a surface or in the sky, or a finish asks. */
    public boolean asksForFootprints() {
        return parts.havePictures() || sky.isPicture();
    }

    /** Whether some surface is rough. */
    public boolean isRough() {
        return parts.isRough();
    }

    /** Whether light that gets through the level's surface meets both sides of it at once, and is not bent. */
    public boolean isPane(Level level, Finish finish) {
        return finish.transparency > 0 && (finish.isThin || !isSolid(parts.object(level.ray.part)));
    }

    /** Whether the inside of any object takes something of light. */
    public boolean absorbs() {
        return placed.absorbs;
    }

    /**
     * What the inside of an object takes of light; null if that is nothing.
     *
     * @param object −1 for what is around all objects
     */
    public @Nullable Absorption absorption(int object) {
        return object < 0 ? null : placed.absorption(object);
    }

    public Surface surface(int object) {
        return placed.surface(object);
    }

    /** The first part of every solid that the camera's position is in. */
    int[] aroundCamera() {
        return aroundCamera;
    }

    /** Of all solids without end, the first part. */
    int[] endless() {
        return placed.endless;
    }

    /**
     * Sets the media beyond the surface that a ray has hit. A flat figure has no inside.
     *
     * @return their refractive index
     */
    public double enterBeyond(Level level, Finish finish, Media beyond) {
        beyond.set(level.media);
        int object = parts.object(level.ray.part);
        if (level.ray.max > level.ray.contact || !level.beyond) {
            beyond.forgetPassed();
        }
        if (isSolid(object)) {
            if (level.leaving) {
                beyond.leave(object);
                beyond.pass(object);
            } else {
                beyond.enter(object, finish.isThin ? level.media.refractiveIndex() : finish.refractiveIndex);
            }
        }
        return beyond.refractiveIndex();
    }
}
