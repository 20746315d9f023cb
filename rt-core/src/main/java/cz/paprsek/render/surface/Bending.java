package cz.paprsek.render.surface;

import cz.paprsek.material.Material.Bump;
import cz.paprsek.material.Material.NormalMap;
import cz.paprsek.material.Material.Relief;
import cz.paprsek.material.Pattern;
import cz.paprsek.math.Affine;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.texture.Texture;
import cz.paprsek.render.texture.Textures;
import java.util.List;

/** Bends the normal that light is reckoned with, before that is turned to the viewer. */
abstract class Bending {
    /** Leaves it as it is. */
    static final Bending NONE = new Bending() {
        @Override
        void bend(Level level) {}

        @Override
        void tell(Level level, List<Told> told) {}
    };

    private Bending() {}

    abstract void bend(Level level);

    /** Says what it goes by at the level's hit. */
    abstract void tell(Level level, List<Told> told);

    /**
     * That of a relief.
     *
     * @param toDeclared from the world to the space of the object that declares it
     */
    static Bending of(Relief relief, Affine toDeclared, Textures textures) {
        if (relief instanceof Bump bump) {
            return new ByHeight(bump, toDeclared, textures);
        }
        return relief instanceof NormalMap map ? new ByMap(map, toDeclared, textures.texture(map.file(), false)) : NONE;
    }

    /**
     * By the slope of a height. In the space of the object that declares it N becomes N − s·∇h, of the part of ∇h across N; whence in the world
     * n/|Mᵀn| − s·(g − (g·q)/(n·q)·n), where M leads from there to the world, g is the slope in the world across n, and q = M·Mᵀn.
     *
     * @source Blinn, Simulation of Wrinkled Surfaces, SIGGRAPH 1978
     */
    private static final class ByHeight extends Bending {
        private final double strength;
        private final String kind;
        private final Paint height;
        private final Affine toWorld;

        ByHeight(Bump bump, Affine toDeclared, Textures textures) {
            strength = bump.strength();
            kind = bump.pattern().kind();
            height = Paint.of(bump.pattern(), toDeclared, textures, false);
            toWorld = toDeclared.inverse();
        }

        @Override
        void bend(Level level) {
            Hit hit = level.hit;
            height.slope(level);
            double[] slope = level.slope;
            double wx = toWorld.xx() * hit.sx + toWorld.yx() * hit.sy + toWorld.zx() * hit.sz;
            double wy = toWorld.xy() * hit.sx + toWorld.yy() * hit.sy + toWorld.zy() * hit.sz;
            double wz = toWorld.xz() * hit.sx + toWorld.yz() * hit.sy + toWorld.zz() * hit.sz;
            double qx = toWorld.directionX(wx, wy, wz);
            double qy = toWorld.directionY(wx, wy, wz);
            double qz = toWorld.directionZ(wx, wy, wz);
            double upright = slope[0] * hit.sx + slope[1] * hit.sy + slope[2] * hit.sz;
            double gx = slope[0] - upright * hit.sx;
            double gy = slope[1] - upright * hit.sy;
            double gz = slope[2] - upright * hit.sz;
            double c = (gx * qx + gy * qy + gz * qz) / (hit.sx * qx + hit.sy * qy + hit.sz * qz);
            double k = 1 / Math.sqrt(wx * wx + wy * wy + wz * wz) + strength * c;
            hit.bend(k * hit.sx - strength * gx, k * hit.sy - strength * gy, k * hit.sz - strength * gz);
        }

        @Override
        void tell(Level level, List<Told> told) {
            height.ask(level);
            told.add(height.tell(level, "bump", kind));
        }
    }

    /** By the points of a picture. */
    private static final class ByMap extends Bending {
        private final String file;
        private final Texture texture;
        private final double strength;
        private final Pattern.Filter filter;
        private final Mapping mapping;

        ByMap(NormalMap map, Affine toDeclared, Texture texture) {
            this.file = map.file();
            this.texture = texture;
            strength = map.strength();
            filter = map.filter();
            mapping = Mapping.of(map.mapping(), Paint.toOwn(map.lay(), toDeclared), Paint.toOwn(map.lay(), Affine.IDENTITY));
        }

        @Override
        void bend(Level level) {
            Hit probe = level.probe;
            level.chart.lay(level, mapping);
            level.chart.look(texture, filter, level.hit.u, level.hit.v, probe);
            level.chart.bend(strength * (2 * probe.red - 1), strength * (2 * probe.green - 1), 2 * probe.blue - 1, level.hit);
        }

        @Override
        void tell(Level level, List<Told> told) {
            Hit probe = level.probe;
            level.chart.lay(level, mapping);
            level.chart.look(texture, filter, level.hit.u, level.hit.v, probe);
            told.add(PicturePaint.told(level, "normal-map", "image", file, texture, probe.red, probe.green, probe.blue));
        }
    }
}
