package cz.paprsek.fx.view.rays;

import cz.paprsek.drawing.DrawingFrame;
import cz.paprsek.drawing.RayLine;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What drawings show of an explained pixel.
 *
 * @param frame the part of the world around the rays
 * @param lines all lines of the tree
 * @param shown names of the rays that the tree has grown to
 * @param highlighted name of the ray that is drawn bold; empty for none
 */
public record DrawnRays(DrawingFrame frame, List<RayLine> lines, Set<String> shown, String highlighted) {
    public DrawnRays {
        lines = List.copyOf(lines);
        shown = Set.copyOf(shown);
    }

    /** The lines to draw, those of the highlighted ray last and so above the others. */
    public List<RayLine> visible() {
        return lines.stream().filter(line -> shown.contains(line.ray()))
                .sorted((a, b) -> Boolean.compare(isHighlighted(a), isHighlighted(b))).toList();
    }

    /** The ray from the eye; empty while the tree has not grown to it. */
    public Optional<RayLine> eyeRay() {
        return lines.stream().filter(line -> line.style() == RayLine.Style.PRIMARY).findFirst();
    }

    boolean isHighlighted(RayLine line) {
        return line.ray().equals(highlighted);
    }
}
