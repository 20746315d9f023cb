package cz.paprsek.fx.view.present;

import cz.paprsek.drawing.DrawingFrame;
import cz.paprsek.drawing.RayLine;
import cz.paprsek.drawing.RayLine.Style;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.render.explain.text.Step;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** The rays of a pixel, told one after the other: how far the telling has come, which kinds of rays are hidden, and which numbers have been asked for. */
final class Telling {
    private final List<Outline> rays = new ArrayList<>();
    private final DrawingFrame frame;
    private final List<RayLine> lines;
    private final Map<Integer, BitSet> asked = new HashMap<>();
    private int now;

    Telling(Scene scene, Outline root) {
        collect(root);
        frame = DrawingFrame.of(scene, root);
        lines = RayLine.of(root, frame.size());
    }

    private void collect(Outline outline) {
        rays.add(outline);
        outline.children().forEach(this::collect);
    }

    /** In the order in which they are told: each before those that it gives rise to. */
    List<Outline> rays() {
        return List.copyOf(rays);
    }

    /** Which ray is being told, from 0. */
    int now() {
        return now;
    }

    Outline ray() {
        return rays.get(now);
    }

    boolean isLast() {
        return now == rays.size() - 1;
    }

    /** Goes to a ray; beyond the ends, to the last or first one. */
    void go(int ray) {
        now = Math.max(0, Math.min(rays.size() - 1, ray));
    }

    /** Goes to the ray of that name, if there is one. */
    void go(String name) {
        rays.stream().filter(ray -> ray.name().equals(name)).findFirst().ifPresent(ray -> now = rays.indexOf(ray));
    }

    List<Step> steps(Words words) {
        return ray().steps(words);
    }

    /** Whether the numbers of a line of the ray that is told have been asked for. */
    boolean isAsked(int line) {
        return asked.getOrDefault(now, new BitSet()).get(line);
    }

    void ask(int line) {
        asked.computeIfAbsent(now, ray -> new BitSet()).set(line);
    }

    /** The first line whose numbers have not been asked for; empty if none is left. */
    Optional<Integer> nextToAsk(List<Step> steps) {
        for (int line = 0; line < steps.size(); line++) {
            if (!steps.get(line).result().isEmpty() && !isAsked(line)) {
                return Optional.of(line);
            }
        }
        return Optional.empty();
    }

    void forgetAsked() {
        asked.clear();
    }

    /** What is drawn: the rays told so far, without the kinds that are hidden. */
    DrawnRays drawn(Set<Style> hidden) {
        return new DrawnRays(frame, lines.stream().filter(line -> !hidden.contains(line.style())).toList(),
                rays.subList(0, now + 1).stream().map(Outline::name).collect(Collectors.toSet()), ray().name());
    }

    /** The body that the ray hits. */
    Optional<BodyAt> body() {
        return ray().ray().encounter().map(Encounter::place).map(place -> place.surface().part());
    }

    /** Whether a line of the drawing is what a line of the exercise speaks of. */
    boolean isAbout(RayLine line, Step.Topic topic) {
        return switch (topic) {
            case RAY, AMBIENT, SUM -> line.isRay() && line.ray().equals(ray().name());
            case POINT -> line.style() == Style.NORMAL && line.ray().equals(ray().name());
            case LIGHT, SHADOW -> EnumSet.of(Style.SHADOW_FREE, Style.SHADOW_BLOCKED).contains(line.style()) && line.ray().equals(ray().name());
            case REFLECTION -> line.isRay() && line.ray().equals(ray().name() + "R");
            case REFRACTION -> line.isRay() && line.ray().equals(ray().name() + "T");
        };
    }
}
