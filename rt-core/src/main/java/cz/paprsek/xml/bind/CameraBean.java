package cz.paprsek.xml.bind;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.adapters.CollapsedStringAdapter;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** {@code <camera>}. */
@XmlAccessorType(XmlAccessType.FIELD)
final class CameraBean extends Located {
    @XmlAttribute String name = "";
    @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) @Nullable Vec3 direction;
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) @Nullable Vec3 target;
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) @Nullable Vec3 up;
    @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String projection = Lens.Perspective.DEFAULT.projection();
    @XmlAttribute @Nullable Double fovy;
    @XmlAttribute @Nullable Double aperture;
    @XmlAttribute @Nullable Double focus;
    @XmlAttribute @Nullable Double height;
    @XmlAttribute @Nullable Double angle;

    /** The one that is given. */
    static Camera.Aim aim(String element, @Nullable Vec3 direction, @Nullable Vec3 target) {
        Require.that(direction != null || target != null, "<" + element + "> needs a direction or a target");
        Require.that(direction == null || target == null, "<" + element + "> has either a direction or a target, not both; remove one of them");
        return direction != null ? new Camera.Direction(direction) : new Camera.Target(Objects.requireNonNull(target));
    }

    Camera toCamera() {
        Camera camera = new Camera(name, position, aim("camera", direction, target), up == null ? Camera.DEFAULT.up() : up, lens());
        Require.that(up == null || !Camera.isAlong(camera.forward(), up), Camera.ALONG);
        return camera;
    }

    private Lens lens() {
        return switch (projection) {
            case "orthographic" -> {
                allow("height");
                if (height == null) {
                    throw new IllegalArgumentException("an orthographic camera needs a height: of what the picture shows");
                }
                yield new Lens.Orthographic(height);
            }
            case "spherical" -> {
                allow();
                yield new Lens.Spherical();
            }
            case "fisheye" -> {
                allow("angle");
                yield new Lens.Fisheye(orElse(angle, Lens.Fisheye.DEFAULT.angle()));
            }
            case "perspective" -> {
                allow("fovy", "aperture", "focus");
                yield new Lens.Perspective(orElse(fovy, Lens.Perspective.DEFAULT.fovy()), orElse(aperture, Lens.Perspective.DEFAULT.aperture()), orElse(focus, Lens.Perspective.DEFAULT.focus()));
            }
            default -> throw new IllegalStateException("the schema takes no projection " + projection);
        };
    }

    /** Refuses attributes of other projections. */
    private void allow(String... own) {
        refuse("fovy", fovy, "perspective", own);
        refuse("aperture", aperture, "perspective", own);
        refuse("focus", focus, "perspective", own);
        refuse("height", height, "orthographic", own);
        refuse("angle", angle, "fisheye", own);
    }

    private void refuse(String attribute, @Nullable Double value, String of, String... own) {
        Require.that(value == null || List.of(own).contains(attribute), attribute + " is for the projection " + of + ", but this camera's is " + projection);
    }

    private static double orElse(@Nullable Double given, double otherwise) {
        return given == null ? otherwise : given;
    }
}
