package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every way to get a file wrong, and the line that says so. */
class BadFilesTest {
    private static final String SAMPLE = "<scene xmlns=\"urn:paprsek:scene:1\">";
    private static final String NO_SCENE = "1:1: this is not a scene file: it should start with " + SAMPLE;
    private static final String EMPTY = "this file is empty; a scene file starts with " + SAMPLE;
    private static final String ROOT = "1:1: a scene file starts with " + SAMPLE + " or <database …>, but here is ";
    private static final String NAMESPACE = "<scene> must have xmlns=\"urn:paprsek:scene:1\", but has ";
    private static final String XSI = "xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance'";

    /** A scene with a camera on line 2 and the given text from line 3 on. */
    private static String scene(String content) {
        return "<scene xmlns='urn:paprsek:scene:1'>\n<camera position='0 1 5' direction='0 0 -1'/>\n" + content + "</scene>";
    }

    private static Arguments in(String content, String... problems) {
        return Arguments.of(scene(content), List.of(problems));
    }

    private static Arguments whole(String file, String problem) {
        return Arguments.of(file, List.of(problem));
    }

    static Stream<Arguments> files() {
        return Stream.of(
                whole("", "1:1: " + EMPTY),
                whole(" \n  ", "2:3: " + EMPTY),
                whole("\uFEFF", "1:1: " + EMPTY),
                whole("hello", NO_SCENE),
                whole("{\"scene\": 1}", NO_SCENE),
                whole("\u0000\u0001\u0002 PNG", "1:1: this is a binary file, not a scene file"),
                whole(scene("") + "\n\0\0\0", "4:1: nothing may follow the end of the first element"),
                whole("<scene/>", "1:1: " + NAMESPACE + "none"),
                whole("<?xml version='1.0'?>\n<!-- a\n b -->\n\n  <scene/>", "5:3: " + NAMESPACE + "none"),
                whole("<scene xmlns='urn:x'><sphere/></scene>", "1:1: " + NAMESPACE + "\"urn:x\""),
                whole("<html/>", ROOT + "<html>"),
                whole("<secne xmlns='urn:paprsek:scene:1'/>", ROOT + "<secne>; did you mean \"scene\"?"),
                whole("<sphere xmlns='urn:paprsek:scene:1' radius='1'/>", ROOT + "<sphere>"),
                whole("<?xml version='1.0'?>\n<scene xmlns='urn:paprsek:scene:1' nam='x'/>", "2:36: <scene> has no attribute \"nam\"; did you mean \"name\"?"),
                whole("<scen", "1:6: the file ends before its first element; is it cut off?"),
                whole("<?xml version='2.0'?><scene/>", "1:20: XML version 2.0 is not supported; write version=\"1.0\""),
                whole(" <?xml version='1.0'?><scene/>", "1:7: <?xml …?> must be the very first thing in a file"),
                whole(scene("") + "\n<scene/>", "4:2: nothing may follow the end of the first element"),
                whole(scene("") + "\nmore", "4:1: nothing may follow the end of the first element"),
                Arguments.of("<!DOCTYPE scene [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><scene>&x;</scene>",
                        List.of("1:10: a DOCTYPE is not allowed in a scene file; remove it")),
                Arguments.of("<scene xmlns='urn:paprsek:scene:1'/>",
                        List.of("1:1: a scene needs a camera; add <camera position=\"0 1 5\" direction=\"0 0 -1\"/>")),
                Arguments.of("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 0'/></scene>",
                        List.of("1:36: <camera> needs a direction or a target")),
                Arguments.of("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 0' direction='0 2 0' up='0 1 0'/></scene>",
                        List.of("1:79: camera up must not be parallel to the view direction; turn one of them")),
                in("<camera position='0 0 0' target='0 0 1' name='a'/>\n<camera name='a' position='0 0 0' target='0 0 1'/>",
                        "4:9: there is already a camera named \"a\" here; give one of them another name"),
                in("<camera position='0 0 0' target='0 1 0' up='0 -2 0'/>", "3:41: camera up must not be parallel to the view direction; turn one of them"),
                in("<camera position='0 0 0' target='0 0 1' projection='orthografic'/>",
                        "3:41: camera projection must be perspective, orthographic, spherical or fisheye, but is \"orthografic\""),
                in("<camera position='0 0 0' target='0 0 1' projection='orthographic'/>", "3:1: an orthographic camera needs a height: of what the picture shows"),
                in("<camera position='0 0 0' target='0 0 1' projection='orthographic' height='0'/>", "3:67: camera height must be a finite number above 0, but is \"0\""),
                in("<camera position='0 0 0' target='0 0 1' height='2'/>", "3:41: height is for the projection orthographic, but this camera's is perspective"),
                in("<camera position='0 0 0' target='0 0 1' projection='fisheye' fovy='20'/>", "3:62: fovy is for the projection perspective, but this camera's is fisheye"),
                in("<camera position='0 0 0' target='0 0 1' projection='spherical' angle='20'/>", "3:64: angle is for the projection fisheye, but this camera's is spherical"),
                in("<camera position='0 0 0' target='0 0 1' projection='fisheye' angle='361'/>", "3:62: camera angle must be a number of degrees above 0, 360 at most, but is \"361\""),
                in("<camera position='0 0 0' target='0 0 1' aperture='-1'/>", "3:41: camera aperture must be a finite number, 0 or above, but is \"-1\""),
                in("<camera position='0 0 0' direction='0 0 1' aperture='0.1'/>",
                        "3:44: a camera with an aperture and no target needs a focus; say how far along the view it is sharp"),
                in("<render/><render/>\n<ambient color='1 2 3'/>\n<ambient color='1 2 3'/>", "3:10: a scene has at most one <render>, but here is another",
                        "5:1: a scene has at most one <ambient>, but here is another"),
                in("<description>a</description>\n <description>b</description>", "4:2: a scene has at most one <description>, but here is another"),
                in("  <sphere radius='-1'/>", "3:11: sphere radius must be a finite number above 0, but is \"-1\""),
                in("<sphere radius='1e999'/>", "3:9: sphere radius must be a finite number above 0, but is \"1e999\""),
                in("<sphere radius='NaN'/>", "3:9: sphere radius must be a finite number above 0, but is \"NaN\""),
                in("<sphere radius='INF'/>", "3:9: sphere radius must be a finite number above 0, but is \"INF\""),
                in("<sphere radius='12,5'/>", "3:9: sphere radius must be a finite number above 0, but is \"12,5\"; a point stands before decimals: \"12.5\""),
                in("<sphere radius='it&apos;s'/>", "3:9: sphere radius must be a finite number above 0, but is \"it's\""),
                in("<sphere raduis='1'/>", "3:9: <sphere> has no attribute \"raduis\"; did you mean \"radius\"?"),
                in("<sphere/>", "3:1: <sphere> needs the attribute radius, a finite number above 0"),
                in("<sphere radius='0x10'/>", "3:9: sphere radius must be a finite number above 0, but is \"0x10\""),
                in("<sphere radius='1d'/>", "3:9: sphere radius must be a finite number above 0, but is \"1d\""),
                in("<sphere radius='' position='1 2 3 4'/>", "3:9: sphere radius must be a finite number above 0, but is \"\"",
                        "3:19: sphere position must be three finite numbers, x y z, but has 4: \"1 2 3 4\""),
                in("<sphere radius='1' position='1, 2, 3'/>", "3:20: sphere position must be three finite numbers, x y z, but is \"1, 2, 3\"; only blanks stand between numbers: \"1 2 3\""),
                in("<sphere radius='1' position='1 2 1e999'/>", "3:20: sphere position must be three finite numbers, x y z, but is \"1 2 1e999\""),
                in("<sphere radius='1' scale='1 2'/>", "3:20: sphere scale must be one finite number or three, none of them 0, but has 2: \"1 2\""),
                in("<rectangle min='0 0 0' max='1 1'/>", "3:12: rectangle min must be two finite numbers, x y, but has 3: \"0 0 0\""),
                in("<background color='rde'/>", "3:13: background color must be three numbers from 0 to 255, red green blue, a name such as red, or #rrggbb, but is \"rde\"; did you mean \"red\"?"),
                in("<background color='Reed'/>\n<ambient color='#ff00'/>", "3:13: background color must be three numbers from 0 to 255, red green blue, a name such as red, or #rrggbb, but is \"Reed\"; did you mean \"red\"?",
                        "4:10: ambient color must be three numbers from 0 to 255, red green blue, a name such as red, or #rrggbb, but is \"#ff00\""),
                in("<spher/><spher/>\n<spher/>", "3:1: <scene> has no element <spher>; did you mean \"sphere\"?",
                        "3:9: <scene> has no element <spher>; did you mean \"sphere\"?", "4:1: <scene> has no element <spher>; did you mean \"sphere\"?"),
                in("<light position='0 0 0'/>", "3:1: <scene> has no element <light>; the word here is \"point-light\""),
                in("<x:sphere xmlns:x='urn:x' radius='1'/>",
                        "3:1: <scene> must hold elements of the namespace urn:paprsek:scene:1 only, but here is <sphere> of \"urn:x\""),
                in("<xi:include xmlns:xi='http://www.w3.org/2001/XInclude' href='/etc/passwd'/>",
                        "3:1: <scene> must hold elements of the namespace urn:paprsek:scene:1 only, but here is <include> of \"http://www.w3.org/2001/XInclude\""),
                in("<sphere " + XSI + " xsi:type='Block' radius='1'/>", "3:63: <sphere> must not have xsi:type or xsi:nil; remove them"),
                in("<sphere radius='1'><material " + XSI + " xsi:type='NamedMaterial' name='x'/></sphere>",
                        "3:84: <material> must not have xsi:type or xsi:nil; remove them"),
                in("<point-light position='0 0 0'><x/></point-light>", "3:1: <point-light> must be empty, but there is something inside"),
                in("<union><block min='1 0 0' max='0 1 1'/></union>",
                        "3:15: block min must be below max along every axis, but min is 1 0 0 and max is 0 1 1"),
                in("<difference><sphere radius='1'/>\n<rectangle min='0 0' max='1 1'/><disc radius='1'/></difference>",
                        "4:1: a rectangle has no inside, so <difference> cannot use it; give it a <block>",
                        "4:33: a disc has no inside, so <difference> cannot use it; give it a <cylinder>"),
                in("<material name=' '/>", "3:11: a material's name must not be blank"),
                in("<material nam='steel'/>\n<sphere radius='1' material='steel'/>", "3:11: <material> has no attribute \"nam\"; did you mean \"name\"?"),
                in("<material name='m' color='1 2 3'><checker size='1'/></material>\n<sphere radius='1' material='m'/>",
                        "3:20: a material has either a color or a pattern, not both; remove one of them"),
                in("<![CDATA[ ]]><sphere radius='0'/>", "3:22: sphere radius must be a finite number above 0, but is \"0\""),
                in("<description>a &amp; <![CDATA[<b>]]></description><sphere radius='0'/>",
                        "3:59: sphere radius must be a finite number above 0, but is \"0\""),
                in("<sphere name='" + "x".repeat(201) + "' radius='1'/>",
                        "3:9: sphere name must be a text of 1 to 200 characters, but is \"" + "x".repeat(60) + "…\""),
                in("<sphere radius='1' name='a&#10;b'/>", "3:20: object name must not have control characters, but has U+000A"),
                in("<sphere radius='1' name='a\u202Eb'/>", "3:20: object name must not have control characters, but has U+202E"),
                in("<union><sphere name='a\u202Eb' radius='1'/></union>", "3:16: operand name must not have control characters, but has U+202E"),
                in("<point-light name='a\u202Eb' position='0 0 0'/>", "3:14: light name must not have control characters, but has U+202E"),
                in("<material name='a\u202Eb'/>", "3:11: material name must not have control characters, but has U+202E"),
                in("&lol;", "3:6: &lol; is not known here; only &amp; &lt; &gt; &quot; &apos; and numbers such as &#233; are"),
                in("<sphere radius=1/>", "3:16: the value of sphere radius must stand in quotes, as in radius=\"…\""),
                in("<sphere radius/>", "3:15: sphere radius needs a value, as in radius=\"…\""),
                in("<sphere radius='1' radius='2'/>", "3:32: <sphere> has the attribute \"radius\" twice; remove one of them"),
                in("<sphere radius='1'></spher>", "3:22: <sphere> must be closed before this; add </sphere>"),
                in("<sphere radius='<'/>", "3:17: the value of sphere radius must not contain <; is a quote missing?"),
                in("<sphere radius='1'name='x'/>", "3:19: the tag <sphere> must go on with an attribute or end with > or />; is a blank or a quote missing?"),
                in("<description>a & b</description>", "3:17: a & must start something like &amp;, which is how the sign itself is written"),
                in("<description>&#x1b;[31m</description>", "3:20: here is a character that XML does not allow; remove it"),
                in("< sphere/>", "3:2: a < must be followed by the name of an element; write &lt; for the sign itself"),
                in("<x:sphere/>", "3:12: the prefix x: is not declared; write the name without it"),
                in("<!-- a -- b -->", "3:10: a comment must not contain --"),
                in("<description>]]></description>", "3:17: a text must not contain ]]>"),
                in("<sphere radius='1' " + "n".repeat(2000) + "='1'/>",
                        "3:2020: here is a name of more than 1000 characters, or something else beyond all measure"),
                in("<sphere radius='" + "1".repeat(1_000_000) + "'/>",
                        "3:9: the value of radius must not be longer than 100000 characters, but has 1000000"),
                in("<!-- a\n comment -->\n <spere radius='1'/>", "5:2: <scene> has no element <spere>; did you mean \"sphere\"?"),
                in("<sphere radius='1' position='1 2'/>", "3:20: sphere position must be three finite numbers, x y z, but has 2: \"1 2\""),
                in("<sphere radius='1' scale='1 0 1'/>", "3:20: sphere scale must be one finite number or three, none of them 0, but is \"1 0 1\""),
                in("<sphere radius='1'>round</sphere>", "3:20: <sphere> holds elements only, but here is the text \"round\""),
                in("\n  text &amp;\n<render>x</render>", "4:3: <scene> holds elements only, but here is the text \"text\"",
                        "5:9: <render> holds elements only, but here is the text \"x\""),
                in("<difference><rectangle min='0 0' max='1 1'/></difference>",
                        "3:13: a rectangle has no inside, so <difference> cannot use it; give it a <block>"),
                in("<union><disc radius='1'/></union>", "3:8: a disc has no inside, so <union> cannot use it; give it a <cylinder>"),
                in("<spot-light position='0 1 0'/>", "3:1: <spot-light> needs a direction or a target"),
                in("<spot-light position='0 1 0' target='0 0 0' direction='0 1 0'/>", "3:45: <spot-light> has either a direction or a target, not both; remove one of them"),
                in("<spot-light position='0 1 0' direction='0 0 0'/>", "3:30: direction must not be 0 0 0"),
                in("<spot-light position='0 1 0' target='0 1 0'/>", "3:30: spot-light target must not be the light's own position"),
                in("<spot-light position='0 1 0' target='0 0 0' inner-angle='50'/>", "3:45: spot-light inner-angle must not be above the outer-angle of 45, but is 50"),
                in("<spot-light position='0 1 0' target='0 0 0' inner-angle='30' outer-angle='20'/>", "3:45: spot-light inner-angle must not be above the outer-angle of 20, but is 30"),
                in("<spot-light position='0 1 0' target='0 0 0' outer-angle='120'/>", "3:45: spot-light outer-angle must be a number of degrees from 0 to 90, but is \"120\""),
                in("<sun-light direction='0 0 0'/>", "3:12: sun-light direction must not be 0 0 0"),
                in("<sun-light direction='0 -1 0' visible='yes'/>", "3:31: sun-light visible must be true or false, but is \"yes\""),
                in("<sun-light direction='0 -1 0' position='0 1 0'/>", "3:31: <sun-light> has no attribute \"position\""),
                in("<area-light position='0 0 0'/>", "3:1: <area-light> needs a size or a radius"),
                in("<area-light position='0 0 0' size='1 1' radius='1'/>", "3:30: <area-light> has either a size or a radius, not both; remove one of them"),
                in("<area-light position='0 0 0' size='1 -1'/>", "3:30: area-light size must be two finite numbers above 0, but is \"1 -1\""),
                in("<area-light position='0 0 0' radius='1' samples='5000'/>", "3:41: area-light samples must be a whole number from 1 to 4096, but is \"5000\""),
                in("<sphere-light position='0 0 0'/>", "3:1: <sphere-light> needs the attribute radius, a finite number above 0"),
                in("<union><point-light position='1 2 3'/></union>", "3:8: <union> has no element <point-light> here"),
                in("<union>\n</union>", "3:1: <union> needs at least one solid inside"),
                in("<sphere radius='1' color='red'/>", "3:20: <sphere> has no attribute \"color\"; it belongs in a <material> inside"),
                in("<union roughness='1'><sphere radius='1'/></union>", "3:8: <union> has no attribute \"roughness\"; it belongs in a <material> inside"),
                in("<checker size='1'/>", "3:1: <scene> has no element <checker> here"),
                in("<sphere radius='1'><image file='a.png'/></sphere>", "3:20: <sphere> has no element <image> here; it belongs in a <material> inside"),
                in("<sphere radius='1'><material><bump/></material></sphere>", "3:30: <bump> needs a pattern inside"),
                in("<sphere radius='1'><material><roughness/></material></sphere>", "3:30: <roughness> needs a pattern inside"),
                in("<sphere radius='1' material='a'/><material name='b'/>", "3:20: there is no material named \"a\""),
                in("<extrude height='1' points='0 0 1 1'/>", "3:21: extrude points must enclose something, but is empty, a point or a line"),
                in("<extrude height='1' path='M0 0L1 2L2 4L3 6Z'/>", "3:21: extrude path must enclose something, but is empty, a point or a line"),
                in("<block min='1 1 1' max='0 2 2'/>",
                        "3:8: block min must be below max along every axis, but min is 1 1 1 and max is 0 2 2"),
                in("<extrude height='1'/>", "3:1: extrude needs a path, or points"),
                in("<text value=' '/>", "3:7: text value must not be blank"),
                in("<text value='a中'/>", "3:7: text value must have letters of the font \"sans\", but the font has no letter for \"中\" (U+4E2D)"),
                in("<extrude height='1' points='0 0 1'/>", "3:21: extrude points must have a number from -1000000000 to 1000000000 at character 6, but has its end"),
                in("<extrude height='1' path='M0 0L1 x'/>", "3:21: extrude path must have a number from -1000000000 to 1000000000 at character 8, but has 'x'"),
                in("<extrude height='1' path='0 0'/>", "3:21: extrude path must have a command such as M at character 1, but has '0'"),
                in("<extrude height='1' points='0 0 1 0'/>", "3:21: extrude points must enclose something, but is empty, a point or a line"),
                in("<lathe points='-1 0 1 0 0 1'/>", "3:8: lathe points must not reach beyond the axis, x = 0, but its least x is -1"),
                in("<cone radius='1' height='1' sides='2'/>", "3:29: cone sides must be a whole number from 3 to 1000, or 0 for round, but is 2"),
                in("<block min='0 0 0' max='1 2 3' rounding='0.6'/>", "3:32: block rounding must be at most half its smallest side of 1, but is 0.6"),
                in("<superellipsoid semi-axes='1 1 1' north='2.5'/>", "3:35: superellipsoid north must be a number above 0, 2 at most, but is \"2.5\""),
                in("<sphere name='a' radius='1'/>\n<sphere name='a' radius='2'/>",
                        "4:9: there is already an object named \"a\" here; give one of them another name"),
                in("<union>\n<sphere name='a' radius='1'/><sphere name='a' radius='2'/></union>",
                        "4:38: there is already an operand named \"a\" here; give one of them another name"),
                in("<material name='a'/><material name='a'/>", "3:31: there is already a material named \"a\" here; give one of them another name"),
                in("<material name='glass'/>\n<sphere radius='1' material='gass'/>",
                        "4:20: there is no material named \"gass\"; did you mean \"glass\"?"),
                in("<sphere radius='1' material='a'><material/></sphere>",
                        "3:20: there is a material attribute and a <material> inside; remove one of them"),
                in("<sphere radius='1'><material><checkerboard columns='2' rows='2'/></material></sphere>",
                        "3:1: a checkerboard lies on a rectangle or a disc only; give this shape a checker"),
                in("<material name='m' color='1 2 3'><checker size='1'/></material>",
                        "3:20: a material has either a color or a pattern, not both; remove one of them"),
                in("<material name='m' color='1 2 256'/>", "3:20: material color must be three numbers from 0 to 255, red green blue, a name such as red, or #rrggbb, but is \"1 2 256\""),
                in("<render width='99999999999'/>", "3:9: render width must be a whole number from 1 to 32768, but is \"99999999999\""),
                in("<render samples='8..2'/>", "3:9: render samples must go from the lesser to the greater number, but go from 8 to 2"),
                in("<render samples='8..2'/>\n<sphere radius='0'/>", "3:9: render samples must go from the lesser to the greater number, but go from 8 to 2",
                        "4:9: sphere radius must be a finite number above 0, but is \"0\""),
                in("<render samples='2..0'/>", "3:9: render samples must be a whole number from 1 to 16, of paths to 1000000, or two such as 2..8, but is \"2..0\""),
                in("<render hight='3'/>\n<sphere radius='0'/>", "3:9: <render> has no attribute \"hight\"; did you mean \"height\"?",
                        "4:9: sphere radius must be a finite number above 0, but is \"0\""),
                in("<sphere radius='1' name='a&#27;[31mb'/>".replace("&#27;", "&#x85;"),
                        "3:20: object name must not have control characters, but has U+0085"),
                // What the schema refuses does not hide what else is wrong, nor does it cause more.
                Arguments.of("<scene xmlns='urn:paprsek:scene:1'>\n  <camera position='0 0 0'/>\n <sphere raduis='1'/>\n"
                        + "<sphere radius='-1'/>\n<block min='1 1 1' max='0 0 0'/><sphere radius='1' material='x'/></scene>", List.of(
                        "2:3: <camera> needs a direction or a target",
                        "3:10: <sphere> has no attribute \"raduis\"; did you mean \"radius\"?",
                        "4:9: sphere radius must be a finite number above 0, but is \"-1\"",
                        "5:8: block min must be below max along every axis, but min is 1 1 1 and max is 0 0 0",
                        "5:52: there is no material named \"x\"")),
                whole("<scene xmlns='urn:paprsek:scene:1'><camra position='0 0 0'/></scene>", "1:36: <scene> has no element <camra>; did you mean \"camera\"?"));
    }

    @ParameterizedTest
    @MethodSource("files")
    void eachMistakeGetsItsLine(String xml, List<String> expected) throws IOException {
        assertThat(problems(xml)).containsExactlyElementsOf(expected);
    }

    @ParameterizedTest
    @ValueSource(strings = {"de", "ja", "zh-CN", "cs"})
    void theLanguageOfTheMachineDoesNotMatter(String language) throws IOException {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag(language));
            assertThat(problems(scene("<sphere radius='1'"))).containsExactly(
                    "3:19: the tag <sphere> must go on with an attribute or end with > or />; is a blank or a quote missing?");
            assertThat(problems(scene("<sphere raduis='1' radius='x'/><spere/>"))).containsExactly(
                    "3:9: <sphere> has no attribute \"raduis\"",
                    "3:20: sphere radius must be a finite number above 0, but is \"x\"",
                    "3:32: <scene> has no element <spere>; did you mean \"sphere\"?");
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void aFileCutAnywhereIsRefusedInOneLine() throws IOException {
        String whole = scene("<difference name='a'>\n<sphere radius='1'/><block min='0 0 0' max='1 1 1'/></difference>\n");
        for (int end = 0; end < whole.length(); end++) {
            WayIn way = List.of(WayIn.values()).get(end % WayIn.values().length);
            assertThat(way.outcome(whole.substring(0, end).getBytes(StandardCharsets.UTF_8)).problems()).as(whole.substring(0, end)).hasSizeBetween(1, 2);
        }
    }

    @Test
    void deepNestingIsRefusedQuickly() {
        assertTimeoutPreemptively(Duration.ofSeconds(5), () ->
                assertThat(problems(scene("<union>".repeat(200_000)))).containsExactly("3:1744: elements must not be nested deeper than 250"));
    }

    @Test
    void bytesThatAreNoTextAreRefused() throws IOException {
        byte[] latin = scene("<sphere radius='1' name='é'/>").getBytes(StandardCharsets.ISO_8859_1);
        byte[] unknown = "<?xml version='1.0' encoding='klingon'?><scene/>".getBytes(StandardCharsets.UTF_8);
        for (byte[] bytes : List.of(latin, unknown, new byte[] {-1, -40, 3, 9})) {
            assertThat(lines(bytes)).hasSize(1);
        }
    }

    @Test
    void textsSayWhatTheyClaimToBe() throws Exception {
        String text = scene("<sphere radius='1' name='é'/>");
        for (String name : List.of("UTF-8", "UTF-16", "ISO-8859-1", "windows-1250")) {
            String declared = "<?xml version='1.0' encoding='" + name + "'?>" + text;
            assertThat(WayIn.all(declared.getBytes(name)).scene()).as(name).isEqualTo(WayIn.all(text).scene());
            assertThat(SceneFiles.parse(declared)).as("a text is a text already").isEqualTo(SceneFiles.parse(text));
        }
        assertThat(lines("<?xml version='1.0' encoding='UTF-16'?>\n<scene/>".getBytes(StandardCharsets.UTF_8)))
                .containsExactly("x:1:40: this is not text in the encoding UTF-16, which the file claims to have; save it as UTF-8");
        assertThat(lines("<?xml version='1.0' encoding='KLINGON'?>\n<scene/>".getBytes(StandardCharsets.UTF_8)))
                .containsExactly("x:1:1: the encoding \"KLINGON\", which the file claims to have, is not known here; save it as UTF-8");
    }

    /** Also where one element starts after the place that an error in another led the reader to. */
    @Test
    void everyElementIsFoundWhereItStarts() throws IOException {
        StringBuilder file = new StringBuilder();
        List<String> expected = new ArrayList<>();
        Random random = new Random(1);
        for (int i = 0; i < 20_000; i++) {
            file.append(" ".repeat(random.nextInt(9)));
            int start = file.length() - file.lastIndexOf("\n");
            if (i % 211 == 0) {
                expected.add((3 + i) + ":" + start + ": <sphere> needs the attribute radius, a finite number above 0");
            }
            file.append(i % 211 == 0 ? "<sphere" : "<sphere radius='1'").append(i % 3 == 0 ? "></sphere><!-- ě -->\n" : "/>\n");
        }
        assertThat(problems(scene(file.toString()))).isEqualTo(expected);
    }

    /** Whatever comes before it: other attributes, with what looks like it in them, ends of lines of every kind, characters of two halves, in any encoding. */
    @Test
    void everyAttributeIsFoundWhereItStarts() throws IOException {
        StringBuilder file = new StringBuilder();
        List<String> expected = new ArrayList<>();
        List<String> between = List.of(" ", "\n", "\r\n", "\r", "\t ", " name='radius=\"0\"'\n ", " name=\"\uD83D\uDE00 ='\" ");
        Random random = new Random(2);
        for (int i = 0; i < 2000; i++) {
            file.append("<sphere").append(between.get(random.nextInt(between.size())));
            String before = file.toString().replaceAll("\r\n?", "\n");
            if (i % 29 == 0) {
                expected.add((3 + before.chars().filter(c -> c == '\n').count()) + ":" + (before.length() - before.lastIndexOf("\n"))
                        + ": sphere radius must be a finite number above 0, but is \"0\"");
            }
            file.append("radius").append(i % 2 == 0 ? " = " : "=").append(i % 29 == 0 ? "'0'" : "\"1\"").append(" /><!-- <sphere radius='0'/> -->\n");
        }
        assertThat(problems(scene(file.toString()))).filteredOn(line -> line.contains("radius must")).isEqualTo(expected);
    }

    @ParameterizedTest
    @ValueSource(strings = {"<spher/>", "<sphere radius='0'/>", "<sphere radius='1' material='q'/>", "<sphere radius='1' name='q'/>",
        "<block min='1 1 1' max='0 0 0'/>", "<union/>", "<sphere radius='1' a='1' b='2'/>"})
    void ofAHundredThousandMistakesTheFirstHundredAreTold(String mistake) {
        assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
            WayIn way = List.of(WayIn.values()).get(mistake.length() % WayIn.values().length);
            List<String> problems = way.outcome(scene(mistake.repeat(100_000)).getBytes(StandardCharsets.UTF_8)).problems();
            assertThat(problems).hasSize(101);
            assertThat(problems.get(100)).endsWith(": there are more problems than these 100; mend these first");
        });
    }

    @Test
    void nothingThatAFileRefersToIsFetched() throws Exception {
        String hints = "<scene xmlns='urn:paprsek:scene:1' " + XSI + " xsi:schemaLocation='urn:paprsek:scene:1 http://127.0.0.1:9/x.xsd urn:y file:///y.xsd'"
                + " xsi:noNamespaceSchemaLocation='http://127.0.0.1:9/z.xsd'><camera position='0 1 5' direction='0 0 -1'/>";
        assertThat(WayIn.all(hints + "</scene>").scene()).isEqualTo(WayIn.all(scene("")).scene());
        assertThat(problems(hints + "<a xmlns='urn:y'/></scene>")).hasSize(1);
    }

    @Test
    void anEndlessFileIsRefused() {
        InputStream limited = new LimitedInput(new ByteArrayInputStream(new byte[2000]), "x", 1000);
        assertThatExceptionOfType(IOException.class).isThrownBy(limited::readAllBytes)
                .withMessageStartingWith("x: this file is larger than the 1000 bytes that a scene file may have");
    }

    /** Files with a byte changed, left out or doubled are read or refused, and nothing else happens. */
    @Test
    void damagedFilesAreReadOrRefused() throws Exception {
        byte[] good = SceneFiles.format(RandomScenes.of(7)).getBytes(StandardCharsets.UTF_8);
        Random random = new Random(5);
        String interesting = "<>&'\"/=- \n0e.!?[]:x\u0000";
        for (int i = 0; i < 4 * Integer.getInteger("paprsek.damages", 125); i++) {
            ByteArrayOutputStream bad = new ByteArrayOutputStream();
            int at = random.nextInt(good.length);
            bad.write(good, 0, at);
            for (int j = random.nextInt(3); j > 0; j--) {
                bad.write(random.nextBoolean() ? random.nextInt(256) : interesting.charAt(random.nextInt(interesting.length())));
            }
            int from = Math.min(good.length, at + random.nextInt(3));
            bad.write(good, from, good.length - from);
            WayIn way = List.of(WayIn.values()).get(i % WayIn.values().length);
            byte[] file = bad.toByteArray();
            assertThat((way.takes(file) ? way : WayIn.STREAM).outcome(file).problems()).allSatisfy(line -> assertThat(line).matches("[1-9][0-9]*:[1-9][0-9]*: [^\\p{Cc}]+")
                    .doesNotContain("cvc-", "JAXP", "xerces", "null"));
        }
    }

    @Test
    void aMissingFileAndAFolderAreNamed(@TempDir Path folder) {
        assertThatExceptionOfType(IOException.class).isThrownBy(() -> SceneFiles.read(folder.resolve("none.xml")))
                .withMessage(folder.resolve("none.xml") + ": no such file");
        assertThatExceptionOfType(IOException.class).isThrownBy(() -> SceneFiles.read(folder))
                .withMessage(folder + ": this is a directory, not a scene file");
    }

    private static List<String> problems(String xml) throws IOException {
        List<String> problems = WayIn.all(xml).problems();
        assertThat(problems).as("refused").isNotEmpty();
        return problems;
    }

    /** The problems of a file; none if it is good. */
    private static List<String> lines(byte[] file) throws IOException {
        return WayIn.all(file).problems().stream().map(line -> "x:" + line).toList();
    }
}
