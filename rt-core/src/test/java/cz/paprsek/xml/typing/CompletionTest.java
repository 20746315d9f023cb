package cz.paprsek.xml.typing;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.xml.typing.Completion.Names;
import cz.paprsek.xml.typing.Completion.Proposal;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What could be written at a place, marked by a bar. */
class CompletionTest {
    private static final Names NAMES = new Names(List.of("glass", "gold", "own"), List.of("leg"), List.of("ball", "camera:main"));

    private static Completion at(String text) {
        int bar = text.indexOf('|');
        return Completion.at(text.substring(0, bar) + text.substring(bar + 1), bar, NAMES);
    }

    private static List<String> names(String text) {
        return at(text).proposals().stream().map(Proposal::name).toList();
    }

    @Test
    void elementsAreThoseAllowedThere() {
        assertThat(names("<scene><sphere radius=\"1\"/>|</scene>")).contains("</scene>", "sphere", "param", "repeat", "render", "difference").doesNotContain("size", "key");
        assertThat(names("<scene><difference><|</difference></scene>")).contains("</difference>", "sphere", "material").doesNotContain("camera", "rectangle");
        assertThat(names("<scene><material><ch|")).containsExactly("checker", "checkerboard");
        assertThat(names("<scene><difference><sphere radius=\"1\"></|")).containsExactly("</sphere>");
        assertThat(names("|")).containsExactly("scene");
        assertThat(names("<scene/>|")).isEmpty();
        assertThat(names("<scene><!-- a | -->")).isEmpty();
    }

    @Test
    void anElementComesWithWhatItMustHaveAndTheCaretInIt() {
        Completion found = at("<scene><sph|</scene>");
        Proposal sphere = found.proposals().get(0);
        assertThat(sphere.text()).isEqualTo("<sphere radius=\"\"/>");
        assertThat(sphere.caret()).isEqualTo("<sphere radius=\"".length());
        assertThat(found.from()).isEqualTo("<scene>".length());
    }

    @Test
    void attributesSayWhatTheirValuesMustBe() {
        List<Proposal> all = at("<scene><sphere name=\"a\" | scale=\"2\"/></scene>").proposals();
        assertThat(all.get(0)).extracting(Proposal::name, Proposal::expected, Proposal::isRequired).containsExactly("radius", "a finite number above 0", true);
        assertThat(all).extracting(Proposal::name).contains("position", "material").doesNotContain("name", "scale");
        assertThat(at("<scene><sphere ra|").proposals()).singleElement().extracting(Proposal::text).isEqualTo("radius=\"\"");
    }

    @Test
    void valuesAreWordsAndNames() {
        assertThat(names("<scene><render integrator=\"|\"/></scene>")).containsExactly("whitted", "path");
        assertThat(names("<scene><sphere material=\"g|\"/>")).containsExactly("glass", "gold");
        assertThat(names("<scene><instance of=\"|\"/>")).containsExactly("leg");
        assertThat(names("<scene><animate target=\"c|\"/>")).containsExactly("camera:main");
        assertThat(names("<scene><point-light color=\"dark|")).contains("darkred");
        assertThat(at("<scene><render integrator=\"|\"/></scene>").expected()).isEqualTo("whitted | path");
        Completion number = at("<scene><sphere radius=\"|1\"/></scene>");
        assertThat(number.expected()).isEqualTo("a finite number above 0");
        assertThat(number.proposals()).isEmpty();
        assertThat(number.to()).as("all of the value").isEqualTo("<scene><sphere radius=\"1".length());
    }
}
