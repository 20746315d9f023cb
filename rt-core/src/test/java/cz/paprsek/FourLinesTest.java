package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.warning.SceneWarning;
import cz.paprsek.warning.SceneWarnings;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** A marble floor, a brass ball, a textured wall and a sky are four lines, as typed by hand. */
class FourLinesTest {
    private static final List<String> LINES = List.of(
            "<plane material='marble'/>",
            "<sphere radius='1' position='0 1 0' material='brass'/>",
            "<rectangle min='-3 0' max='3 3' position='0 0 -2'><material><brick size='0.5 0.2 0.5' even='160 84 62' odd='210 200 190'/></material></rectangle>",
            "<sky/>");

    private static Scene scene(List<String> lines) throws Exception {
        return SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><render width='48' height='36'/><camera position='0 1.5 7' target='0 1 0'/>"
                + "<sun-light direction='-0.5 -0.8 -0.6'/><ambient color='100 100 110'/>" + String.join("\n", lines) + "</scene>");
    }

    @Test
    void theyAreASceneWithNothingToWarnOf() throws Exception {
        assertThat(SceneWarnings.of(scene(LINES)).stream().map(SceneWarning::message)).isEmpty();
    }

    /** Without it, the picture is another one: at more than a twentieth of its pixels by more than a step of 8 bits. */
    @Test
    void eachOfThemIsSeen() throws Exception {
        Image whole = Renderer.render(scene(LINES));
        for (String line : LINES) {
            Image without = Renderer.render(scene(LINES.stream().filter(other -> !other.equals(line)).toList()));
            long others = IntStream.range(0, 48 * 36).filter(i -> whole.argb(i % 48, i / 48) != without.argb(i % 48, i / 48)).count();
            assertThat(others).as(line).isGreaterThan(48 * 36 / 20);
        }
    }

    /** From the horizon upwards by the height of the ray, in linear light: the upper corner is nearer to the zenith than the middle of the sky. */
    @Test
    void theSkyIsOfThreeColours() throws Exception {
        Image image = Renderer.render(scene(LINES));
        assertThat(image.blue(0, 0)).isGreaterThan(image.red(0, 0)).isLessThan(image.blue(0, 10));
    }

    /** No two of a row's pixels of the floor alike would be noise, all alike paint. */
    @Test
    void theFloorHasVeinsAndTheBallMirrorsThem() throws Exception {
        Image image = Renderer.render(scene(LINES));
        assertThat(IntStream.range(0, 48).map(x -> image.argb(x, 33)).distinct().count()).isGreaterThan(10);
        assertThat(IntStream.range(19, 29).map(x -> image.argb(x, 24)).distinct().count()).isGreaterThan(5);
        assertThat(image.red(24, 22)).as("brass is yellow").isGreaterThan(image.blue(24, 22));
    }
}
