package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** All that is well-formed XML and follows the schema is a scene, whatever program wrote it and whichever way it comes in. */
class EveryWayInTest {
    private static final String XSI = "xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance'";
    private static final String PLAIN = "<scene xmlns='urn:paprsek:scene:1' name='Žluťoučký kůň'><render width='16' height='12'/><background color='10 20 30'/>"
            + "<camera position='0 0 5' direction='0 0 -1'/><description>a &lt; b &amp; c</description><sphere name='kůň' radius='1.5'/></scene>";

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static Arguments utf8(String what, String text) {
        return Arguments.of(what, bytes(text));
    }

    static Stream<Arguments> sameScene() {
        String lined = PLAIN.replace("><", ">\n<");
        return Stream.of(
                utf8("plain", PLAIN),
                utf8("mark of UTF-8", "\uFEFF" + PLAIN),
                utf8("mark and declaration", "\uFEFF<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + PLAIN),
                utf8("standalone", "<?xml version='1.0' encoding='UTF-8' standalone='yes'?>\n" + PLAIN),
                utf8("XML 1.1", "<?xml version='1.1'?>\n" + PLAIN),
                utf8("XML 1.1 with its line ends", "<?xml version='1.1' encoding='UTF-8'?>\u0085" + PLAIN.replace("><", ">\u0085\u2028<")),
                utf8("lines of Windows", lined.replace("\n", "\r\n")),
                utf8("lines of old Macs", lined.replace("\n", "\r")),
                utf8("prefix", PLAIN.replaceAll("<(/?)", "<$1p:").replace("xmlns=", "xmlns:p=")),
                utf8("namespace in each element", PLAIN.replace("<sphere", "<sphere xmlns='urn:paprsek:scene:1'")),
                utf8("other namespaces declared", PLAIN.replace("<scene", "<scene xmlns:inkscape='urn:x' " + XSI)),
                utf8("unmarked text", PLAIN.replace("a &lt; b &amp; c", "a <![CDATA[< b & c]]>")),
                utf8("unmarked nothing", PLAIN.replace("a &lt;", "<![CDATA[]]>a &lt;")),
                utf8("text around a comment", PLAIN.replace("a &lt;", "a<!-- ? --> &lt;")),
                utf8("references by number", PLAIN.replace("kůň", "k&#x16f;&#328;").replace("1.5", "&#49;.5")),
                utf8("processing instructions", "<?xml-stylesheet href='a.css'?>" + PLAIN.replace("<sphere", "<?editor a=\"1\" ?>\n<sphere") + "<?end?>"),
                utf8("comments", "<!-- a -->\n" + PLAIN.replace("<", "<!-- - --><").replace("<!-- - --></description>", "</description>") + "\n<!-- b -->\n"),
                utf8("schema location", PLAIN.replace("<scene", "<scene " + XSI + " xsi:schemaLocation='urn:paprsek:scene:1 scene.xsd'")),
                utf8("schema location without namespace", PLAIN.replace("<scene", "<scene " + XSI + " xsi:noNamespaceSchemaLocation='scene.xsd'")),
                utf8("white space around numbers", PLAIN.replace("'1.5'", "'\n\t 1.5 '").replace("'16'", "' 16\r\n'").replace("'10 20", "'\t10  20").replace("-1'", "-1&#10;'")),
                utf8("numbers in other words", PLAIN.replace("1.5", "+015.0E-1").replace("'16'", "'+016'").replace("0 0 5", "-0.0 .0 5.")),
                utf8("white space within tags", PLAIN.replace("/>", "\n\t/>").replace("radius='1.5'", "radius\n=\t'1.5'").replace("</scene>", "</scene \n>")),
                utf8("white space behind", PLAIN + "\n \t\r\n"),
                in("UTF-16"), in("UTF-16LE"), in("UTF-16BE"), in("ISO-8859-2"), in("windows-1250"), in("IBM852"), in("ISO-10646-UCS-2", "UTF-16"),
                Arguments.of("UTF-16 by its mark alone", ("\uFEFF" + PLAIN).getBytes(StandardCharsets.UTF_16LE)),
                Arguments.of("big UTF-16 by its mark alone", ("\uFEFF" + PLAIN).getBytes(StandardCharsets.UTF_16BE)),
                Arguments.of("big UTF-32, which the parser guesses", PLAIN.getBytes(Charset.forName("UTF-32BE"))),
                Arguments.of("UTF-8 in small letters", bytes("<?xml version='1.0' encoding='utf-8'?>" + PLAIN)),
                Arguments.of("letters of mainframes", ("<?xml version='1.0' encoding='IBM870'?>" + PLAIN).getBytes(Charset.forName("IBM870"))));
    }

    private static Arguments in(String encoding) {
        return in(encoding, encoding);
    }

    private static Arguments in(String encoding, String charset) {
        return Arguments.of(encoding, ("<?xml version='1.0' encoding='" + encoding + "'?>" + PLAIN).getBytes(Charset.forName(charset)));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("sameScene")
    void oneSceneInManyHandsIsOneScene(String what, byte[] file) throws IOException {
        Scene scene = WayIn.all(file).scene();
        assertThat(scene.name()).isEqualTo("Žluťoučký kůň");
        assertThat(scene.description()).isEqualTo("a < b & c");
        assertThat(scene.settings().width()).isEqualTo(16);
        assertThat(scene.background()).isEqualTo(new Rgb(10, 20, 30));
        assertThat(scene.camera().position()).isEqualTo(new Vec3(what.startsWith("numbers") ? -0.0 : 0, 0, 5));
        assertThat(scene.objects()).singleElement().satisfies(object -> {
            assertThat(object.name()).isEqualTo("kůň");
            assertThat(object.shape()).isEqualTo(new Sphere(1.5));
        });
    }

    static Stream<Arguments> words() {
        Function<Described, Stream<String>> words = one -> switch (one.says().value().form()) {
            case WORD -> Described.words(one.type()).keySet().stream();
            case FLAG -> Stream.of("true", "false");
            default -> Stream.of();
        };
        return Stream.of(RenderSettings.class, Camera.class, Light.class, Shape.class, Material.class).flatMap(ElementTable::of)
                .flatMap(type -> Described.of(type).stream().flatMap(one -> words.apply(one).map(word -> Arguments.of(ElementTable.name(type), one.name(), word))));
    }

    /** The schema takes blanks around words; so what takes the file after it must as well. */
    @ParameterizedTest
    @MethodSource("words")
    void blanksAroundWordsMeanNothing(String element, String attribute, String word) throws IOException {
        String others = Map.of("area-light", "position='0 0 0' radius='1' ", "sphere-light", "position='0 0 0' radius='1' ", "sun-light", "direction='0 -1 0' angle='1' ",
                "camera", "position='0 0 5' direction='0 0 -1' ", "material", "name='m' ", "height-field", "file='h.png' ").getOrDefault(element, "") + (word.equals("orthographic") ? "height='2' " : "");
        String scene = "<scene xmlns='urn:paprsek:scene:1'><" + element + " " + others + attribute + "='%s'/>"
                + (element.equals("camera") ? "" : "<camera position='0 0 5' direction='0 0 -1'/>") + "</scene>";
        Scene plain = WayIn.all(scene.formatted(word)).scene();
        for (String blanks : List.of(" %s ", "\n\t%s", "%s&#32;", " %s")) {
            assertThat(WayIn.all(scene.formatted(blanks.formatted(word))).scene()).as(blanks).isEqualTo(plain);
        }
    }

    @Test
    void databasesComeInAllThoseWays() throws IOException {
        Scene scene = WayIn.all(PLAIN).scene();
        List<Scene> scenes = new ArrayList<>();
        for (int i = 0; i < 30; i++) {
            scenes.add(scene.withName("scene " + i));
        }
        String text = SceneFiles.formatAll(scenes);
        for (String dress : List.of(text, "\uFEFF" + text, text + "<?end?>", text.replace("<scene", "<?scene?><scene"))) {
            assertThat(WayIn.all(dress).contents()).contains(new SceneFiles.Contents(scenes, true));
        }
    }

    @ParameterizedTest
    @CsvSource({
        "0\u00a00\u00a05, U+00A0 (no-break space); write an ordinary blank instead", "0\u20090 5, U+2009 (thin space); write an ordinary blank instead",
        "0\u202f0 5, U+202F (narrow no-break space); write an ordinary blank instead", "0 0\u30005, U+3000 (ideographic space); write an ordinary blank instead",
        "0\u20280 5, U+2028 (line separator); write an ordinary blank instead", "0\u00850 5, U+0085 (next line (nel)); write an ordinary blank instead",
        "0 0 \u22125, U+2212 (minus sign); write \"-\" instead", "0 0 \u20135, U+2013 (en dash); write \"-\" instead", "0 0 \u20145, U+2014 (em dash); write \"-\" instead",
        "0 0 \u20115, U+2011 (non-breaking hyphen); write \"-\" instead", "0 0 \uff0d5, U+FF0D (fullwidth hyphen-minus); write \"-\" instead",
        "0 0 \uff15, U+FF15 (fullwidth digit five); write \"5\" instead", "0 0 \u0665, U+0665 (arabic-indic digit five); write \"5\" instead",
        "0 0 5\uff0e5, U+FF0E (fullwidth full stop); write \".\" instead", "0 0 \u200b5, 'U+200B (zero width space); remove it, nobody sees it'",
        "0 0 \u201c5, 'U+201C (left double quotation mark); remove it, the straight quotes are enough'",
        "0 0 5\u2019, 'U+2019 (right single quotation mark); remove it, the straight quotes are enough'",
        "0 0 5\u00ad, 'U+00AD (soft hyphen); remove it, nobody sees it'", "0 0 \ufeff5, 'U+FEFF (zero width no-break space); remove it, nobody sees it'"})
    void whatLooksLikeANumberAndIsNoneIsNamed(String value, String advice) throws IOException {
        assertThat(WayIn.all(PLAIN.replace("0 0 5", value)).problems()).singleElement().asString()
                .contains("camera position must be three finite numbers, x y z, but has " + advice + ": \"");
    }

    static Stream<Arguments> mismatches() {
        String says8 = "<?xml version='1.0' encoding='UTF-8'?>" + PLAIN;
        String says16 = "<?xml version='1.0' encoding='UTF-16'?>" + PLAIN;
        return Stream.of(
                Arguments.of(("\uFEFF" + says8).getBytes(StandardCharsets.UTF_16LE), "this is text in UTF-16, but the file claims to be UTF-8; save it as UTF-8"),
                Arguments.of(("\uFEFF" + says8).getBytes(StandardCharsets.UTF_16BE), "this is text in UTF-16, but the file claims to be UTF-8; save it as UTF-8"),
                Arguments.of(says8.getBytes(StandardCharsets.UTF_16LE), "this is text in UTF-16, but the file claims to be UTF-8; save it as UTF-8"),
                Arguments.of(says8.getBytes(StandardCharsets.UTF_16BE), "this is text in UTF-16, but the file claims to be UTF-8; save it as UTF-8"),
                Arguments.of(PLAIN.getBytes(StandardCharsets.UTF_16LE), "this is text in UTF-16, but the mark that says so is missing at its start; save it as UTF-8"),
                Arguments.of(bytes(says16), "this is not text in the encoding UTF-16, which the file claims to have; save it as UTF-8"),
                Arguments.of(bytes("\uFEFF" + says16), "this is not text in the encoding UTF-16, which the file claims to have; save it as UTF-8"),
                Arguments.of(bytes(says16.replace("UTF-16", "ISO-10646-UCS-2")), "this is not text in the encoding ISO-10646-UCS-2, which the file claims to have; save it as UTF-8"),
                Arguments.of(bytes(says16.replace("UTF-16", "IBM037")), "this is not text in the encoding IBM037, which the file claims to have; save it as UTF-8"),
                Arguments.of(bytes(says16.replace("UTF-16", "UTF-8 ")), "the encoding \"UTF-8 \", which the file claims to have, is not known here; save it as UTF-8"),
                Arguments.of(("\uFEFF" + says8).getBytes(Charset.forName("UTF-32LE")), "this is text in UTF-32, which cannot be read here; save it as UTF-8"),
                Arguments.of(PLAIN.getBytes(Charset.forName("windows-1250")), "this is not text in UTF-8, and the file names no other encoding; save it as UTF-8"),
                Arguments.of(says8.getBytes(Charset.forName("windows-1250")), "this is not text in the encoding UTF-8, which the file claims to have; save it as UTF-8"));
    }

    @ParameterizedTest
    @MethodSource("mismatches")
    void anEncodingThatIsNotTheOneClaimedIsNamed(byte[] file, String sentence) throws IOException {
        assertThat(WayIn.all(file).problems()).singleElement().asString().endsWith(": " + sentence);
    }

    @ParameterizedTest
    @CsvSource({
        "<box/>, <scene> has no element <box>; the word here is \"block\"", "<Cube/>, <scene> has no element <Cube>; the word here is \"block\"",
        "<ball/>, <scene> has no element <ball>; the word here is \"sphere\"", "<pointLight/>, <scene> has no element <pointLight>; did you mean \"point-light\"?",
        "<directional-light/>, <scene> has no element <directional-light>; the word here is \"sun-light\"", "<light_source/>, <scene> has no element <light_source>; the word here is \"point-light\"",
        "<sphere r='1'/>, <sphere> has no attribute \"r\"; the word here is \"radius\"", "<sphere radius='1' center='1 2 3'/>, <sphere> has no attribute \"center\"; the word here is \"position\"",
        "<block size='1 1 1'/>, <block> has no attribute \"size\"; the words here are \"min\" and \"max\"", "<cylinder radius='1' length='2'/>, <cylinder> has no attribute \"length\"; the word here is \"height\"",
        "<material name='a' ior='1.5'/>, <material> has no attribute \"ior\"; the word here is \"refractive-index\"", "<material name='a' opacity='1'/>, <material> has no attribute \"opacity\"; the word here is \"transparency\"",
        "<material name='a'><checkers size='1'/></material>, <material> has no element <checkers>; the word here is \"checker\"",
        "<material name='a' phong_size='9'/>, <material> has no attribute \"phong_size\"; the word here is \"shininess\"",
        "<material name='a' metallic='1'/>, <material> has no attribute \"metallic\"; the word here is \"fresnel\"", "<material name='a' diffuse-color='1 1 1'/>, <material> has no attribute \"diffuse-color\"; the word here is \"color\"",
        "<material name='a' emissive='1 1 1'/>, <material> has no attribute \"emissive\"; the word here is \"emission\"", "<render tone-mapping='filmic'/>, <render> has no attribute \"tone-mapping\"; the word here is \"tone\"",
        "<parameter name='a' value='1'/>, <scene> has no element <parameter>; the word here is \"param\"", "<copies count='3'/>, <scene> has no element <copies>; the word here is \"repeat\"",
        "<repaet count='3'/>, <scene> has no element <repaet>; did you mean \"repeat\"?", "<terrain file='a.png'/>, <scene> has no element <terrain>; the word here is \"height-field\"", "<heightfield file='a.png'/>, <scene> has no element <heightfield>; did you mean \"height-field\"?",
        "<isosurface formula='x'/>, <isosurface> has no attribute \"formula\"; the word here is \"expression\"",
        "<sky src='a.hdr'/>, <sky> has no attribute \"src\"; the word here is \"file\"",
        "<torus r1='2' r2='1'/>, <torus> has no attribute \"r1\"; the word here is \"major-radius\"", "<torus major-radius='2' tube-radius='1'/>, <torus> has no attribute \"tube-radius\"; the word here is \"minor-radius\"",
        "<torus radius='2' minor-radius='1'/>, <torus> has no attribute \"radius\"; the word here is \"major-radius\"",
        "<union><light/></union>, <union> has no element <light>",
        "<trimesh file='a.obj'/>, '<scene> has no element <trimesh>; triangles stand in a file of their own: <mesh file=\"...\"/>'",
        "<union><Triangle/></union>, '<union> has no element <Triangle>; triangles stand in a file of their own: <mesh file=\"...\"/>'",
        "<include href='a.xml'/>, <include> has no attribute \"href\"",
        "<subtract/>, <scene> has no element <subtract>; the word here is \"difference\"", "<sphere radius='1'><texture/></sphere>, <sphere> has no element <texture>; the word here is \"material\""})
    void wordsOfOtherProgramsAreTranslated(String element, String sentence) throws IOException {
        assertThat(WayIn.all(PLAIN.replace("</scene>", element + "</scene>")).problems()).anyMatch(problem -> problem.contains(": " + sentence));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "radius | 1,5 | a point stands before decimals: \"1.5\"", "radius | 1cm | numbers have no units here: \"1\"", "radius | 2.5f | numbers have no units here: \"2.5\"",
        "radius | (2) | write \"2\"", "position | 1,2,3 | only blanks stand between numbers: \"1 2 3\"",
        "position | 1, 2, 3 | only blanks stand between numbers: \"1 2 3\"", "position | 1;2; 3 | only blanks stand between numbers: \"1 2 3\"",
        "position | &lt;1,-2,.3&gt; | only blanks stand between numbers: \"1 -2 .3\"", "position | [1 2 3] | only blanks stand between numbers: \"1 2 3\"",
        "position | 1,5 2 3,25 | a point stands before decimals: \"1.5 2 3.25\"", "rotation | 90° | numbers have no units here", "rotation | 0 90deg 0 | numbers have no units here: \"0 90 0\"",
        "scale | 2,2,2 | only blanks stand between numbers: \"2 2 2\"", "scale | 1,5 | a point stands before decimals: \"1.5\"",
        "color | 255,0,0 | only blanks stand between numbers: \"255 0 0\"", "color | rgb(255, 128, 0) | only blanks stand between numbers: \"255 128 0\"",
        "color | rgb &lt;1, 0.5, 0&gt; | colours go up to 255: \"255 127.5 0\"", "color | 0xFF8000 | write \"#FF8000\"", "color | ff8000 | write \"#ff8000\"",
        "color | #ff8000ff | write \"#ff8000\", a colour has no transparency of its own", "diffusion | 50% | write \"0.5\"",
        "width | 1,024 | write \"1024\"", "width | 1'024 | write \"1024\"", "width | 800px | numbers have no units here: \"800\""})
    void numbersInOtherNotationsAreWrittenAsTheyAreHere(String attribute, String value, String advice) throws IOException {
        String element = List.of("color", "diffusion").contains(attribute) ? "<material name='m' %s=\"%s\"/>" : attribute.equals("width") ? "" : "<sphere %s=\"%s\"/>";
        String file = attribute.equals("width") ? PLAIN.replace("'16'", '"' + value + '"') : PLAIN.replace("</scene>", element.formatted(attribute, value) + "</scene>");
        String shown = value.replace("&lt;", "<").replace("&gt;", ">");
        assertThat(WayIn.all(file).problems()).anySatisfy(problem -> assertThat(problem).endsWith(", but is \"" + shown + "\"; " + advice));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"position | 1 2 | has 2: \"1 2\"", "radius | -2 | is \"-2\"", "radius | 1e | is \"1e\"", "radius | nan | is \"nan\"", "radius | 1,2,3 | is \"1,2,3\"",
        "position | a,b,c | is \"a,b,c\"", "position | 1,2 | is \"1,2\"", "scale | 1 2 | has 2: \"1 2\"", "rotation | 1 2 3 4 | has 4: \"1 2 3 4\""})
    void whatNobodyCanTellGetsNoAdvice(String attribute, String value, String end) throws IOException {
        assertThat(WayIn.all(PLAIN.replace("</scene>", "<sphere " + attribute + "='" + value + "'/></scene>")).problems())
                .anySatisfy(problem -> assertThat(problem).endsWith(", but " + end));
    }

    @ParameterizedTest
    @CsvSource({"red, 255 0 0", "#ff0000, 255 0 0", "#f00, 255 0 0", "#Ff8000, 255 128 0", "#f80, 255 136 0", "rebeccapurple, 102 51 153", " white , 255 255 255", "gray, 128 128 128",
        "lightgoldenrodyellow, 250 250 210", "Red, 255 0 0", "DarkSlateGrey, 47 79 79", "WHITE, 255 255 255"})
    void coloursHaveNamesToo(String word, String numbers) throws IOException {
        String all = PLAIN.replace("10 20 30", "%1$s").replace("</scene>", "<ambient color='%1$s'/><point-light position='0 0 0' color='%1$s'/><material name='m' color='%1$s'/>"
                + "<material name='n'><checker size='1' even='%1$s' odd='%1$s'/></material><disc radius='1'><material><checkerboard columns='1' rows='1' even='%1$s' odd='%1$s'/>"
                + "</material></disc></scene>");
        Scene scene = WayIn.all(String.format(all, word)).scene();
        assertThat(scene).isEqualTo(WayIn.all(String.format(all, numbers)).scene());
        assertThat(WayIn.all("\uFEFF" + String.format(all, word) + "<?p?>").scene()).as("read thoroughly").isEqualTo(scene);
        assertThat(SceneFiles.format(scene)).contains("<background color=\"" + numbers.strip() + "\"/>");
    }

    @Test
    void aDatabaseThatComesThroughAPipeIsReadButNotChanged(@TempDir Path folder) throws Exception {
        Path pipe = folder.resolve("pipe.xml");
        assumeTrue(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0);
        assertThatThrownBy(() -> DatabaseFile.update(pipe, database -> database)).isInstanceOf(IOException.class)
                .hasMessage(pipe + ": what is to be changed must be a file, not a pipe or a device");
        assertThatThrownBy(() -> DatabaseFile.create(pipe).save(SceneDatabase.EMPTY)).hasMessageEndingWith("must be a file, not a pipe or a device");
        assertThat(Files.exists(pipe)).isTrue();
    }

    /** More than is kept of what cannot be read twice: read all the same. */
    @Test
    void aVeryLongPipeIsRead() throws Exception {
        byte[] file = bytes(PLAIN.replace("</scene>", ("<!--" + " ".repeat(1000) + "-->\n").repeat(140_000) + "<sphere radius='2'/></scene>"));
        assertThat(file.length).isGreaterThan(1 << 27);
        assertThat(WayIn.PIPE.outcome(file).scene().objects()).hasSize(2);
    }
}
