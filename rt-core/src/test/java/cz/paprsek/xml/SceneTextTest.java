package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

/** What the text of a scene means, and what no text can hold. */
class SceneTextTest {
    private static final Scene PLAIN = Scene.EMPTY;
    private static final String XS = "http://www.w3.org/2001/XMLSchema";

    @Test
    void theExampleOfTheFormatMeansWhatItSays() throws Exception {
        Scene scene = SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1" name="Glass and steel">
                  <render width="1280" height="720" max-depth="5"/>
                  <background color="20 92 184"/>
                  <ambient color="0 0 0"/>
                  <camera position="0 2 8" direction="0 -0.2 -1" up="0 1 0" fovy="45"/>
                  <point-light name="key" position="4 5 3" color="255 255 255" intensity="0.8"/>
                  <material name="steel" color="180 190 200" diffusion="0.3" specular="0.6" shininess="100" reflection="0.5"/>
                  <sphere name="ball" radius="0.5" position="0 0.5 0" material="steel"/>
                  <rectangle name="floor" min="-5 -5" max="5 5" rotation="-90 0 0">
                    <material diffusion="0.8"><checkerboard columns="10" rows="10" even="255 255 255" odd="40 40 40"/></material>
                  </rectangle>
                  <block name="crate" min="-3 0 -1" max="-2 1 0"><material color="200 160 60"/></block>
                  <ellipsoid name="egg" semi-axes="0.4 0.8 0.4" position="2 0.8 0">
                    <material color="240 240 255" diffusion="0.1" transparency="0.85" refractive-index="1.5" specular="0.8" shininess="120"/>
                  </ellipsoid>
                  <difference name="bowl" position="-1 0.5 2" rotation="0 30 0" material="steel">
                    <sphere radius="0.5"/>
                    <block min="-1 0.1 -1" max="1 1 1"><material color="230 60 60"/></block>
                  </difference>
                </scene>
                """);
        Material steel = Material.color(180, 190, 200).withDiffusion(0.3).withHighlight(0.6, 100).withReflection(0.5);
        assertThat(scene).isEqualTo(new Scene("Glass and steel", "", List.of(), new RenderSettings(1280, 720, 5, 1),
                new Rgb(20, 92, 184), Sky.NONE, Rgb.BLACK, List.of(Camera.looking(new Vec3(0, 2, 8), new Vec3(0, -0.2, -1))),
                List.of(Light.at(4, 5, 3).named("key").withIntensity(0.8)), Map.of("steel", steel), List.of(
                        SceneObject.of(new Sphere(0.5)).named("ball").at(0, 0.5, 0).madeOf("steel"),
                        SceneObject.of(new Rectangle(-5, -5, 5, 5)).named("floor").rotated(-90, 0, 0).madeOf(
                                Material.DEFAULT.withPattern(new Pattern.Checkerboard(10, 10, Rgb.WHITE, Rgb.grey(40)))),
                        SceneObject.of(new Block(new Vec3(-3, 0, -1), new Vec3(-2, 1, 0))).named("crate").madeOf(Material.color(200, 160, 60)),
                        SceneObject.of(new Ellipsoid(new Vec3(0.4, 0.8, 0.4))).named("egg").at(2, 0.8, 0).madeOf(
                                Material.color(240, 240, 255).withDiffusion(0.1).withTransparency(0.85, 1.5).withHighlight(0.8, 120)),
                        SceneObject.of(Csg.difference(Operand.of(new Sphere(0.5)),
                                        Operand.of(new Block(new Vec3(-1, 0.1, -1), new Vec3(1, 1, 1))).madeOf(Material.color(230, 60, 60))))
                                .named("bowl").at(-1, 0.5, 2).rotated(0, 30, 0).madeOf(new MaterialName("steel")))));
        assertThat(SceneFiles.parse(SceneFiles.format(scene))).isEqualTo(scene);
    }

    @Test
    void whatEqualsItsDefaultIsLeftOut() {
        assertThat(SceneFiles.format(PLAIN.plus(SceneObject.of(new Sphere(2))).plus(Light.at(1, 2.5, 1e-7)))).isEqualTo("""
                <?xml version="1.0" encoding="UTF-8"?>
                <scene xmlns="urn:paprsek:scene:1">
                  <camera position="0 1 5" direction="0 0 -1"/>
                  <point-light position="1 2.5 1e-7"/>
                  <sphere radius="2"/>
                </scene>
                """);
    }

    @Test
    void oneScaleStandsForThree() throws Exception {
        String text = SceneFiles.format(PLAIN.plus(SceneObject.of(new Sphere(1)).scaled(2, 2, 2), SceneObject.of(new Sphere(1)).scaled(2, 2, -2)));
        assertThat(text).contains(" scale=\"2\"", " scale=\"2 2 -2\"");
        assertThat(SceneFiles.parse(text.replace("scale=\"2\"", "scale=\"2 2 2\""))).isEqualTo(SceneFiles.parse(text));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 1.0 / 3, 0.1 + 0.2, Double.MIN_NORMAL, Double.MIN_VALUE, 1e-45, 1e44, 1e7, 123456789, 1e22, 2e-3, 1e16})
    void everyNumberReadsBackAsItself(double number) throws Exception {
        Scene scene = PLAIN.plus(SceneObject.of(new Sphere(Math.max(number, 1e-45))).at(-number, -0.0, 0))
                .plus(Light.at(-0.0, number, 0).withIntensity(Math.min(number, 1e12)));
        assertThat(SceneFiles.parse(SceneFiles.format(scene))).isEqualTo(scene);
    }

    @Test
    void minusZeroIsKept() throws Exception {
        Scene scene = PLAIN.withBackground(new Rgb(-0.0, 0, 0)).plus(SceneObject.of(new Sphere(1)).at(-0.0, 0, 0).madeOf(Material.DEFAULT.withReflection(-0.0)));
        assertThat(SceneFiles.parse(SceneFiles.format(scene))).isEqualTo(scene);
    }

    @Test
    void nestingUpToTheLimitReadsBack() throws Exception {
        // The scene and the innermost sphere are levels, too.
        Scene deepest = nested(SceneFiles.DEEPEST - 2);
        assertThat(SceneFiles.parse(SceneFiles.format(deepest))).isEqualTo(deepest);
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.format(nested(SceneFiles.DEEPEST - 1)))
                .withMessage("the scene is nested deeper than the 250 levels that a file may have");
        assertThatIllegalArgumentException().as("the database is one more").isThrownBy(() -> SceneFiles.formatAll(List.of(deepest.withName("deepest"))));
    }

    private static Scene nested(int levels) {
        Solid solid = new Sphere(1);
        for (int i = 0; i < levels; i++) {
            solid = new Csg(i % 2 == 0 ? Csg.Operation.UNION : Csg.Operation.DIFFERENCE, List.of(Operand.of(solid)));
        }
        return PLAIN.plus(SceneObject.of(solid));
    }

    @Test
    void textsOfAllKindsReadBack() throws Exception {
        String odd = "a  b <&>\"' é 光 😀 ]]> --";
        Scene scene = PLAIN.withName(odd).withTags(List.of("x<", "&y")).withDescription(" two\n\tlines\r\nand\rmore ]]> \u0085\u2028" + odd + "\n")
                .plus(odd, Material.DEFAULT).plus(SceneObject.of(new Sphere(1)).named(odd).madeOf(odd)).plus(Light.at(1, 2, 3).named(odd));
        assertThat(SceneFiles.parse(SceneFiles.format(scene))).isEqualTo(scene);
        assertThat(SceneFiles.parse(SceneFiles.format(PLAIN.withDescription("  ")))).isEqualTo(PLAIN.withDescription("  "));
    }

    @Test
    void whatCouldNotBeReadIsNotWritten() {
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.format(PLAIN.withName("a\nb")))
                .withMessage("scene name must not have control characters, but has U+000A");
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.format(PLAIN.withName("x".repeat(201))))
                .withMessage("scene name must have 1 to 200 characters, but has 201");
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.format(PLAIN.withTags(List.of("two words"))))
                .withMessage("a scene's tag must be one word, but is \"two words\"");
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.format(PLAIN.withTags(List.of(""))));
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.format(PLAIN.withDescription("bell\u0007")))
                .withMessage("a text has the character U+0007, which no file can hold; remove it");
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.format(PLAIN.withDescription("half \uD83D")));
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.format(PLAIN.withDescription("x".repeat(100_001))));
    }

    @ParameterizedTest
    @ValueSource(strings = {"a\nb", "a\u001b[31mb", "a\u202Eb", "a\u0085b", "half \uD83D", "no \uFFFE"})
    void namesThatNoFileHoldsAreRefusedByTheSceneItself(String name) {
        assertThatIllegalArgumentException().isThrownBy(() -> PLAIN.plus(SceneObject.of(new Sphere(1)).named(name)));
        assertThatIllegalArgumentException().isThrownBy(() -> PLAIN.plus(SceneObject.of(Csg.union(Operand.of(new Sphere(1)).named(name)))));
        assertThatIllegalArgumentException().isThrownBy(() -> PLAIN.plus(Light.at(1, 2, 3).named(name)));
        assertThatIllegalArgumentException().isThrownBy(() -> PLAIN.plus(name, Material.DEFAULT));
        assertThatIllegalArgumentException().isThrownBy(() -> PLAIN.plus(" ", Material.DEFAULT));
    }

    @Test
    void aFileThatCannotBeWrittenIsLeftAsItWas(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("a.xml"), "old");
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.write(PLAIN.withName("\u0007"), file));
        assertThat(file).hasContent("old");
        assertThatThrownBy(() -> SceneFiles.write(PLAIN, folder.resolve("none/a.xml"))).isInstanceOf(IOException.class)
                .hasMessage(folder.resolve("none/a.xml") + ": cannot be written, there is no such folder");
        assertThat(folder.toFile().list()).containsExactly("a.xml");
    }

    @Test
    void aDatabaseMayBeEmptyAndASceneIsADatabaseOfOne(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("d.xml");
        SceneFiles.writeAll(List.of(), file);
        assertThat(SceneFiles.readAll(file)).isEmpty();
        assertThatThrownBy(() -> SceneFiles.read(file)).isInstanceOf(SceneFileException.class)
                .hasMessage(file + ":1:1: this is a database of 0 scenes, but one scene was expected");
        SceneFiles.write(PLAIN, file);
        assertThat(SceneFiles.readAll(file)).containsExactly(PLAIN);
        Scene named = PLAIN.withName("plain");
        SceneFiles.writeAll(List.of(named), file);
        assertThat(SceneFiles.read(file)).isEqualTo(named);
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.writeAll(List.of(PLAIN), file)).withMessageContaining("needs a name");
        assertThatIllegalArgumentException().isThrownBy(() -> SceneFiles.writeAll(List.of(named, named), file)).withMessageContaining("already");
    }

    /** The schema is a manual, too. */
    @Test
    void everyTypeAndAttributeOfTheSchemaIsExplained() throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setNamespaceAware(true);
        Element schema = factory.newDocumentBuilder().parse(new InputSource(new StringReader(SceneFiles.schema()))).getDocumentElement();
        for (String kind : List.of("attribute", "simpleType", "complexType")) {
            NodeList found = schema.getElementsByTagNameNS(XS, kind);
            for (int i = 0; i < found.getLength(); i++) {
                Element element = (Element) found.item(i);
                if (element.hasAttribute("name")) {
                    assertThat(element.getElementsByTagNameNS(XS, "documentation").getLength())
                            .as("explanation of %s %s", kind, element.getAttribute("name")).isPositive();
                }
            }
        }
    }
}
