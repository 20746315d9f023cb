package cz.paprsek.format.gltf;

import cz.paprsek.material.Pattern;
import cz.paprsek.math.Vec3;
import java.io.IOException;
import java.util.Optional;

/**
 * Where the places in a picture come from: of which set, and how they are scaled, turned and moved.
 *
 * @param set the number of the set
 * @param rotation radians, counter-clockwise in the picture, v going down
 * @source Khronos Group, KHR_texture_transform
 */
record Mapping(int set, double offsetU, double offsetV, double rotation, double scaleU, double scaleV) {
    static final Mapping PLAIN = new Mapping(0, 0, 0, 0, 1, 1);

    static Mapping of(Tree info) throws IOException {
        int set = info.whole("texCoord", 0);
        Optional<Tree> transform = info.extension("KHR_texture_transform");
        if (transform.isEmpty()) {
            return new Mapping(set, 0, 0, 0, 1, 1);
        }
        double[] offset = transform.get().numbers("offset", 0, 0);
        double[] scale = transform.get().numbers("scale", 1, 1);
        return new Mapping(transform.get().whole("texCoord", set), offset[0], offset[1], transform.get().number("rotation", 0), scale[0], scale[1]);
    }

    double u(double u, double v) {
        return StrictMath.cos(rotation) * scaleU * u + StrictMath.sin(rotation) * scaleV * v + offsetU;
    }

    /** Going up, as ours does. */
    double v(double u, double v) {
        return 1 - (-StrictMath.sin(rotation) * scaleU * u + StrictMath.cos(rotation) * scaleV * v + offsetV);
    }

    /**
     * How a picture of this mapping is to lie where vertices have the places of another: both scale and move the same set, and neither turns it.
     *
     * @return nothing if one turns, or takes another set
     */
    Optional<Pattern.Lay> within(Mapping other) {
        if (equals(other)) {
            return Optional.of(Pattern.Lay.NONE);
        }
        double u = scaleU / other.scaleU;
        double v = scaleV / other.scaleV;
        boolean isFinite = u != 0 && v != 0 && Double.isFinite(1 / u) && Double.isFinite(1 / v);
        if (set != other.set || rotation != 0 || other.rotation != 0 || !isFinite) {
            return Optional.empty();
        }
        double fromV = 1 - offsetV - v * (1 - other.offsetV);
        return Optional.of(new Pattern.Lay(new Vec3(other.offsetU - offsetU / u, -fromV / v, 0), Vec3.ZERO, new Vec3(1 / u, 1 / v, 1)));
    }
}
