package cz.paprsek.fx.view.look;

import cz.paprsek.scene.Light;
import cz.paprsek.shape.Shape;
import java.util.Map;

/** The icons of kinds of things. */
public final class Icons {
    private static final String ANY_LIGHT = "mdi2l-lightbulb-on-outline";
    private static final Map<String, String> LIGHTS = Map.of(
            "spot-light", "mdi2s-spotlight-beam",
            "area-light", "mdi2c-ceiling-light-outline",
            "sphere-light", "mdi2l-lightbulb-on",
            "sun-light", "mdi2w-white-balance-sunny");
    private static final String ANY_SHAPE = "mdi2s-shape-outline";
    private static final Map<String, String> SHAPES = Map.ofEntries(
            Map.entry("sphere", "mdi2s-sphere"),
            Map.entry("block", "mdi2c-cube-outline"),
            Map.entry("ellipsoid", "mdi2e-egg-outline"),
            Map.entry("plane", "mdi2l-layers-outline"),
            Map.entry("cylinder", "mdi2c-cylinder"),
            Map.entry("cone", "mdi2c-cone"),
            Map.entry("capsule", "mdi2p-pill"),
            Map.entry("prism", "mdi2h-hexagon-outline"),
            Map.entry("superellipsoid", "mdi2s-square-rounded-outline"),
            Map.entry("extrude", "mdi2v-vector-polygon"),
            Map.entry("text", "mdi2f-format-letter-case"),
            Map.entry("isosurface", "mdi2f-function-variant"),
            Map.entry("lathe", "mdi2c-chess-pawn"),
            Map.entry("torus", "mdi2c-circle-double"),
            Map.entry("height-field", "mdi2i-image-filter-hdr"),
            Map.entry("mesh", "mdi2v-vector-triangle"),
            Map.entry("rectangle", "mdi2r-rectangle-outline"),
            Map.entry("disc", "mdi2c-circle-outline"),
            Map.entry("union", "mdi2v-vector-union"),
            Map.entry("difference", "mdi2v-vector-difference-ba"),
            Map.entry("intersection", "mdi2v-vector-intersection"));

    /** The camera that is looked through. */
    public static final String LOOKING = "mdi2v-video";
    public static final String CAMERA = "mdi2v-video-outline";
    public static final String DISSOLVE = "mdi2u-ungroup";

    private Icons() {}

    /** The icon of a shape's kind; a general one for a kind without its own. */
    public static String of(Shape shape) {
        return SHAPES.getOrDefault(shape.kind(), ANY_SHAPE);
    }

    /** The icon of a kind, by its word. */
    public static String of(String kind) {
        return SHAPES.getOrDefault(kind, ANY_SHAPE);
    }

    /** The icon of a light's kind; a general one for a kind without its own. */
    public static String of(Light light) {
        return LIGHTS.getOrDefault(light.kind(), ANY_LIGHT);
    }
}
