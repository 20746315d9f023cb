package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.text.FileText;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Open, change, save: what the file looks like then. */
class SceneFileTest {
    @Test
    void aFileThatHasBecomeADirectoryIsToldByName(@TempDir Path folder) throws Exception {
        Path path = folder.resolve("a.xml");
        SceneFile file = SceneFile.create(path, Scene.EMPTY);
        Files.delete(path);
        Files.createDirectory(path);
        assertThatThrownBy(() -> file.save(Scene.EMPTY.withName("b"))).hasMessage(path + ": this is a directory, not a file");
    }

    private static final String EXAM = """
            <?xml version="1.0" encoding="UTF-8"?>
            <!-- exam 3, do not change the light! -->
            <scene xmlns="urn:paprsek:scene:1">
              <render width="160" height="120"/>
              <camera position="0 0 5" direction="0 0 -1"/>
              <!-- TODO ask about the key light -->
              <point-light position="1 2 3"/>
              <sphere radius="1"/> <!-- radius in cm -->
            </scene>
            """;

    @TempDir
    Path folder;

    private String changed(String text, UnaryOperator<Scene> change) throws Exception {
        Path file = Files.writeString(folder.resolve("a.xml"), text);
        SceneFile opened = SceneFiles.open(file);
        Scene wanted = change.apply(opened.scene());
        SceneFile saved = opened.save(wanted);
        assertThat(SceneFiles.open(file).scene()).isEqualTo(wanted).isEqualTo(saved.scene());
        String result = Files.readString(file);
        saved.save(opened.scene());
        assertThat(file).as("changed back").hasContent(text);
        return result;
    }

    private static UnaryOperator<Scene> first(UnaryOperator<SceneObject> change) {
        return scene -> scene.withObjects(List.of(change.apply(scene.objects().get(0))));
    }

    @Test
    void aBallThatIsMovedIsMovedInItsLine() throws Exception {
        assertThat(changed(EXAM, first(ball -> ball.at(0, 1, 0)))).isEqualTo(EXAM.replace("<sphere radius=\"1\"/>", "<sphere radius=\"1\" position=\"0 1 0\"/>"));
        assertThat(changed(EXAM, first(ball -> ball.withShape(new Sphere(0.5))))).isEqualTo(EXAM.replace("radius=\"1\"", "radius=\"0.5\""));
        assertThat(changed(EXAM, first(ball -> ball.named("it's <it>").madeOf(Material.color(1, 2, 3))))).isEqualTo(EXAM.replace("<sphere radius=\"1\"/>",
                "<sphere name=\"it's &lt;it&gt;\" radius=\"1\">\n    <material color=\"1 2 3\"/>\n  </sphere>"));
    }

    @Test
    void colorsKeepTheirWordsUntilTheyAreOthers() throws Exception {
        String text = EXAM.replace("<sphere radius=\"1\"/>", "<sphere radius=\"1\"><material color=\"Tomato\" diffusion=\".50\"/></sphere>")
                .replace("position=\"1 2 3\"", "position=\"1 2 3\" color=\"#FFF\"");
        assertThat(changed(text, first(ball -> ball.withShape(new Sphere(2))))).isEqualTo(text.replace("radius=\"1\"", "radius=\"2\""));
        assertThat(changed(text, first(ball -> ball.madeOf(Material.color(255, 99, 71).withDiffusion(0.25))))).isEqualTo(text.replace("\".50\"", "\"0.25\""));
        assertThat(changed(text, first(ball -> ball.madeOf(Material.color(1, 2, 3).withDiffusion(0.5))))).isEqualTo(text.replace("Tomato", "1 2 3"));
    }

    /** The examples that engineers share, as they are found in the wild: a mark, UTF-16, prefixes, CDATA. */
    @ParameterizedTest
    @ValueSource(strings = {"\uFEFF%s", "\uFEFF<?xml version='1.0' encoding='UTF-16'?>\n%s", "<?xml version='1.1'?><?p i?>\n%s"})
    void whateverIsOpenedIsSavedAsItWas(String frame) throws Exception {
        String text = String.format(frame, EXAM.substring(EXAM.indexOf("<scene")).replace("<render", "<description><![CDATA[a < b]]></description>\n  <render"));
        Charset charset = frame.contains("UTF-16") ? StandardCharsets.UTF_16LE : StandardCharsets.UTF_8;
        Path file = Files.write(folder.resolve("w.xml"), text.getBytes(charset));
        SceneFile opened = SceneFiles.open(file);
        opened.save(opened.scene().withObjects(List.of(opened.scene().objects().get(0).at(1, 2, 3))));
        assertThat(new String(Files.readAllBytes(file), charset)).isEqualTo(text.replace("radius=\"1\"", "radius=\"1\" position=\"1 2 3\""));
    }

    @Test
    void whatIsNewComesBehindWhatItIsLike() throws Exception {
        assertThat(changed(EXAM, scene -> scene.plus(SceneObject.of(new Sphere(2)), SceneObject.of(Csg.union(Operand.of(new Sphere(3))))))).isEqualTo(
                EXAM.replace("</scene>", "  <sphere radius=\"2\"/>\n  <union>\n    <sphere radius=\"3\"/>\n  </union>\n</scene>"));
        assertThat(changed(EXAM, scene -> scene.withBackground(Rgb.grey(9)).withName("exam").plus(Light.at(0, 0, 0)).plus("gold", Material.DEFAULT))).isEqualTo(
                EXAM.replace(":1\">", ":1\" name=\"exam\">").replace("120\"/>", "120\"/>\n  <background color=\"9 9 9\"/>")
                        .replace("1 2 3\"/>", "1 2 3\"/>\n  <point-light position=\"0 0 0\"/>\n  <material name=\"gold\"/>"));
        assertThat(changed(EXAM, scene -> scene.withLights(List.of(Light.at(0, 0, 0), scene.lights().get(0))))).as("above what belongs to the other one").isEqualTo(
                EXAM.replace("  <!-- TODO", "  <point-light position=\"0 0 0\"/>\n  <!-- TODO"));
    }

    @Test
    void whatIsRemovedGoesWithItsLine() throws Exception {
        assertThat(changed(EXAM, scene -> scene.withObjects(List.of()))).isEqualTo(EXAM.replace("  <sphere radius=\"1\"/> <!-- radius in cm -->\n", ""));
        assertThat(changed(EXAM, scene -> scene.withLights(List.of()).withSettings(RenderSettings.DEFAULT))).isEqualTo(
                EXAM.replace("  <point-light position=\"1 2 3\"/>\n", "").replace("  <render width=\"160\" height=\"120\"/>\n", ""));
    }

    @Test
    void whatIsMovedTakesItsCommentsAlong() throws Exception {
        String text = EXAM.replace("  <!-- TODO", "  <sphere radius='3.0'/> <!-- big -->\n\n  <!-- the\n  small one -->\n  <block max='1  1 1' min='0 0 0'/>\n  <!-- TODO");
        String expected = EXAM.replace("  <!-- TODO", "\n  <!-- the\n  small one -->\n  <block max='1  1 1' min='0 0 0'/>\n  <!-- TODO")
                .replace("in cm -->\n", "in cm -->\n  <sphere radius='3.0'/> <!-- big -->\n");
        assertThat(changed(text, scene -> scene.withObjects(List.of(scene.objects().get(1), scene.objects().get(2), scene.objects().get(0))))).isEqualTo(expected);
        assertThat(changed(text, scene -> scene.withObjects(List.of(scene.objects().get(0), SceneObject.of(Csg.union(
                Operand.of(new Block(Vec3.ZERO, Vec3.ONE)), Operand.of(new Sphere(1))))))))
                .as("into a group").contains("<union>\n    <!-- the\n  small one -->\n  <block max='1  1 1' min='0 0 0'/>\n    <sphere radius=\"1\"/> <!-- radius in cm -->\n  </union>\n");
    }

    @Test
    void anElementKeepsItsOrderQuotesAndWhiteSpace() throws Exception {
        String text = EXAM.replace("<sphere radius=\"1\"/>", "<difference\n      position = '0 0  0'\n      name='cut' ><!-- a --><sphere radius='1.0' /><?pi x?><sphere position='1 0 0' radius='.5'/></difference >");
        assertThat(changed(text, first(cut -> cut.at(1, 2, 3).named("it's").withShape(new Csg(Csg.Operation.INTERSECTION, ((Csg) cut.shape()).operands()))))).isEqualTo(
                text.replace("'0 0  0'", "'1 2 3'").replace("'cut'", "'it&apos;s'").replace("difference", "intersection"));
        assertThat(changed(text, first(cut -> cut.named("").rotated(0, 5, 0)))).isEqualTo(
                text.replace("\n      name='cut'", "").replace("position = ", "rotation=\"0 5 0\"\n      position = "));
        assertThat(changed(text, first(cut -> cut.withShape(new Csg(Csg.Operation.DIFFERENCE, ((Csg) cut.shape()).operands().subList(0, 1))))))
                .isEqualTo(text.replace("<sphere position='1 0 0' radius='.5'/>", ""));
    }

    @Test
    void aPatternTakesThePlaceOfAColour() throws Exception {
        String text = EXAM.replace("<sphere radius=\"1\"/>", "<sphere radius=\"1\"><material color='1 2 3' diffusion='0.80'/></sphere>");
        Pattern checker = new Pattern.Checker(2, Vec3.ZERO, Rgb.WHITE, Rgb.BLACK);
        assertThat(changed(text, first(ball -> ball.madeOf(Material.DEFAULT.withPattern(checker))))).isEqualTo(
                text.replace("<material color='1 2 3' diffusion='0.80'/>", "<material diffusion='0.80'><checker size=\"2\"/></material>"));
    }

    @Test
    void aDescriptionStaysThePlainTextThatItIs() throws Exception {
        String text = EXAM.replace("  <render", "  <description><![CDATA[a < b & c]]></description>\n  <render");
        assertThat(changed(text, scene -> scene.withDescription("a > b & \"c\""))).isEqualTo(text.replace("a < b & c", "a > b & \"c\""));
        assertThat(changed(text, scene -> scene.withDescription("]]>"))).isEqualTo(text.replace("<![CDATA[a < b & c]]>", "]]&gt;"));
        assertThat(changed(text, scene -> scene.withDescription(""))).isEqualTo(EXAM);
        String empty = EXAM.replace("  <render", "  <description/>\n  <render");
        assertThat(changed(empty, scene -> scene.withDescription("x"))).isEqualTo(empty.replace("<description/>", "<description>x</description>"));
    }

    @Test
    void whatSaysNothingStaysUntilItSaysSomething() throws Exception {
        String text = EXAM.replace("  <render width=\"160\" height=\"120\"/>", "  <render/><ambient color='0 0 0' />");
        assertThat(changed(text, first(ball -> ball.at(1, 0, 0)))).contains("  <render/><ambient color='0 0 0' />\n");
        assertThat(changed(text, scene -> scene.withAmbient(Rgb.grey(5)).withSettings(new RenderSettings(800, 600, 5, 2))))
                .contains("  <render samples=\"2\"/><ambient color='5 5 5' />\n");
    }

    @Test
    void prefixesAndLineEndsAreThoseOfTheFile() throws Exception {
        String text = EXAM.replace("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n", "").replaceAll("<(/?)(?=[a-z])", "<$1p:").replace("xmlns=", "xmlns:p=")
                .replace("\n", "\r\n") + " <!-- the end -->\r\n\r\n";
        assertThat(changed(text, scene -> scene.withDescription("two\nlines").plus(SceneObject.of(Csg.union(Operand.of(new Sphere(3)))))))
                .isEqualTo(text.replace("  <p:render", "  <p:description>two\r\nlines</p:description>\r\n  <p:render")
                        .replace("</p:scene>", "  <p:union>\r\n    <p:sphere radius=\"3\"/>\r\n  </p:union>\r\n</p:scene>"));
    }

    @ParameterizedTest
    @CsvSource({"UTF-16LE,UTF-16,true", "UTF-16BE,UTF-16,true", "UTF-8,UTF-8,true", "windows-1250,windows-1250,false", "ISO-8859-2,ISO-8859-2,false",
        "US-ASCII,US-ASCII,false"})
    void theEncodingStays(String charset, String declared, boolean hasMark) throws Exception {
        String text = (hasMark ? "\uFEFF" : "") + EXAM.replace("UTF-8", declared).replace("exam", charset.startsWith("US") ? "exam" : "zkouška");
        Path file = Files.write(folder.resolve("a.xml"), text.getBytes(Charset.forName(charset)));
        SceneFile opened = SceneFiles.open(file);
        Scene wanted = opened.scene().withName("koule č. 1 光");
        opened.save(wanted);
        assertThat(SceneFiles.open(file).scene()).isEqualTo(wanted);
        String name = charset.startsWith("UTF") ? "koule č. 1 光" : charset.startsWith("US") ? "koule &#269;. 1 &#20809;" : "koule č. 1 &#20809;";
        assertThat(new String(Files.readAllBytes(file), Charset.forName(charset))).isEqualTo(text.replace(":1\">", ":1\" name=\"" + name + "\">"));
    }

    @Test
    void aSceneInALineStaysThere() throws Exception {
        String text = "<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 5' direction='0 0 -1'/><sphere radius='1'/></scene>";
        assertThat(changed(text, scene -> scene.plus(SceneObject.of(new Sphere(2))).plus(Light.at(0, 0, 0)))).isEqualTo(
                text.replace("'0 0 -1'/>", "'0 0 -1'/><point-light position=\"0 0 0\"/>").replace("</scene>", "<sphere radius=\"2\"/></scene>"));
        assertThat(changed(text, scene -> scene.withObjects(List.of()))).isEqualTo(text.replace("<sphere radius='1'/>", ""));
    }

    @Test
    void theOnlySceneOfADatabaseStaysInIt() throws Exception {
        String text = "<database xmlns=\"urn:paprsek:scene:1\">\n<!-- a -->\n" + EXAM.substring(EXAM.indexOf("<scene")).replace("<scene xmlns=\"urn:paprsek:scene:1\"", "<scene name='x'")
                + "</database>";
        assertThat(changed(text, scene -> scene.withName("y"))).isEqualTo(text.replace("'x'", "'y'"));
    }

    @Test
    void whatOthersWroteMeanwhileIsKept() throws Exception {
        Path file = Files.writeString(folder.resolve("a.xml"), EXAM);
        SceneFile mine = SceneFiles.open(file);
        Files.writeString(file, EXAM.replace("exam 3", "exam 4"));
        SceneFile saved = mine.save(mine.scene().withName("n"));
        assertThat(file).hasContent(EXAM.replace("exam 3", "exam 4").replace(":1\">", ":1\" name=\"n\">"));
        Files.writeString(file, EXAM.replace("160", "161"));
        assertThatThrownBy(() -> saved.save(mine.scene())).isInstanceOf(DatabaseConflictException.class)
                .hasMessage(file + ": somebody else has changed this file since it was read; nothing is written");
        assertThat(file).hasContent(EXAM.replace("160", "161"));
        Files.writeString(file, "broken");
        assertThatThrownBy(() -> saved.save(mine.scene())).isInstanceOf(SceneFileException.class);
        Files.delete(file);
        saved.save(mine.scene());
        assertThat(file).as("with what they wrote").hasContent(EXAM.replace("exam 3", "exam 4"));
        assertThat(folder.toFile().list()).containsExactly("a.xml");
    }

    @Test
    void aCopyElsewhereHasTheCommentsToo() throws Exception {
        SceneFile opened = SceneFiles.open(Files.writeString(folder.resolve("a.xml"), EXAM));
        Path copy = folder.resolve("b.xml");
        opened.saveAs(opened.scene().withName("copy"), copy).save(opened.scene().withName("second"));
        assertThat(copy).hasContent(EXAM.replace(":1\">", ":1\" name=\"second\">"));
        assertThat(opened.path()).hasContent(EXAM);
        SceneFile fresh = SceneFile.create(folder.resolve("c.xml"), opened.scene());
        assertThat(fresh.path()).hasContent(SceneFiles.format(opened.scene()));
    }

    /** What would be written if changing a text piece by piece had gone wrong. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void wholeElementsCanBeWrittenAnew(int depth) throws Exception {
        for (int seed = 0; seed < 20; seed++) {
            byte[] before = RandomLayout.of(SceneFiles.format(RandomScenes.of(seed)), seed).getBytes(StandardCharsets.UTF_8);
            OriginalText text = OriginalText.read(Files.write(folder.resolve("a.xml"), before), ReadMonitor.NONE);
            Scene wanted = new RandomEdits(seed).any(text.contents().scenes().get(0));
            assertThat(text.patched(new FileText(before), List.of(wanted), depth)).as("seed %d", seed).isPresent();
        }
    }
}
