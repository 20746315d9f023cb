package cz.paprsek.drawing;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.TracedRay.SeenLight;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * A line that draws a part of a tree in space: a ray from where it starts to what it hits, a shadow ray, or a normal.
 *
 * @param ray name of the ray that it is, or that has given rise to it
 * @param style how it is drawn
 * @param from world space
 * @param to world space; of rays that see the background, a point on the way
 */
public record RayLine(String ray, Style style, Vec3 from, Vec3 to) {
    public RayLine {
        Objects.requireNonNull(ray, "ray");
        Objects.requireNonNull(style, "style");
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(to, "to");
    }


    /** What a line is, with the colour and the dashes that tell it apart, also without the other. */
    public enum Style {
        PRIMARY("#b85c00", ""),
        REFLECTED("#1f6fd0", "8 3"),
        REFRACTED("#17803f", "12 3 3 3"),
        SHADOW_FREE("#8a7400", "2 3"),
        SHADOW_BLOCKED("#cf2f3a", "5 5"),
        NORMAL("#6b7280", "");

        private final String color;
        private final String dashes;

        Style(String color, String dashes) {
            this.color = color;
            this.dashes = dashes;
        }

        /** What it is called. */
        public String title(Words words) {
            return words.of("line." + name().toLowerCase(Locale.ROOT));
        }

        /** As CSS and SVG write it. */
        public String color() {
            return color;
        }

        /** Lengths of line and gap in turn, in pixels; empty for a whole line. */
        public List<Integer> dashes() {
            return dashes.isEmpty() ? List.of() : Stream.of(dashes.split(" ", -1)).map(Integer::valueOf).toList();
        }
    }

    /**
     * All lines of a ray and of those it gives rise to, each ray followed by its shadow rays.
     *
     * @param reach how far to draw rays that see the background
     */
    public static List<RayLine> of(Outline outline, double reach) {
        List<RayLine> lines = new ArrayList<>();
        add(outline, reach, lines);
        return lines;
    }

    /** Whether it is a ray that light is followed along, neither a shadow ray nor a normal. */
    public boolean isRay() {
        return style == Style.PRIMARY || style == Style.REFLECTED || style == Style.REFRACTED;
    }

    private static void add(Outline outline, double reach, List<RayLine> lines) {
        TracedRay ray = outline.ray();
        Vec3 end = ray.encounter().map(met -> met.place().point()).orElseGet(() ->
                ray.origin().plus(ray.direction().times(ray.seen().filter(light -> Double.isFinite(light.distance())).map(SeenLight::distance).orElse(reach))));
        lines.add(new RayLine(outline.name(), style(ray.kind()), ray.origin(), end));
        ray.encounter().ifPresent(met -> {
            lines.add(new RayLine(outline.name(), Style.NORMAL, end, end.plus(met.place().towardsViewer().times(reach / 12))));
            met.lights().stream().flatMap(term -> term.rays().stream()).filter(ShadowRay::isSent)
                    .forEach(sent -> lines.add(shadow(outline.name(), end, sent, reach)));
        });
        outline.children().forEach(child -> add(child, reach, lines));
    }

    /** A shadow ray as far as it gets. */
    private static RayLine shadow(String name, Vec3 point, ShadowRay ray, double reach) {
        boolean isBlocked = ray.visibility() == 0;
        double length = isBlocked && !ray.obstacles().isEmpty() ? ray.obstacles().get(ray.obstacles().size() - 1).distance()
                : Double.isFinite(ray.distance()) ? ray.distance() : reach;
        return new RayLine(name, isBlocked ? Style.SHADOW_BLOCKED : Style.SHADOW_FREE, point, point.plus(ray.direction().times(length)));
    }

    private static Style style(TracedRay.Kind kind) {
        return switch (kind) {
            case PRIMARY -> Style.PRIMARY;
            case REFLECTED -> Style.REFLECTED;
            case REFRACTED -> Style.REFRACTED;
        };
    }
}
