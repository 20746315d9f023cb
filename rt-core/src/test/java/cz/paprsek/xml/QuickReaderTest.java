package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.xml.SceneFiles.Contents;
import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.quick.QuickReader;
import cz.paprsek.xml.recipe.Script;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The quick reader takes all ordinary good files, and none that the thorough one refuses or understands in another way. */
class QuickReaderTest {
    private static final String CAMERA = "<camera position='0 1 5' direction='0 0 -1'/>";

    @ParameterizedTest
    @MethodSource("cz.paprsek.xml.SceneFilesTest#scenes")
    void shippedScenesAreReadQuickly(Path file) throws Exception {
        byte[] bytes = Files.readAllBytes(file);
        // What is made by formulas is written out first.
        assertThat(check(bytes).isPresent()).isEqualTo(!Script.mayBeIn(bytes));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void whatIsWrittenIsReadQuickly(long seed) throws Exception {
        Scene scene = RandomScenes.of(seed);
        assertThat(check(bytes(SceneFiles.format(scene)))).contains(List.of(scene));
        List<Scene> two = List.of(scene, RandomScenes.of(seed + 100).withName("other"));
        assertThat(check(bytes(SceneFiles.formatAll(two)))).contains(two);
        assertThat(check(bytes(SceneFiles.formatAll(List.of())))).contains(List.of());
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "<sphere radius='1'></sphere>", "<point-light position='0 0 0'>\n  <!-- a -->\t</point-light>", "<sphere radius='1'>\n</sphere >", "<sphere\n\tradius = '1'/>", "<sphere\n\tradius='1'\r\n/>", "<!-- Koule č. 1 -->",
        "<!---->", "<!--->-->", "<!-- - -->", "<description/>", "<description>a &lt; b &#233; &#xE9;\n &amp; č</description>", "<description></description>",
        "<sphere radius=' 1\n'/>", "<sphere radius='1' position='1\n2\t3'/>", "<sphere name='a&apos;b' radius='1'/>", "<sphere name='a\nb' radius='1'/>",
        "<background color='red'/>", "<background color=' #Ff8000\n'/>", "<background color='#f80'/>", "<sphere radius='1'><material/></sphere>", "<union><material/><sphere radius='1'/></union>", "<render/>", "<sphere radius='1e0' scale='2'/>",
        CAMERA, "<camera name='a' position='0 1 5' target='0 0 0' up='0 0 1' fovy='30' aperture='0.1' focus='2'/>", "<camera position='0 5 0' target='0 0 0'/>",
        "<camera position='0 5 0' direction='0 1 0' projection='spherical'/>", "<camera projection='orthographic' position='0 5 0' target='0 0 0' height='2'/>",
        "<camera projection='fisheye' position='0 5 0' target='0 0 0'/>", "<camera projection='fisheye' position='0 5 0' target='0 0 0' angle='360'/>",
        "<camera projection='perspective' position='0 5 0' target='0 0 0' fovy='10'/>"})
    void commonWaysOfWritingAreRead(String content) throws Exception {
        WayIn.all(scene(content)).scene();
        assertThat(check(bytes(scene(content)))).isPresent();
    }

    /** Whether or not they are read quickly: what matters is that both readers agree. */
    @ParameterizedTest
    @ValueSource(strings = {
        "<sphere radius='1'><material/><material/></sphere>", "<union><sphere radius='1'/><material/></union>", "<union/>", "<union><material/></union>",
        "<sphere radius='1'><material name='x'/></sphere>", "<material/>", "<material name=''/>", "<sphere name='' radius='1'/>",
        "<sphere radius='1' material=''/>", "<render/><render/>", CAMERA, "<sphere radius='1' radius='1'/>", "<sphere radius='1'name='a'/>",
        "<sphere radius='1' position='1 2'/>", "<sphere radius='1' position='1 2 3 4'/>", "<sphere radius='1 2'/>", "<sphere radius=''/>",
        "<sphere radius='1' position=''/>", "<sphere radius='1' scale=''/>", "<sphere radius='1' scale='1 2'/>", "<sphere radius='1' scale='0'/>",
        "<sphere radius='INF'/>", "<sphere radius='1e999'/>", "<sphere radius='1' position='1e999 0 0'/>", "<sphere radius='0x1p3'/>", "<sphere radius='1d'/>",
        "<sphere radius='1' position='1,2,3'/>", "<sphere radius='1' position='1\u00a02 3 4'/>", "<sphere radius='&#49;'/>", "<sphere radius='1' x='1'/>",
        "<sphere radius='1'>x</sphere>", "<sphere radius='1'></spheres>", "<sphere radius='1'></block>", "<s:sphere xmlns:s='urn:paprsek:scene:1' radius='1'/>",
        "<sphere xmlns='urn:paprsek:scene:1' radius='1'/>", "<sphere xmlns='' radius='1'/>", "<sphere radius='1' name='a<b'/>", "<sphere radius='1' name='a>b'/>",
        "<!-- -- -->", "<!--->", "<!-- --->", "<!-- \u0001 -->", "<!-- \ufffe -->", "<?pi?>", "<![CDATA[ ]]>", "<description>]]></description>",
        "<description><![CDATA[a]]></description>", "<description>a<!-- b -->c</description>", "<description>&nbsp;</description>",
        "<description>&#0;</description>", "<description>&#xD800;</description>", "<description>&#;</description>", "<description>a\rb\r\nc</description>",
        "<description>&#13;&#9;</description>", "<description x='1'/>", "<description>a</description><description>b</description>",
        "<material name='a'><checker size='1'/><checkerboard columns='1' rows='1'/></material>", "<material name='a' color='1 2 3'><checker size='1'/></material>",
        "<background color='Red'/>", "<background color='redd'/>", "<background color='#ff'/>", "<background color='# f f'/>", "<background color='#١٢٣'/>",
        "<background color='red green'/>", "<background color='&#114;ed'/>", "<background color='INF 0 0'/>", "<background color='0 0 red'/>", "<render width='0'/>", "<render width=' 5 '/>", "<render width='+5'/>", "<render width='٥'/>", "<render width='99999999999'/>", "<render samples='17'/>",
        "<render max-depth='251'/>", "<background/>", "<background color='0 0 256'/>", "<ambient color='-1 0 0'/>", "<point-light/>",
        "<point-light position='0 0 0' intensity='-1'/>", "<point-light position='0 0 0' intensity='1e999'/>", "<point-light position='0 0 0' color='1 2'/>",
        "<rectangle min='0 0' max='1 1e999'/>", "<rectangle min='-1e999 0' max='1 1'/>", "<rectangle min='0 0 0' max='1 1 1'/>", "<disc radius='1'><sphere/></disc>",
        "<union><disc radius='1'/></union>", "<cone radius='1' height='1' top-radius='-1'/>", "<cone radius='0' height='1'/>", "<torus major-radius='1' minor-radius='2'/>",
        "<ellipsoid semi-axes='1 0 1'/>", "<block min='0 0 0' max='1 1 0'/>", "<scene/>", "<database/>", "<sphere/>", "<block max='1 1 1'/>", "<plane x=''/>",
        "<camera position='0 5 0' target='0 0 0' up='0 1 0'/>", "<camera position='0 5 0' target='0 0 0' up='0 3 0'/>", "<camera position='0 5 0' target='0 0 0' height='2'/>",
        "<camera position='0 5 0' target='0 0 0' projection='orthographic'/>", "<camera position='0 5 0' target='0 0 0' projection='orthographic' height='2' fovy='3'/>",
        "<camera position='0 5 0' target='0 0 0' projection='fisheye' angle='0'/>", "<camera position='0 5 0' target='0 0 0' projection='panorama'/>",
        "<camera position='0 5 0' target='0 0 0' projection='Fisheye'/>", "<camera position='0 5 0' target='0 0 0' projection=' fisheye'/>",
        "<camera position='0 5 0' target='0 0 0' projection=''/>", "<camera position='0 5 0' direction='0 0 1' aperture='1'/>",
        "<camera name='a' position='0 5 0' target='0 0 0'/><camera name='a' position='0 5 0' target='0 0 0'/>", "<camera name='' position='0 5 0' target='0 0 0'/>",
        "<camera position='0 5 0' target='0 0 0' focus='-1'/>", "<camera position='0 5 0' target='0 0 0' aperture='1e999'/>",
        "<spot-light position='0 1 0'/>", "<spot-light position='0 1 0' target='0 0 0'/>", "<spot-light position='0 1 0' target='0 1 0'/>", "<spot-light position='0 1 0' direction='0 0 0'/>",
        "<spot-light position='0 1 0' target='0 0 0' direction='0 1 0'/>", "<spot-light position='0 1 0' target='0 0 0' inner-angle='46'/>",
        "<spot-light position='0 1 0' target='0 0 0' outer-angle='20'/>", "<spot-light position='0 1 0' target='0 0 0' inner-angle='30' outer-angle='20'/>",
        "<spot-light position='0 1 0' target='0 0 0' inner-angle='50' outer-angle='90'/>", "<spot-light position='0 1 0' target='0 0 0' outer-angle='91'/>",
        "<spot-light position='0 1 0' target='0 0 0' inner-angle='0' outer-angle='0'/>", "<point-light position='0 0 0' reference-distance='0'/>",
        "<point-light position='0 0 0' reference-distance='-1'/>", "<sun-light direction='0 -1 0' angle='1' visible='true'/>", "<sun-light direction='0 0 0'/>", "<sun-light/>",
        "<sun-light direction='0 -1 0' visible='1'/>", "<sun-light direction='0 -1 0' visible=' true '/>", "<sun-light direction='0 -1 0' visible='True'/>", "<sun-light direction='0 -1 0' angle='181'/>",
        "<area-light position='0 0 0' size='1 2'/>", "<area-light position='0 0 0' radius='2' samples='4096'/>", "<area-light position='0 0 0'/>", "<area-light position='0 0 0' radius='1' size='1 1'/>",
        "<area-light position='0 0 0' size='1'/>", "<area-light position='0 0 0' size='1 0'/>", "<area-light position='0 0 0' size='1 1 1'/>", "<area-light position='0 0 0' radius='0'/>",
        "<area-light position='0 0 0' radius='1' samples='0'/>", "<area-light position='0 0 0' radius='1' samples='4097'/>", "<area-light position='0 0 0' radius='1' reference-distance='0'/>",
        "<sphere-light position='0 0 0' radius='1'/>", "<sphere-light position='0 0 0'/>", "<sphere-light position='0 0 0' radius='1'></sphere-light>", "<sphere-light position='0 0 0' radius='1'>x</sphere-light>",
        "<sphere-light position='0 0 0' radius='1'><sphere radius='1'/></sphere-light>", "<sphere-light name='a' position='0 0 0' radius='1'/><sun-light name='a' direction='0 1 0'/>"})
    void bothReadersAgree(String content) throws Exception {
        WayIn.all(scene(content));
        check(bytes(scene(content)));
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "", " ", "<scene/>", "<scene xmlns='urn:paprsek:scene:2'/>", "<scene xmlns='urn:paprsek:scene:1'/>", "<scene xmlns='urn:paprsek:scene:1' xmlns='urn:paprsek:scene:1'/>",
        "<database/>", "<database xmlns='urn:paprsek:scene:1'/>", "<database xmlns='urn:paprsek:scene:1'><scene/></database>", "<sphere/>",
        "<database xmlns='urn:paprsek:scene:1'><sphere radius='1'/></database>", "<database xmlns='urn:paprsek:scene:1'><database/></database>",
        "<database xmlns='urn:paprsek:scene:1'><scene name='a' tags='b c&#9;d'>" + CAMERA + "</scene></database> <!-- end -->\r\n",
        "<database xmlns='urn:paprsek:scene:1'><scene name='a'>" + CAMERA + "</scene><scene name='a'>" + CAMERA + "</scene></database>",
        "<database xmlns='urn:paprsek:scene:1'><scene>" + CAMERA + "</scene></database>", "<database xmlns='urn:paprsek:scene:1'><scene name='a'/></database>",
        "<database xmlns='urn:paprsek:scene:1'><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene></database>",
        "<scene tags='' xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene><scene/>", "<scene tags='' xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>x",
        "<!DOCTYPE scene><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>", "<?xml version='1.0'?><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>",
        "<?xml version=\"1.0\" encoding='utf-8' ?>\n<!-- a -->\n<scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>",
        " <?xml version='1.0'?><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>", "<?xml version='1.1'?><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>",
        "<?xml encoding='UTF-8'?><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>", "<?xml version='1.0\"?><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>",
        "<?xml version='1.0' encoding='ISO-8859-1'?><scene name='é' xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>",
        "<?xml version='1.0' standalone='yes'?><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>",
        "<?xml version='1.0' encoding='UTF-8' standalone=\"no\" ?><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>",
        "<?xml version='1.0' standalone='maybe'?><scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>", "\ufeff", "\ufeff\ufeff<scene/>",
        "\ufeff<scene xmlns='urn:paprsek:scene:1'>" + CAMERA + "</scene>"})
    void bothReadersAgreeOnWholeFiles(String file) throws Exception {
        WayIn.all(file);
        check(bytes(file));
    }

    @Test
    void nestingEndsWhereItDoesForTheThoroughReader() throws Exception {
        for (int levels = SceneFiles.DEEPEST - 3; levels < SceneFiles.DEEPEST + 2; levels++) {
            check(bytes(scene("<union>".repeat(levels) + "<sphere radius='1'/>" + "</union>".repeat(levels))));
            check(bytes(scene("<union>".repeat(levels) + "<sphere radius='1'><material/></sphere>" + "</union>".repeat(levels))));
        }
    }

    @Test
    void textsOfAllLengthsAreReadAlike() throws Exception {
        for (int length : List.of(1, 200, 201, 1000, 65_530, 65_536, 99_999, 100_000, 100_001, 300_000)) {
            check(bytes(scene("<sphere radius='1'/>".repeat(9000) + "<description>" + "é".repeat(length) + "</description>")));
            check(bytes(scene("<sphere radius='1'/>".repeat(9000) + "<description>" + "a".repeat(length) + "</description>")));
            check(bytes(scene("<sphere radius='1' name='" + "a".repeat(length) + "'/>")));
            check(bytes(scene("<sphere radius='" + "0".repeat(length) + "1'/>")));
            check(bytes(scene("<!-- " + "a".repeat(length) + " -->" + " ".repeat(length) + "<sphere" + "\n".repeat(length) + "radius='1'/>")));
        }
    }

    /** Also where the reader's buffer ends in the middle of something. */
    @Test
    void largeFilesAreRead() throws Exception {
        StringBuilder many = new StringBuilder();
        for (int i = 0; i < 30_000; i++) {
            many.append("<sphere name='n").append("a".repeat(i % 17)).append("-").append(i).append("' radius='1'/>\n<!-- ").append(i).append(" -->\n");
        }
        assertThat(check(bytes(scene(many.toString())))).isPresent();
    }

    /** Files with bytes changed, left out or doubled: what the quick reader takes, the thorough one takes, too, and for the same. */
    @Test
    void ofDamagedFilesNoneIsReadOtherwise() throws Exception {
        byte[] good = bytes(SceneFiles.format(RandomScenes.of(7)));
        Random random = new Random(6);
        String interesting = "<>&'\"/=- \n0e.!?[]:x\u0000\r\t";
        int quickly = 0;
        for (int i = 0; i < 1500; i++) {
            ByteArrayOutputStream bad = new ByteArrayOutputStream();
            int at = random.nextInt(good.length);
            bad.write(good, 0, at);
            for (int j = random.nextInt(3); j > 0; j--) {
                bad.write(random.nextInt(4) == 0 ? random.nextInt(256) : interesting.charAt(random.nextInt(interesting.length())));
            }
            int from = Math.min(good.length, at + random.nextInt(3));
            bad.write(good, from, good.length - from);
            quickly += check(bad.toByteArray()).isPresent() ? 1 : 0;
        }
        assertThat(quickly).as("damaged files that are still good").isBetween(150, 1200);
    }

    /** Also where the reader's buffer ends between two, whatever white space there is, and as deep as elements may be. */
    @Test
    void neighboursOfOneMaterialShareIt() throws IOException {
        List<String> materials = List.of("<material color='1 2 3'/>", "<material reflection='0.5'><!-- so --><checker size='2'/></material>", "<material\n  color='3 2\n1' ></material >", "<material/>");
        StringBuilder bodies = new StringBuilder();
        for (int i = 0; i < 12_000; i++) {
            bodies.append("<sphere radius='").append(1 + i % 9).append("'>").append(materials.get(i / 5 % 4)).append("</sphere>\n");
        }
        assertThat(bodies.length()).isGreaterThan(2 << 18);
        List<SceneObject> read = check(bytes(scene(bodies.toString()))).orElseThrow().get(0).objects();
        assertThat(read).hasSize(12_000);
        assertThat(read.get(4).material()).isSameAs(read.get(0).material()).isNotEqualTo(read.get(5).material());
        assertThat(read.get(20).material()).isEqualTo(read.get(0).material());
    }

    @Test
    void aMaterialThatWasReadIsStillTooDeepFurtherIn() throws IOException {
        String material = "<material><checker size='2'/></material>";
        for (int depth = SceneFormat.DEEPEST - 5; depth <= SceneFormat.DEEPEST; depth++) {
            String nest = "<sphere radius='1'>" + material + "</sphere>";
            for (int i = 0; i < depth; i++) {
                nest = "<union>" + (i % 2 == 0 ? material : "") + nest + "<sphere radius='1'/></union>";
            }
            check(bytes(scene(nest)));
        }
    }

    /** What the quick reader makes of a file, having seen that the thorough one makes the same. */
    private static Optional<List<Scene>> check(byte[] file) throws IOException {
        Optional<Contents> quick = QuickReader.read(new ByteArrayInputStream(file)).map(found -> new Contents(found.scenes(), found.isDatabase()));
        if (quick.isPresent()) {
            try {
                assertThat(SceneReader.thoroughly(new ByteArrayInputStream(file), "x")).as(new String(file, StandardCharsets.UTF_8)).isEqualTo(quick.get());
            } catch (SceneFileException refused) {
                throw new AssertionError("read, though " + refused.problems() + "\n" + new String(file, StandardCharsets.UTF_8), refused);
            }
        }
        return quick.map(Contents::scenes);
    }

    private static String scene(String content) {
        return "<scene xmlns='urn:paprsek:scene:1'>" + CAMERA + content + "</scene>";
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

}
