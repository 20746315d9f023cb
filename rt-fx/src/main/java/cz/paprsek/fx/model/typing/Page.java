package cz.paprsek.fx.model.typing;

import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.SceneText.Stand;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * What stands in the text now.
 *
 * @param text all of it
 * @param written how it differs from the text of the scene
 * @param problems why what was written is not in the scene; none as long as it has not been looked at
 * @param isCrossed whether the scene has been changed elsewhere where the text has been, so that taking the text takes that back
 * @param stands where things stand in the text of the scene
 */
public record Page(String text, Change written, List<Problem> problems, boolean isCrossed, List<Stand> stands) {
    static final Page NONE = new Page("", new Change(0, 0, ""), List.of(), false, List.of());

    public Page {
        problems = List.copyOf(problems);
        stands = List.copyOf(stands);
    }

    /** Whether there is anything in it that is not in the scene. */
    public boolean isHeld() {
        return !written.isNone();
    }

    /** The innermost thing whose element a place is in; the first, if it stands for several. */
    public Optional<ScenePath> at(int place) {
        return written.before(place).flatMap(before -> stands.stream().filter(stand -> stand.from() <= before && before < stand.to())
                .min(Comparator.comparingInt(stand -> stand.to() - stand.from())).map(Stand::place));
    }

    /** Where the element of something stands; empty if that is not known any more. */
    public Optional<Stand> of(ScenePath place) {
        return stands.stream().filter(stand -> stand.place().equals(place)).findFirst().flatMap(stand -> written.after(stand.from())
                .flatMap(from -> written.after(stand.to()).map(to -> new Stand(place, from, to))));
    }
}
