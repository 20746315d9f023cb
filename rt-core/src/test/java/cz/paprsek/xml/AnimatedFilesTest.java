package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Animation.Ease;
import cz.paprsek.scene.Animation.Turning;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Placement;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Files in which things move: what is read, what is refused and where, what is saved, and what a frame shows. */
class AnimatedFilesTest {
    @TempDir
    private Path folder;

    private static String scene(String inside) {
        return "<scene xmlns=\"urn:paprsek:scene:1\">\n<camera name=\"eye\" position=\"0 0 9\" target=\"0 0 0\"/>\n<sphere name=\"ball\" radius=\"1\"/>\n<sphere radius=\"1\"/>\n"
                + inside + "\n</scene>\n";
    }

    private static String animate(String target, String attribute, String keys) {
        return "<animate target=\"" + target + "\" attribute=\"" + attribute + "\">" + keys + "</animate>";
    }

    private static final String MOVES = animate("ball", "position", "<key t=\"0\" value=\"0 0 0\" ease=\"catmull-rom\"/><key t=\"2\" value=\" 4 0  1e0 \"/>");

    @Test
    void bothReadersReadTheSame() throws Exception {
        String text = scene(MOVES + "<animate target=\"eye\" attribute=\"rotation\" turn=\"shortest\"><key t=\"1\" value=\"0 0 0\"/></animate>").replace("target=\"eye\"", "target=\"ball\"");
        Scene quick = SceneFiles.parse(text);
        Scene thorough = SceneReader.thoroughly(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "x").scenes().get(0);
        assertThat(quick).isEqualTo(thorough);
        assertThat(quick.animations()).containsExactly(
                new Animation("ball", "position", Turning.ANGLES, List.of(new Animation.Key(0, "0 0 0", Ease.CATMULL_ROM), new Animation.Key(2, "4 0 1", Ease.LINEAR))),
                new Animation("ball", "rotation", Turning.SHORTEST, List.of(new Animation.Key(1, "0 0 0", Ease.LINEAR))));
        assertThat(SceneFiles.parse(SceneFiles.format(quick))).isEqualTo(quick);
    }

    @Test
    void coloursMayBeNames() throws Exception {
        Scene scene = SceneFiles.parse(scene("<point-light name=\"lamp\" position=\"0 9 0\"/>" + animate("light:lamp", "color", "<key t=\"0\" value=\"red\"/><key t=\"1\" value=\"#00ff00\"/>")));
        assertThat(scene.animations().get(0).keys()).extracting(Animation.Key::value).containsExactly("255 0 0", "0 255 0");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', textBlock = """
            <animate target="bell" attribute="position"><key t="0" value="0 0 0"/></animate> | 5:10: nothing in this scene is called "bell"; did you mean "ball"?
            <animate target="ball" attribute="postion"><key t="0" value="0 0 0"/></animate> | 5:24: "ball", a sphere, has no attribute "postion"; did you mean "position"?
            <animate target="ball" attribute="angle"><key t="0" value="0"/></animate> | 5:24: "ball", a sphere, has no attribute "angle" that can be animated; there are position, rotation, scale, radius
            <animate target="camera:eye" attribute="direction"><key t="0" value="0 0 1"/></animate> | 5:30: "camera:eye", a camera, has no attribute "direction" that can be animated; there are position, target, up, fovy, aperture, focus
            <animate target="camera:eye" attribute="name"><key t="0" value="0 0 1"/></animate> | 5:30: name is no number, vector or colour, so that it cannot be animated
            <animate target="ball" attribute="radius"><key t="0" value="1"/><key t="0" value="2"/></animate> | 5:70: t of a key must be above that of the key before, which is 0, but is 0
            <animate target="ball" attribute="radius"><key t="0" value="1"/><key t="1" value="2 3"/></animate> | 5:76: value must have as many numbers as that of the key before, 1, but has 2
            <animate target="ball" attribute="position"><key t="0" value="1 2"/></animate> | 5:24: position must be three finite numbers, x y z, but its keys have 2 numbers
            <animate target="ball" attribute="radius"><key t="0" value="-1"/></animate> | 5:24: sphere radius must be a finite number above 0, but is -1
            <animate target="ball" attribute="radius"><key t="0" value="x"/></animate> | 5:54: value must be one to three finite numbers, or a colour, but is "x"
            <animate target="ball" attribute="hidden"><key t="0" value="true"/></animate> | 5:54: value must be one to three finite numbers, or a colour, but is "true"
            <param name="h" value="1" max="2"/><animate target="param:h" attribute="value"><key t="0" value="2"/><key t="1" value="2.5"/></animate> | 5:113: the parameter "h" must be a number, 2 at most, but is 2.5
            <param name="h" value="1" min="1" max="2"/><animate target="param:h" attribute="value"><key t="0" value="0"/></animate> | 5:99: the parameter "h" must be a number from 1 to 2, but is 0
            <animate target="ball" attribute="radius"><key t="0" value="1 2 x"/></animate> | 5:54: value must be one to three finite numbers, or a colour, but is "1 2 x"
            <animate target="ball" attribute="radius"><key value="1"/></animate> | 5:43: <key> needs the attribute t, a finite number
            <animate target="ball" attribute="radius"/> | 5:1: <animate> needs at least one <key> inside
            <animate target="ball" attribute="radius" turn="shortest"><key t="0" value="1"/></animate> | 5:43: turn is for rotations, which have three numbers
            <animate target="ball" attribute="position" turn="shortest"><key t="0" value="1 2 3"/></animate> | 5:24: turn is for rotations, not for position
            <animate target="ball" attribute="radius"><key t="0" value="1" ease="fast"/></animate> | 5:64: key ease must be linear, smooth, catmull-rom or hold, but is "fast"
            <animate target="param:h" attribute="value"><key t="0" value="1"/></animate> | 5:10: there is no parameter "h"
            """)
    void whatIsWrongIsToldWhereItStands(String animation, String expected) {
        assertThatThrownBy(() -> SceneFiles.parse(scene(animation))).isInstanceOfSatisfying(SceneFileException.class, e -> assertThat(
                e.problems().stream().map(one -> one.line() + ":" + one.column() + ": " + one.message()).collect(Collectors.joining("\n"))).isEqualTo(expected));
    }

    @Test
    void whatMayBeSeveralThingsAndWhatIsAnimatedTwiceIsRefused() {
        assertThatThrownBy(() -> SceneFiles.parse(scene(MOVES + "\n" + MOVES))).hasMessageContaining("6:24: there is an animation of position of \"ball\" already");
        assertThatThrownBy(() -> SceneFiles.parse(scene("<sphere radius=\"1\" name=\"sphere#2\"/>" + animate("sphere#2", "radius", "<key t=\"0\" value=\"1\"/>"))))
                .hasMessageContaining("\"sphere#2\" may be any of 2 things in this scene; give them names that tell them apart");
    }

    @Test
    void savingKeepsEveryByteButThoseOfTheChange() throws Exception {
        String text = scene("<!-- up -->\n<animate   target='ball' attribute=\"position\" >\n  <key t='0' value='0 0  0'/> <!-- here -->\n  <key t='2' value='4 0 1' />\n</animate>");
        Path file = Files.writeString(folder.resolve("a.xml"), text);
        SceneFile open = SceneFiles.open(file);
        open.save(open.scene().withObjects(List.of(open.scene().objects().get(0), open.scene().objects().get(1).at(7, 8, 9))));
        assertThat(file).hasContent(text.replace("<sphere radius=\"1\"/>", "<sphere radius=\"1\" position=\"7 8 9\"/>"));
        SceneFile again = SceneFiles.open(file);
        Animation old = again.scene().animations().get(0);
        again.save(again.scene().withAnimations(List.of(new Animation(old.target(), old.attribute(), old.turn(), List.of(old.keys().get(0), new Animation.Key(2, "5 0 1", Ease.HOLD))))));
        assertThat(file).hasContent(text.replace("<sphere radius=\"1\"/>", "<sphere radius=\"1\" position=\"7 8 9\"/>").replace("value='4 0 1' />", "value='5 0 1' ease=\"hold\" />"));
        SceneFile last = SceneFiles.open(file);
        last.save(last.scene().withAnimations(List.of()));
        assertThat(SceneFiles.read(file).animations()).isEmpty();
    }

    @Test
    void whatIsMovedMustStayInTheScene() throws Exception {
        Scene scene = SceneFiles.parse(scene(MOVES));
        assertThatIllegalArgumentException().isThrownBy(() -> scene.withObjects(List.of())).withMessageStartingWith("nothing in this scene is called \"ball\"");
    }

    @Test
    void aFrameIsTheSceneAtItsTime() throws Exception {
        Scene scene = SceneFiles.parse(scene("<render fps=\"10\"/>" + MOVES.replace("catmull-rom", "linear")));
        Scene frame = SceneFiles.frames(scene).apply(6);
        assertThat(frame.objects().get(0).placement()).isEqualTo(Placement.at(1, 0, 0.25));
        assertThat(frame.objects().get(1)).isSameAs(scene.objects().get(1));
        assertThat(frame.animations()).isEmpty();
        assertThat(SceneFiles.frames(scene).apply(1000).objects().get(0).placement()).isEqualTo(Placement.at(4, 0, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.frames(scene).apply(0.5)).withMessage("a frame must be a number from 1 on, but is 0.5");
    }

    @Test
    void formulasKnowTheTimeAndParametersMove() throws Exception {
        Scene scene = SceneFiles.parse(scene("<render fps=\"10\"/><param name=\"h\" value=\"1\" min=\"0\"/><param name=\"g\" value=\"{2*h}\"/>"
                + "<sphere name=\"up\" radius=\"1\" position=\"{t} {g} {frame}\"/>" + animate("param:h", "value", "<key t=\"0\" value=\"1\"/><key t=\"1\" value=\"{h+1}\"/>")
                + animate("up", "radius", "<key t=\"{h-1}\" value=\"1\"/><key t=\"{h}\" value=\"2\"/>")));
        assertThat(up(scene).placement().position()).isEqualTo(new Vec3(0, 2, 1));
        Scene frame = SceneFiles.frames(scene).apply(6);
        assertThat(up(frame).placement().position()).isEqualTo(new Vec3(0.5, 3, 6));
        assertThat(frame.recipe().isNone()).isTrue();
        assertThat(frame.objects().get(0)).isSameAs(scene.objects().get(0));
        assertThat(SceneFiles.parse(SceneFiles.format(scene))).isEqualTo(scene);
        assertThat(SceneFiles.frames(SceneFiles.with(scene, Map.of("h", "1"))).apply(6)).isEqualTo(frame);
    }

    private static SceneObject up(Scene scene) {
        return scene.objects().stream().filter(one -> one.name().equals("up")).findFirst().orElseThrow();
    }

    @Test
    void aFrameThatCannotBeIsNamed() throws Exception {
        Scene scene = SceneFiles.parse(scene("<render fps=\"1\"/><sphere radius=\"{3-t}\"/>"));
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.frames(scene).apply(4)).withMessageStartingWith("frame 4: ").withMessageContaining("radius must be");
    }
}
