package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import javax.xml.XMLConstants;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.SchemaFactory;
import javax.xml.validation.Validator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.xml.sax.SAXException;

/** Scenes with parameters, formulas, repetition, definitions and included files: what they are when written out, and what is saved. */
@Timeout(60)
class RecipeTest {
    private static final String CAMERA = "<camera position=\"0 0 9\" target=\"0 0 0\"/>";

    @TempDir
    private Path folder;

    private static String scene(String inside) {
        return "<scene xmlns=\"urn:paprsek:scene:1\">" + CAMERA + full(inside) + "</scene>";
    }

    /** With what must be said of bodies and does not matter here. */
    private static String full(String inside) {
        return inside.replaceAll("<(sphere|disc|cylinder)(?![^>]* radius)", "<$1 radius='1'").replaceAll("<cylinder(?![^>]* height)", "<cylinder height='1'")
                .replaceAll("<block(?![^>]* max)", "<block max='1 1 1'").replaceAll("<block(?![^>]* min)", "<block min='0 0 0'");
    }

    private static Scene made(String inside) throws SceneFileException {
        return SceneFiles.parse(scene(inside)).withRecipe(Recipe.NONE);
    }

    private static void sameAs(String short_, String long_) throws SceneFileException {
        Scene made = made(short_);
        assertThat(SceneFiles.format(made)).isEqualTo(SceneFiles.format(made(long_)));
        assertThat(made).isEqualTo(made(long_));
    }

    @Test
    void formulasStandWhereNumbersOrColoursStand() throws SceneFileException {
        sameAs("<param name='h' value='2'/><param name='wood' value='saddlebrown'/><param name='a' value='{h/4}'/><render samples='{h}..{h*2}'/>"
                + "<material name='m' color='{wood}' specular='{a}'/>"
                + "<sphere name='{h}' radius='{a}' position='0 {h/2} {h &lt; 3 ? -1 : 1}' material='m'/><block min='-1 -1 -1' max='{h} {h} {h}'/>",
                "<render samples='2..4'/><material name='m' color='saddlebrown' specular='0.5'/>"
                + "<sphere name='{h}' radius='0.5' position='0 1 -1' material='m'/><block min='-1 -1 -1' max='2 2 2'/>");
    }

    @Test
    void whatIsRepeatedIsTheSameWrittenOut() throws SceneFileException {
        sameAs("<repeat count='3' position='2 0 0'><sphere name='ball' radius='{0.5 + i/4}' position='0 1 0'/></repeat>",
                "<sphere name='ball[0]' radius='0.5' position='0 1 0'/><sphere name='ball[1]' radius='0.75' position='2 1 0'/><sphere name='ball[2]' position='4 1 0'/>");
        sameAs("<union name='gear'><cylinder/><repeat name='tooth' count='4' rotation='0 90 0'><block max='1.2 1 0.1'/></repeat></union>",
                "<union name='gear'><cylinder/><union name='tooth'><block name='tooth[0]' max='1.2 1 0.1'/><block name='tooth[1]' max='1.2 1 0.1' rotation='0 90 0'/>"
                + "<block name='tooth[2]' max='1.2 1 0.1' rotation='0 180 0'/><block name='tooth[3]' max='1.2 1 0.1' rotation='0 270 0'/></union></union>");
        sameAs("<repeat count='2' position='0 1 0' rotation='0 30 0'><sphere/><disc/></repeat>",
                "<sphere/><disc/><sphere position='0 1 0' rotation='0 30 0'/><disc position='0 1 0' rotation='0 30 0'/>");
        sameAs("<repeat count='2' position='0 0 5'><repeat count='2' position='3 0 0' index='j'><sphere name='s' radius='{1 + i + j*2}'/></repeat></repeat>",
                "<sphere name='s[0][0]'/><sphere name='s[0][1]' radius='3' position='3 0 0'/><sphere name='s[1][0]' radius='2' position='0 0 5'/>"
                + "<sphere name='s[1][1]' radius='4' position='3 0 5'/>");
        sameAs("<repeat count='3' scale='2' position='1 0 0'><sphere/></repeat>", "<sphere/><sphere position='1 0 0' scale='2'/><sphere position='3 0 0' scale='4'/>");
        sameAs("<repeat count='0'><sphere/></repeat>", "");
    }

    @Test
    void definitionsAreUsedWhereverBodiesStand() throws SceneFileException {
        sameAs("<define name='leg'><cylinder radius='0.1' position='0 0 1'/></define><instance of='leg' name='a' position='1 0 0'/>"
                + "<union><instance of='leg' material='red'/><sphere/></union><material name='red' color='red'/>",
                "<material name='red' color='red'/><cylinder name='a' radius='0.1' position='1 0 1'/>"
                + "<union><cylinder radius='0.1' position='0 0 1' material='red'/><sphere/></union>");
        sameAs("<define name='pair'><union><instance of='one'/><instance of='one' position='2 0 0'/></union></define><define name='one'><sphere radius='{r}'/></define>"
                + "<param name='r' value='0.25'/><instance of='pair' rotation='0 90 0'/><repeat count='2' position='0 3 0'><instance of='pair'/></repeat>",
                "<union rotation='0 90 0'><sphere radius='0.25'/><sphere radius='0.25' position='2 0 0'/></union>"
                + "<union name='pair[0]'><sphere radius='0.25'/><sphere radius='0.25' position='2 0 0'/></union>"
                + "<union name='pair[1]' position='0 3 0'><sphere radius='0.25'/><sphere radius='0.25' position='2 0 0'/></union>");
        // What is turned within what is drawn out becomes skew: one operation more.
        sameAs("<define name='b'><block rotation='0 45 0'/></define><instance of='b' scale='2 1 1'/>", "<union scale='2 1 1'><block rotation='0 45 0'/></union>");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "<sphere radius='{1+}'/> | 2:20 | must stand here, but the formula ends",
        "<sphere radius='{r}'/> | 2:18 | \"r\" is not a number",
        "<sphere position='0 {1/0} 0'/> | 2:23 | \"1 / 0\" has no finite value",
        "<sphere position='0 {0 &lt; 1 ? q : 2} 0'/> | 2:33 | \"q\" is not a number",
        "<sphere radius='{2'/> | 2:17 | has no \"}\"",
        "<sphere radius='{0-1}'/> | 2:9 | radius must be a finite number above 0, but is \"-1\"",
        "<param name='a' value='{b}'/><param name='b' value='{a}'/> | 2:54 | needs itself",
        "<param name='a' value='3' min='6' max='2'/> | 2:35 | max must be at least min, which is 6, but is 2",
        "<param name='a' value='7' max='5'/> | 2:17 | must be a number, 5 at most, but is 7",
        "<param name='a'/> | 2:1 | needs the attribute \"value\"",
        "<param name='sin' value='1'/> | 2:8 | needs a name",
        "<param name='a' value='1'/><param name='a' value='1'/> | 2:35 | already",
        "<param name='a' value='2*b'/><sphere radius='{a}'/> | 2:47 | in braces, {2*b}",
        "<repeat cuont='3'><sphere/></repeat> | 2:9 | did you mean \"count\"?",
        "<repeat count='2.5'><sphere/></repeat> | 2:9 | whole number",
        "<repeat count='3d'><sphere/></repeat> | 2:9 | whole number",
        "<repeat count='2' position='0x1p1 0 0'><sphere/></repeat> | 2:19 | three finite numbers",
        "<repeat count='{i}'><sphere/></repeat> | 2:17 | not a number",
        "<repeat count='3'><camera position='{i} 0 1' target='0 0 0'/></repeat> | 2:19 | <camera> is none",
        "<repeat count='3'/> | 2:1 | needs a body",
        "<repeat count='4'><sphere radius='{2-i}'/></repeat> | 2:27 | radius must be a finite number above 0, but is \"0\"",
        "<repeat count='3'><sphere radius='1'><sphere radius='1'/></sphere></repeat> | 2:38 | ",
        "<instance of='tre'/><define name='tree'><sphere/></define> | 2:11 | did you mean \"tree\"?",
        "<define name='a'><union><instance of='a'/></union></define><instance of='a'/> | 2:35 | needs itself: a > a",
        "<define name='a'><sphere/><sphere/></define> | 2:1 | has 2",
        "<union><param name='a' value='1'/><sphere/></union> | 2:8 | directly in a scene",
        "<include file='../x.xml'/> | 2:10 | "})
    void mistakesAreToldWithLineAndColumn(String inside, String place, String message) throws Exception {
        Path file = Files.writeString(folder.resolve("bad.xml"), "<scene xmlns=\"urn:paprsek:scene:1\">" + CAMERA + "\n" + inside + "</scene>");
        assertThatThrownBy(() -> SceneFiles.read(file)).isInstanceOfSatisfying(SceneFileException.class, wrong -> {
            assertThat(wrong.problems()).hasSize(1);
            assertThat(wrong.problems().get(0).toString()).startsWith(file + ":" + place + ": ").contains(message == null ? "" : message);
        });
    }

    /** A few lines that ask for more than there is room for: refused before any of it is made. */
    @Test
    void bombsGetOneLine() {
        String nested = "<repeat count='1000'>".repeat(5) + "<sphere/>" + "</repeat>".repeat(5);
        StringBuilder laughs = new StringBuilder("<define name='d0'><union><sphere/></union></define>");
        for (int i = 1; i < 40; i++) {
            laughs.append("<define name='d" + i + "'><union>" + ("<instance of='d" + (i - 1) + "'/>").repeat(10) + "</union></define>");
        }
        StringBuilder deep = new StringBuilder("<define name='d0'><union><sphere/></union></define>");
        for (int i = 1; i < 2000; i++) {
            deep.append("<define name='d" + i + "'><union><instance of='d" + (i - 1) + "'/></union></define>");
        }
        StringBuilder texts = new StringBuilder("<param name='p0' value='ab'/>");
        for (int i = 1; i < 40; i++) {
            texts.append("<param name='p" + i + "' value='{p" + (i - 1) + "}{p" + (i - 1) + "}'/>");
        }
        String rows = "<param name='n' value='2000'/><define name='row'><union><repeat count='{n}'><sphere/></repeat></union></define>"
                + "<difference><block/><repeat count='{2*n}'><instance of='row'/></repeat></difference>";
        for (String bomb : List.of(nested, laughs + "<instance of='d39'/>", rows, deep + "<instance of='d1999'/>", "<sphere radius='{" + "(".repeat(5000) + "'/>",
                texts + "<text value='{p39}'/>")) {
            assertTimeoutPreemptively(Duration.ofSeconds(2), () -> assertThatThrownBy(() -> SceneFiles.parse(scene(bomb)))
                    .isInstanceOfSatisfying(SceneFileException.class, wrong -> assertThat(wrong.problems()).hasSize(1)));
        }
    }

    @Test
    void whereThereIsNoParameterNoneIsGivenAnotherValue() throws Exception {
        assertThatThrownBy(() -> SceneFiles.with(Scene.EMPTY, Map.of("n", "4"))).isInstanceOf(SceneFileException.class).hasMessageContaining("there is no parameter \"n\" here, nor any other");
        assertThat(SceneFiles.with(Scene.EMPTY, Map.of())).isSameAs(Scene.EMPTY);
    }

    @Test
    void parametersMayBeGivenOtherValues() throws Exception {
        Path file = Files.writeString(folder.resolve("gear.xml"), scene("<param name='n' value='3' min='2' max='9' step='1'/><repeat count='{n}' position='1 0 0'><sphere/></repeat>"));
        Scene read = SceneFiles.read(file);
        assertThat(read.objects()).hasSize(3);
        assertThat(read.recipe().parameters()).hasSize(1).first().hasToString("Parameter[name=n, formula=3, value=3, least=OptionalDouble[2.0], most=OptionalDouble[9.0], step=OptionalDouble[1.0]]");
        assertThat(SceneFiles.read(file, Map.of("n", "{2*3}")).objects()).hasSize(6);
        Scene more = SceneFiles.with(read, Map.of("n", "5"));
        assertThat(more.objects()).hasSize(5);
        assertThat(more).isEqualTo(SceneFiles.parse(SceneFiles.format(more))).isEqualTo(SceneFiles.read(file, Map.of("n", "5")));
        assertThat(SceneFiles.format(more)).contains("<param name=\"n\" value=\"5\" min=\"2\" max=\"9\" step=\"1\"/>", "{n}");
        assertThatThrownBy(() -> SceneFiles.read(file, Map.of("n", "12"))).hasMessageContaining("from 2 to 9, but is 12");
        assertThatThrownBy(() -> SceneFiles.read(file, Map.of("m", "1"))).hasMessageContaining("there is no parameter \"m\"");
    }

    @Test
    void savedFilesKeepFormulasAndAllElse() throws Exception {
        String text = scene("<!-- a gear -->\n  <param name='n' value='3'/>\n <sphere name='hub' radius='{n/6}' position='{n} 0 0' />\n"
                + "  <union name='gear'><cylinder/><repeat count='{n}' rotation='0 {360/n} 0'><block/></repeat></union> <!-- end -->\n<sphere name='last' radius='2'/>");
        Path file = Files.writeString(folder.resolve("gear.xml"), text);
        SceneFile opened = SceneFiles.open(file);
        opened.save(opened.scene());
        assertThat(file).hasContent(text);
        Scene moved = opened.scene().with(ScenePath.body(0), body -> body.placed(Placement.at(7, 0, 0)));
        SceneFile saved = opened.save(moved);
        assertThat(file).hasContent(text.replace("position='{n} 0 0'", "position='7 0 0'"));
        assertThat(SceneFiles.read(file).withRecipe(Recipe.NONE)).isEqualTo(moved.withRecipe(Recipe.NONE));
        saved = saved.save(SceneFiles.with(saved.scene(), Map.of("n", "4")));
        assertThat(file).hasContent(text.replace("position='{n} 0 0'", "position='7 0 0'").replace("value='3'", "value='4'"));
        Scene more = saved.scene().plus(SceneObject.of(new Sphere(3)).named("new"));
        saved.save(more.with(ScenePath.body(1, 0), body -> body.placed(Placement.at(0, 1, 0))));
        assertThat(Files.readString(file)).contains("<cylinder height='1' radius='1' position=\"0 1 0\"/>", "count='{n}' rotation='0 {360/n} 0'", "<!-- a gear -->", "<!-- end -->", "name=\"new\"", "value='4'");
    }

    @Test
    void aCopyThatIsTouchedIsWrittenDown() throws Exception {
        Path file = Files.writeString(folder.resolve("row.xml"), scene("<param name='n' value='3'/><repeat count='{n}' position='1 0 0'><sphere name='s'/></repeat><disc radius='{n}'/>"));
        SceneFile opened = SceneFiles.open(file);
        Scene moved = opened.scene().with(ScenePath.body(1), body -> body.placed(Placement.at(1, 5, 0)));
        opened.save(moved);
        assertThat(Files.readString(file)).contains("<disc radius='{n}'/>", "name=\"s[1]\"").doesNotContain("<repeat");
        assertThat(SceneFiles.read(file).withRecipe(Recipe.NONE)).isEqualTo(moved.withRecipe(Recipe.NONE));
    }

    @Test
    void instancesThatAreMovedStayInstances() throws Exception {
        Path file = Files.writeString(folder.resolve("two.xml"), scene("<define name='t'><union><sphere/></union></define><instance of='t'/><instance of='t' position='3 0 0'/>"));
        SceneFile opened = SceneFiles.open(file);
        opened.save(opened.scene().with(ScenePath.body(1), body -> body.placed(Placement.at(4, 0, 0))));
        assertThat(Files.readString(file)).contains("<instance of='t'/><instance of='t' position='4 0 0'/>");
    }

    @Test
    void whatIsWrittenIsReadAgainAndAlwaysTheSame() throws SceneFileException {
        Scene scene = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1' name='a &amp; b'><description>one\ntwo {x}</description>" + CAMERA
                + "<param name='n' value='{1 &lt; 2 ? 3 : 4}'/><material name='m'><checker size='{n}'/></material><sphere radius='{n}' material='m'/></scene>");
        String text = SceneFiles.format(scene);
        assertThat(SceneFiles.parse(text)).isEqualTo(scene);
        assertThat(SceneFiles.format(SceneFiles.parse(text))).isEqualTo(text);
        String database = SceneFiles.formatAll(List.of(scene, scene.withName("plain").withRecipe(Recipe.NONE), scene.withName("c")));
        assertThat(SceneFiles.formatAll(read(database))).isEqualTo(database);
        assertThat(read(database)).hasSize(3).first().isEqualTo(scene);
        assertThat(database).contains("name=\"c\"").containsOnlyOnce("radius=\"3\"");
    }

    private static List<Scene> read(String database) throws SceneFileException {
        try {
            return SceneFiles.contents(new ByteArrayInputStream(database.getBytes(StandardCharsets.UTF_8)), "text").scenes();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void definitionsOfOtherFilesAreIncludedAndNothingElse() throws Exception {
        Files.createDirectories(folder.resolve("parts"));
        Files.writeString(folder.resolve("parts/tree.xml"), scene("<param name='h' value='2'/><material name='green' color='green'/>"
                + "<include file='leaf.xml'/><define name='tree'><union material='green'><cylinder height='{h}'/><instance of='leaf' position='0 {h} 0'/></union></define><sphere radius='9'/>"));
        Files.writeString(folder.resolve("parts/leaf.xml"), scene("<define name='leaf'><sphere/></define>"));
        Path file = Files.writeString(folder.resolve("forest.xml"), scene("<include file='parts/tree.xml'/><instance of='tree'/>"));
        Scene read = SceneFiles.read(file);
        assertThat(read.withRecipe(Recipe.NONE)).isEqualTo(made("<material name='green' color='green'/><union material='green'><cylinder height='2'/><sphere position='0 2 0'/></union>"));
        assertThat(read.recipe().parameters()).extracting(Recipe.Parameter::name).containsExactly("h");
        Scene higher = SceneFiles.with(read, Map.of("h", "3"));
        assertThat(higher).isEqualTo(SceneFiles.read(file, Map.of("h", "3")));
        assertThat(SceneFiles.format(higher)).contains("<param name=\"h\" value=\"3\"/>", "<include file=\"parts/tree.xml\"/>").doesNotContain("<cylinder");
        SceneFile opened = SceneFiles.open(file);
        opened.save(higher);
        assertThat(SceneFiles.read(file).withRecipe(Recipe.NONE)).isEqualTo(higher.withRecipe(Recipe.NONE));
    }

    @Test
    void includesThatCannotBeAreToldInOneLine() throws Exception {
        Files.writeString(folder.resolve("a.xml"), scene("<include file='b.xml'/>"));
        Files.writeString(folder.resolve("b.xml"), scene("<include file='a.xml'/>"));
        Files.writeString(folder.resolve("broken.xml"), "<scene");
        Files.writeString(folder.resolve("wrong.xml"), scene("\n<define name='x'><sphere radius='{1+}'/></define>"));
        Path outside = Files.writeString(Files.createDirectories(folder.resolve("in")).resolveSibling("out.xml"), scene(""));
        Files.createSymbolicLink(folder.resolve("in/link.xml"), outside);
        for (String name : List.of("a.xml", "broken.xml", "nothing.xml", "/etc/passwd", "wrong.xml")) {
            Path file = Files.writeString(folder.resolve("main.xml"), scene("<include file='" + name + "'/>"));
            assertThatThrownBy(() -> SceneFiles.read(file)).isInstanceOfSatisfying(SceneFileException.class, wrong -> assertThat(wrong.problems()).hasSize(1));
        }
        Path main = Files.writeString(folder.resolve("in/main.xml"), scene("<include file='link.xml'/>"));
        assertThatThrownBy(() -> SceneFiles.read(main)).isInstanceOf(SceneFileException.class);
        assertThatThrownBy(() -> SceneFiles.parse(scene("<include file='a.xml'/>"))).hasMessageContaining("no files beside this scene");
        Path wrong = Files.writeString(folder.resolve("main.xml"), scene("<include file='wrong.xml'/>"));
        assertThatThrownBy(() -> SceneFiles.read(wrong)).hasMessageContaining("wrong.xml:2:");
    }

    @Test
    void aPlainFileWithBracesInItsTextsIsReadAsEver() throws SceneFileException {
        Scene scene = SceneFiles.parse(scene("<sphere name='{repeat}'/>"));
        assertThat(scene.recipe().isNone()).isTrue();
        assertThat(scene.objects().get(0).name()).isEqualTo("{repeat}");
    }

    @Test
    void theSchemaKnowsAllThat() throws Exception {
        SchemaFactory factory = SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI);
        Validator validator = factory.newSchema(new StreamSource(new StringReader(SceneFiles.schema()))).newValidator();
        for (String shipped : List.of("gear", "stair", "forest", "showcase")) {
            validator.validate(new StreamSource(Path.of("../scenes", shipped + ".xml").toFile()));
        }
        for (String wrong : List.of("<sphere radius='{1'/>", "<sphere radius='x'/>", "<repeat><sphere/></repeat>", "<param value='1'/>", "<define name='a'/>")) {
            assertThatThrownBy(() -> validator.validate(new StreamSource(new StringReader(scene(wrong))))).isInstanceOf(SAXException.class);
        }
    }
}
