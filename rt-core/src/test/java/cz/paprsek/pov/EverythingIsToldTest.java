package cz.paprsek.pov;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import cz.paprsek.xml.mistake.Grammar;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * POV-Ray is told of whatever a scene file can say, or a sentence says that it is not. Goes over all of the schema, which is made from what stands at the
 * records: an attribute that comes later is tried as well.
 */
class EverythingIsToldTest {
    private static final Grammar GRAMMAR = Grammar.ofScenes();

    /** What has no bearing on a picture there, by the end of its path, and why. */
    private static final Map<String, String> OF_NO_BEARING = Map.ofEntries(
            Map.entry("scene/description@text", "free text for people"),
            Map.entry("scene@tags", "words to find the scene by"),
            Map.entry("camera@name", "for people: there is one camera"),
            Map.entry("rectangle/material@refractive-index", "what has no inside bends nothing, and this one does not mirror by the angle"),
            Map.entry("rectangle/material@attenuation-color", "what has no inside absorbs nothing"),
            Map.entry("rectangle/material@attenuation-distance", "likewise"),
            Map.entry("disc/material@refractive-index", "as of a rectangle"),
            Map.entry("disc/material@attenuation-color", "as of a rectangle"),
            Map.entry("disc/material@attenuation-distance", "as of a rectangle"),
            Map.entry("render@fps", "which pictures of a film there are; each is told by itself"),
            Map.entry("@pivot", "for hands: about what a body is turned in the editor"));

    /** What an element has besides, so that all of its attributes count: that of an attribute if it needs more, else that of the element. */
    private static final Map<String, String> GIVEN = Map.ofEntries(
            Map.entry("render", "samples='2..8'"),
            Map.entry("render@samples", "samples='2'"),
            Map.entry("background", "color='red'"),
            Map.entry("ambient", "color='red'"),
            Map.entry("sky@rotation", "file='sky.hdr'"),
            Map.entry("sky@intensity", "file='sky.hdr'"),
            Map.entry("camera", "position='0 0 5' target='0 0 0' aperture='0.1' focus='3'"),
            Map.entry("camera@projection", "position='0 0 5' target='0 0 0'"),
            Map.entry("camera@height", "position='0 0 5' target='0 0 0' projection='orthographic' height='2'"),
            Map.entry("camera@angle", "position='0 0 5' target='0 0 0' projection='fisheye'"),
            Map.entry("point-light", "position='0 5 5'"),
            Map.entry("spot-light", "position='0 5 5' target='0 0 0'"),
            Map.entry("sun-light", "direction='0 -1 0' angle='5' visible='true'"),
            Map.entry("area-light", "position='0 5 5' size='1 1'"),
            Map.entry("sphere-light", "position='0 5 5' radius='1'"),
            Map.entry("material", "specular='0.5' transparency='0.5' refractive-index='1.5' reflection='0.5' attenuation-color='90 90 90' emission='90 90 90'"),
            Map.entry("checkerboard", "columns='4' rows='4'"),
            Map.entry("checker", "size='1'"),
            Map.entry("stripes", "size='1'"),
            Map.entry("brick", "size='1 1 1'"),
            Map.entry("image", "file='a.png' filter='bilinear' mapping='planar'"),
            Map.entry("normal-map", "file='a.png'"),
            Map.entry("stop", "at='0.25' color='red'"),
            Map.entry("sphere", "radius='1'"),
            Map.entry("block", "min='-1 -1 -1' max='1 1 1'"),
            Map.entry("ellipsoid", "semi-axes='1 1 1'"),
            Map.entry("cylinder", "radius='1' height='1'"),
            Map.entry("cone", "radius='1' height='1'"),
            Map.entry("capsule", "radius='1' height='1'"),
            Map.entry("prism", "sides='7' radius='1' height='1'"),
            Map.entry("superellipsoid", "semi-axes='1 1 1'"),
            Map.entry("extrude", "height='1' points='0 0 1 0 0 1'"),
            Map.entry("lathe", "points='0 0 1 0 0 1'"),
            Map.entry("text", "value='Ab'"),
            Map.entry("isosurface", "expression='x^2 + y^2 + z^2 - 0.25'"),
            Map.entry("height-field", "file='hill.pgm'"),
            Map.entry("torus", "major-radius='1' minor-radius='0.25'"),
            Map.entry("mesh", "file='two.obj'"),
            Map.entry("mesh@weld", "file='loose.obj'"),
            Map.entry("rectangle", "min='-1 -1' max='1 1'"),
            Map.entry("disc", "radius='1'"));

    private static final String TWO_BALLS = "<sphere radius='1'/><sphere radius='2'/>";
    private static final String COLORED = "<noise even='200 100 50'/>";
    private static final String SCHEMA = SceneFiles.schema();

    /** Instead of which attributes others are given. */
    private static final Map<String, String> INSTEAD = Map.of("direction", "target", "radius", "size", "path", "points");

    /** What stands in an element if nothing else does. */
    private static final Map<String, String> INSIDE = Map.of("union", TWO_BALLS, "difference", TWO_BALLS, "intersection", TWO_BALLS,
            "bump", COLORED, "diffusion", COLORED, "specular", COLORED, "reflection", COLORED, "transparency", COLORED, "roughness", COLORED);

    /** Other values by the attribute, or else by their type. */
    private static final Map<String, List<String>> VALUES = Map.ofEntries(
            Map.entry("@material", List.of("other")),
            Map.entry("camera@projection", List.of("spherical", "fisheye")),
            Map.entry("height-field@file", List.of("dale.pgm")),
            Map.entry("mesh@file", List.of("one.obj")),
            Map.entry("mesh@part", List.of("one")),
            Map.entry("mesh@smooth-angle", List.of("150")),
            Map.entry("mesh@weld", List.of("0")),
            Map.entry("number", List.of("0.75")),
            Map.entry("positive", List.of("0.75")),
            Map.entry("notNegative", List.of("0.75")),
            Map.entry("share", List.of("0.75")),
            Map.entry("sides", List.of("5")),
            Map.entry("sidesOrNone", List.of("5")),
            Map.entry("roundness", List.of("0.75")),
            Map.entry("twist", List.of("15")),
            Map.entry("turn", List.of("90")),
            Map.entry("letters", List.of("Xy")),
            Map.entry("font", List.of("serif")),
            Map.entry("expression", List.of("x^2 + y^2 + z^2 - 0.75")),
            Map.entry("path", List.of("M0 0L1 0L0 3Z")),
            Map.entry("points", List.of("0 0 1 0 0 2")),
            Map.entry("exponent", List.of("7")),
            Map.entry("refractiveIndex", List.of("1.75")),
            Map.entry("fovy", List.of("33")),
            Map.entry("fisheye", List.of("99")),
            Map.entry("coneAngle", List.of("20")),
            Map.entry("discAngle", List.of("7")),
            Map.entry("vector", List.of("0.25 0.5 0.75")),
            Map.entry("positiveVector", List.of("0.25 0.5 0.75")),
            Map.entry("pair", List.of("0.5 0.25")),
            Map.entry("positivePair", List.of("0.5 0.25")),
            Map.entry("scale", List.of("0.5", "0.25 0.5 0.75")),
            Map.entry("positiveScale", List.of("0.5", "0.25 0.5 0.75")),
            Map.entry("color", List.of("1 2 3")),
            Map.entry("squares", List.of("3")),
            Map.entry("octaves", List.of("3")),
            Map.entry("seed", List.of("7")),
            Map.entry("pixels", List.of("77")),
            Map.entry("depth", List.of("3")),
            Map.entry("samples", List.of("3", "3..7")),
            Map.entry("stops", List.of("1")),
            Map.entry("confidence", List.of("0.5")),
            Map.entry("lightSamples", List.of("9")),
            Map.entry("frameRate", List.of("30")),
            Map.entry("file", List.of("b.png")),
            Map.entry("name", List.of("another")),
            Map.entry("text", List.of("another")),
            Map.entry("tags", List.of("another")),
            Map.entry("flag", List.of("true", "false")));

    /** Closed only if two corners that nearly meet are welded. */
    private static final String LOOSE = "v 0 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 0\nv 1.0000001 0 0\nf 1 3 2\nf 1 4 3\nf 1 2 4\nf 2 3 5\n";

    private static final Assets FILES = Assets.of(Map.of("two.obj", tetrahedra("one", "two"), "one.obj", tetrahedra("one"), "loose.obj", LOOSE.getBytes(StandardCharsets.US_ASCII),
            "hill.pgm", "P5 2 2 255\n0zz0".getBytes(StandardCharsets.US_ASCII), "dale.pgm", "P5 2 2 255\nz00z".getBytes(StandardCharsets.US_ASCII)));

    /** What a file of so many parts holds, each beside the last. */
    private static byte[] tetrahedra(String... names) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < names.length; i++) {
            text.append("g ").append(names[i]).append('\n');
            for (String corner : List.of("0 0", "1 0", "0 1")) {
                text.append("v ").append(2 * i).append(' ').append(corner).append('\n');
            }
            text.append("v ").append(2 * i + 1).append(" 0 0\nf -4 -2 -3\nf -4 -1 -2\nf -4 -3 -1\nf -3 -2 -1\n");
        }
        return text.toString().getBytes(StandardCharsets.US_ASCII);
    }

    /** What is written and said of a scene, or why nothing is. */
    private record Export(String text, List<String> sentences) {
        static Export of(Scene scene) throws Exception {
            try {
                StringBuilder text = new StringBuilder();
                List<String> sentences = PovFiles.write(MeshFiles.read(scene, FILES), text);
                return new Export(text.toString(), sentences);
            } catch (IllegalArgumentException | IOException refused) {
                return new Export("", List.of(String.valueOf(refused.getMessage())));
            }
        }

        boolean names(String word) {
            Pattern alone = Pattern.compile("(?<![a-z-])" + word + "(?![a-z-])");
            return sentences.stream().anyMatch(sentence -> alone.matcher(sentence).find());
        }
    }

    /** Every element in every other that may have it, but shapes within operations within others, and within materials those of one. */
    static List<List<String>> elements() {
        List<List<String>> paths = new ArrayList<>();
        collect(List.of("scene"), paths, new HashSet<>());
        return paths;
    }

    private static void collect(List<String> path, List<List<String>> paths, Set<String> seen) {
        paths.add(path);
        String type = GRAMMAR.type(path);
        for (String child : GRAMMAR.children(type).keySet()) {
            // What moves is told picture by picture, each of a scene in which nothing does.
            if (!child.equals("animate") && seen.add(type + "/" + child)) {
                collect(Stream.concat(path.stream(), Stream.of(child)).toList(), paths, seen);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("elements")
    void noAttributeIsLostWithoutAWord(List<String> path) throws Exception {
        List<String> lost = new ArrayList<>();
        String element = path.get(path.size() - 1);
        for (Map.Entry<String, String> attribute : attributes(path).entrySet()) {
            String place = String.join("/", path) + "@" + attribute.getKey();
            Scene plain = scene(path, attribute.getKey(), "");
            Export before = Export.of(plain);
            boolean isTried = false;
            for (String value : values(element, attribute.getKey(), attribute.getValue())) {
                Scene other = scene(path, attribute.getKey(), value);
                Export after = Export.of(other);
                boolean isOther = !other.equals(plain);
                isTried |= isOther;
                if (isOther && after.equals(before) && path.stream().dropWhile(one -> !one.equals("material")).skip(1).noneMatch(after::names) && !after.names(attribute.getKey())
                        && OF_NO_BEARING.keySet().stream().noneMatch(place::endsWith)) {
                    lost.add(place + "=" + value);
                }
            }
            assertThat(isTried).as("another value for " + place).isTrue();
        }
        assertThat(lost).isEmpty();
    }

    @Test
    void ofWhatMovesASentenceSaysHowToTell() throws Exception {
        Scene moving = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 5' target='0 0 0'/><sphere name='ball' radius='1'/>"
                + "<animate target='ball' attribute='radius'><key t='0' value='2'/></animate></scene>");
        assertThat(Export.of(moving).sentences()).anyMatch(sentence -> sentence.contains("--frame"));
        assertThat(Export.of(moving.withObjects(List.of(moving.objects().get(0).hidden(true)))).sentences()).as("hidden").anyMatch(sentence -> sentence.contains("--frame"));
        assertThat(Export.of(moving.at(0))).isEqualTo(Export.of(SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 5' target='0 0 0'/><sphere name='ball' radius='2'/></scene>")));
    }

    @Test
    void whatIsOfNoBearingIsThere() {
        Set<String> all = new HashSet<>();
        elements().forEach(path -> attributes(path).keySet().forEach(attribute -> all.add(String.join("/", path) + "@" + attribute)));
        assertThat(all).hasSizeGreaterThan(500);
        assertThat(OF_NO_BEARING.keySet()).allSatisfy(end -> assertThat(all).anyMatch(place -> place.endsWith(end)));
    }

    /** Those of the schema, or the text that is all there is. */
    private static Map<String, String> attributes(List<String> path) {
        return path.get(path.size() - 1).equals("description") ? Map.of("text", "text") : GRAMMAR.attributes(GRAMMAR.type(path));
    }

    private static List<String> values(String element, String attribute, String type) {
        List<String> all = VALUES.getOrDefault(element + "@" + attribute, VALUES.getOrDefault("@" + attribute, VALUES.getOrDefault(type, words(type))));
        assertThat(all).as("values of the type " + type).isNotEmpty();
        return all;
    }

    /** Of a type that has such. */
    private static List<String> words(String type) {
        return Pattern.compile("<xs:simpleType name=\"" + type + "\">.*?</xs:simpleType>", Pattern.DOTALL).matcher(SCHEMA).results()
                .flatMap(one -> Pattern.compile("enumeration value=\"([^\"]+)\"").matcher(one.group()).results()).map(one -> one.group(1)).toList();
    }

    /** A scene that has such an element, with such an attribute; without it if there is no value. */
    private static Scene scene(List<String> path, String attribute, String value) throws Exception {
        String inside = "";
        for (int i = path.size() - 1; i > 0; i--) {
            String element = path.get(i);
            boolean isLast = i == path.size() - 1;
            inside = element(element, isLast ? attribute : "", isLast ? value : "", inside + (isLast ? INSIDE.getOrDefault(element, "") : beside(element, path.get(i + 1))), i == 1);
        }
        boolean isScene = path.size() == 1;
        boolean isNamed = path.size() > 1 && path.get(1).equals("material");
        String name = isNamed && path.size() == 2 && attribute.equals("name") && !value.isEmpty() ? value : "own";
        String text = "<scene xmlns='" + SceneFiles.NAMESPACE + "'" + (isScene && !value.isEmpty() ? " " + attribute + "='" + value + "'" : "") + ">"
                + inside + (path.contains("camera") ? "" : "<camera position='0 0 5' target='0 0 0'/>")
                + "<material name='other' color='blue'/><" + (path.contains("checkerboard") ? "rectangle min='-1 -1' max='1 1'" : "sphere radius='1'") + " material='" + name + "'/>"
                + (isNamed ? "" : "<material name='own'/>") + "</scene>";
        return SceneFiles.parse(text);
    }

    /** What an element needs besides the one that is tried. */
    private static String beside(String element, String child) {
        return child.equals("stop") ? "<stop at='1' color='blue'/>" : Set.of("union", "difference", "intersection").contains(element) && !child.equals("material")
                ? "<sphere radius='3'/>" : child.equals("material") ? INSIDE.getOrDefault(element, "") : "";
    }

    private static String element(String name, String attribute, String value, String inside, boolean isTop) {
        if (name.equals("description")) {
            return "<description>" + value + "</description>";
        }
        String given = GIVEN.getOrDefault(name + "@" + attribute, GIVEN.getOrDefault(name, ""));
        StringBuilder text = new StringBuilder("<" + name);
        if (name.equals("material") && isTop && !(attribute.equals("name") && !value.isEmpty())) {
            text.append(" name='own'");
        }
        for (String one : given.isEmpty() ? new String[0] : given.split("(?<=') ")) {
            String its = one.substring(0, one.indexOf('='));
            // Not said twice.
            if ((value.isEmpty() || !Set.of(attribute, INSTEAD.getOrDefault(attribute, "")).contains(its)) && !inside.startsWith("<" + its + ">") && !inside.startsWith("<" + its + " ")) {
                text.append(' ').append(one);
            }
        }
        if (!value.isEmpty()) {
            text.append(' ').append(attribute).append("='").append(value).append('\'');
        }
        return text + ">" + inside + "</" + name + ">";
    }
}
