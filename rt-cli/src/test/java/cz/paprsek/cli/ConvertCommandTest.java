package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.Layers;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ConvertCommandTest {
    @TempDir
    Path folder;

    @Test
    void aSceneIsWrittenForPovRay() throws IOException {
        Path target = folder.resolve("ball.pov");
        Run run = Run.cli("convert", Scenes.ball(folder.resolve("ball.xml")), target);
        assertThat(run).isEqualTo(new Run(0, "", "", run.written()));
        assertThat(target).content().contains("#version 3.7;", "sphere { <0, 0, 0>, 1 texture { ", " translate <0, 1, 0> }");
    }

    @Test
    void whatIsNotExactIsAWarning() throws IOException {
        Path scene = Scenes.scene(folder.resolve("glass.xml"), "<sphere radius='1'><material transparency='0.5' refractive-index='1.5'/></sphere>");
        Run run = Run.cli("convert", scene, folder.resolve("glass.pov"));
        assertThat(run.code()).isZero();
        assertThat(run.err()).startsWith(scene + ": warning: object #1: where light is totally reflected").hasLineCount(1);
        assertThat(Run.cli("convert", scene, folder.resolve("glass.pov"), "-q").err()).isEmpty();
    }

    @Test
    void aSceneIsTidiedUp() throws Exception {
        Path scene = Scenes.ball(folder.resolve("ball.xml"));
        assertThat(Run.cli("convert", scene, folder.resolve("tidy.xml")).code()).isZero();
        assertThat(folder.resolve("tidy.xml")).content().isEqualTo(SceneFiles.format(SceneFiles.read(scene)));
    }

    /** As a render writes the same light: an HDR picture is there to be looked at in the end. */
    @Test
    void aPictureBecomesOneOfAnotherFormat() throws IOException {
        Path scene = Scenes.ball(folder.resolve("ball.xml"));
        Path light = folder.resolve("light.exr");
        assertThat(Run.cli("render", scene, "-o", light, "--bits", "32", "-q").code()).isZero();
        Path converted = folder.resolve("converted.png");
        assertThat(Run.cli("convert", light, converted, "--exposure", "1.5", "--tone", "filmic", "--bits", "16")).matches(run -> run.code() == 0 && run.text().isEmpty() && run.err().isEmpty());
        Path rendered = folder.resolve("rendered.png");
        Run.cli("render", scene, "-o", rendered, "--exposure", "1.5", "--tone", "filmic", "--bits", "16", "-q");
        assertThat(Run.cli("compare", converted, rendered, "--tolerance", "0").code()).isZero();
        assertThat(Run.cli("convert", light, folder.resolve("light.hdr")).code()).isZero();
        assertThat(Run.cli("convert", folder.resolve("light.hdr"), folder.resolve("light.jpg")).code()).isZero();
    }

    @Test
    void whatIsNoPictureAndWhatCannotBeOneIsToldInOneLine() throws IOException {
        Path scene = Scenes.ball(folder.resolve("ball.xml"));
        Path light = folder.resolve("light.exr");
        Run.cli("render", scene, "-o", light, "-q");
        record Wrong(List<Object> words, int code, String sentence) {}

        for (Wrong wrong : List.of(
                new Wrong(List.of(folder.resolve("none.png"), folder.resolve("a.png")), 3, folder.resolve("none.png") + ": no such file\n"),
                new Wrong(List.of(scene, folder.resolve("a.png")), 2, "a scene becomes a picture where it is rendered: paprsek render " + scene + " -o " + folder.resolve("a.png")),
                new Wrong(List.of(light, folder.resolve("a.xml")), 2, light + " is a picture; let the new file end in one of png, jpg"),
                new Wrong(List.of(Files.writeString(folder.resolve("c.webp"), "RIFF"), folder.resolve("a.png")), 3, "c.webp: this is not a picture of a kind that can be read"),
                new Wrong(List.of(light, light), 2, "would overwrite the picture"),
                new Wrong(List.of(light, folder.resolve("a.png"), "--bits", "32"), 2, "png has 8 or 16 bits per channel, not 32"),
                new Wrong(List.of(light, folder.resolve("a.png"), "--exposure", "1000"), 2, "from -100 to 100"),
                new Wrong(List.of(Files.writeString(folder.resolve("b.exr"), "no"), folder.resolve("a.png")), 3, "b.exr: this is not a picture"),
                new Wrong(List.of(scene, folder.resolve("a.pov"), "--exposure", "1"), 2, "are for pictures, which " + scene + " is not"))) {
            List<Object> words = new ArrayList<>(List.of("convert"));
            words.addAll(wrong.words());
            Run run = Run.cli(words.toArray());
            assertThat(run.code()).as(run.err()).isEqualTo(wrong.code());
            assertThat(run.err()).contains(wrong.sentence());
        }
        assertThat(folder.resolve("a.png")).doesNotExist();
    }

    /** Light adds up: what is mixed afterwards is what would have been rendered. */
    @ParameterizedTest
    @ValueSource(strings = {"whitted", "path"})
    void lightsAreMixedWithoutBeingRenderedAgain(String integrator) throws IOException {
        Path lights = folder.resolve("lights.exr");
        Run.cli("render", lit("lit.xml", "0.5", "255 255 255", "0.25"), "-o", lights, "--aov", "light", "--bits", "32", "--integrator", integrator, "-q");
        Path plain = folder.resolve("plain.exr");
        assertThat(Run.cli("convert", lights, plain, "--bits", "32").code()).isZero();
        Path whole = folder.resolve("whole.exr");
        assertThat(Run.cli("convert", lights, whole, "--bits", "32", "--mix", "key=1", "--mix", "fill lamp=1,1,1", "--mix", "rest=1")).matches(run -> run.code() == 0 && run.text().isEmpty() && run.err().isEmpty());
        assertThat(ImageFiles.read(whole).toLinear()).isEqualTo(ImageFiles.read(plain).toLinear());
        assertThat(ImageFiles.readLayers(whole).names()).isEqualTo(ImageFiles.readLayers(lights).names());

        Path mixed = folder.resolve("mixed.exr");
        assertThat(Run.cli("convert", lights, mixed, "--bits", "32", "--mix", "key=2,0,1", "--mix", "fill lamp=0").code()).isZero();
        Path rendered = folder.resolve("rendered.exr");
        Run.cli("render", lit("other.xml", "1", "255 0 187.516", "0"), "-o", rendered, "--bits", "32", "--integrator", integrator, "-q");
        assertThat(Run.cli("compare", mixed, rendered, "--tolerance", "0.5")).satisfies(run -> assertThat(run.code()).as(run.out()).isZero());
        assertThat(Run.cli("compare", mixed, plain, "--tolerance", "0.5").code()).isOne();
    }

    /** Also of pictures that are exposed and toned: as rendered with such lights. What is mixed can be mixed again; what would be of other light is left away, with a word. */
    @Test
    void layersOfAMixAreKeptAsFarAsTheyHold() throws IOException {
        List<Object> how = List.of("--bits", "32", "--integrator", "path", "--size", "24x18", "--exposure", "0.7", "--tone", "filmic");
        Path lights = folder.resolve("lights.exr");
        rendered(lit("lit.xml", "0.5", "255 255 255", "0.25"), lights, how, "--aov", "light,normal,direct,error,object");
        Path mixed = folder.resolve("mixed.exr");
        Run run = Run.cli("convert", lights, mixed, "--bits", "32", "--mix", "key=2");
        assertThat(run.err()).isEqualTo(lights + ": warning: direct, error left away, which would not be of the lights as they are mixed\n");
        assertThat(Run.cli("convert", lights, folder.resolve("quiet.exr"), "-q", "--mix", "key=2").err()).isEmpty();
        assertThat(ImageFiles.readLayers(mixed).names()).contains("normal.X", "object.ID", "light.key.R").noneMatch(name -> name.startsWith("direct") || name.startsWith("error"));
        assertThat(ImageFiles.readLayers(mixed).written().origin().settings()).contains("--aov").doesNotContain("--exposure").endsWith("; lights mixed afterwards: key × 2 2 2");
        Path like = folder.resolve("like.exr");
        rendered(lit("other.xml", "1", "255 255 255", "0.25"), like, how);
        assertThat(Run.cli("compare", mixed, like, "--tolerance", "0.1")).satisfies(same -> assertThat(same.code()).as(same.out()).isZero());
        Path back = folder.resolve("back.exr");
        assertThat(Run.cli("convert", mixed, back, "--bits", "32", "--mix", "key=0.5")).matches(again -> again.code() == 0 && again.err().isEmpty());
        assertThat(Run.cli("compare", back, lights, "--tolerance", "0.1").code()).isZero();
        Path otherwise = folder.resolve("otherwise.exr");
        Run.cli("convert", mixed, otherwise, "--bits", "32", "--mix", "key=1", "--exposure", "0", "--tone", "none");
        rendered(lit("plain.xml", "1", "255 255 255", "0.25"), like, List.of("--bits", "32", "--integrator", "path", "--size", "24x18"));
        assertThat(Run.cli("compare", otherwise, like, "--tolerance", "0.1").code()).isZero();
        Path png = folder.resolve("mixed.png");
        assertThat(Run.cli("convert", lights, png, "--mix", "key=2").err()).isEmpty();
        assertThat(Files.readString(png, StandardCharsets.ISO_8859_1)).contains("lights mixed afterwards: key");
    }

    private static void rendered(Path scene, Path picture, List<Object> how, Object... further) {
        List<Object> words = new ArrayList<>(List.of("render", scene, "-o", picture, "-q"));
        words.addAll(how);
        words.addAll(List.of(further));
        assertThat(Run.cli(words.toArray()).code()).isZero();
    }

    private Path lit(String name, String key, String color, String fill) throws IOException {
        return Scenes.scene(folder.resolve(name), "<background color='20 40 60'/><point-light name='key' position='2 4 3' color='" + color + "' intensity='" + key
                + "'/><point-light name='fill lamp' position='-3 2 2' intensity='" + fill + "'/><sphere radius='1'/>");
    }

    @Test
    void whatCannotBeMixedIsToldInOneLine() throws IOException {
        Path scene = lit("lit.xml", "0.5", "255 255 255", "0.25");
        Path lights = folder.resolve("lights.exr");
        Path plain = folder.resolve("plain.exr");
        Run.cli("render", scene, "-o", lights, "--aov", "light", "-q");
        Run.cli("render", scene, "-o", plain, "-q");
        Path target = folder.resolve("a.png");
        Path named = Files.copy(lights, folder.resolve("lights.png"));
        Path redOnly = planes("red.exr", "R", "G", "B", "light.R", "light.sun.R");
        record Wrong(Path picture, String mix, String sentence) {}

        for (Wrong wrong : List.of(
                new Wrong(lights, "kay=1", lights + " has no layer of a light 'kay', but of fill lamp, key, rest; did you mean \"key\"?"),
                new Wrong(lights, "key=-1", "--mix key: expected a share from 0 such as 0.5, or three such as 1,0.8,0.5 for red, green and blue, but found '-1'"),
                new Wrong(lights, "key=1,2", "but found '1,2'"), new Wrong(lights, "key=bright", "but found 'bright'"), new Wrong(lights, "key=NaN", "but found 'NaN'"),
                new Wrong(lights, "key=", "but found ''"), new Wrong(lights, "key", "--mix"),
                new Wrong(named, "kay=1", named + " has no layer of a light 'kay', but of fill lamp, key, rest"),
                new Wrong(redOnly, "sun=2", redOnly + " has no layers of lights that could be mixed"),
                new Wrong(plain, "key=1", plain + " has no layers of lights that could be mixed; paprsek render --aov light -o FILE.exr makes them"),
                new Wrong(scene, "key=1", "a scene becomes a picture where it is rendered"))) {
            Run run = Run.cli("convert", wrong.picture(), target, "--mix", wrong.mix());
            assertThat(run.code()).as(run.err()).isEqualTo(2);
            assertThat(run.err()).contains(wrong.sentence());
        }
        Path noGreen = planes("no-green.exr", "R", "light.sun.R", "light.sun.G", "light.sun.B");
        assertThat(Run.cli("convert", noGreen, target, "--mix", "sun=2")).matches(run -> run.code() == Run.cli("convert", noGreen, target).code()).extracting(Run::err).asString()
                .isEqualToIgnoringNewLines(noGreen + ": there is no plane named G among R, light.sun.B, light.sun.G, light.sun.R");
        assertThat(Run.cli("convert", lights, target, "--mix", "key=0", "--mix", "rest=1", "--mix", "key=2").err()).startsWith("paprsek: --mix key is given twice, and it is not told which is meant\n");
        assertThat(Run.cli("convert", scene, folder.resolve("a.xml"), "--mix", "key=1").err()).contains("--tone and --mix are for pictures, which");
        assertThat(target).doesNotExist();
    }

    private Path planes(String name, String... planes) throws IOException {
        Layers layers = Layers.ofSize(2, 2);
        for (String plane : planes) {
            layers = layers.with(plane, new float[4]);
        }
        Path file = folder.resolve(name);
        ImageFiles.write(layers, file, ImageOptions.DEFAULT);
        return file;
    }

    @Test
    void mistakesAreAnsweredInOneLine() throws IOException {
        Path scene = Scenes.ball(folder.resolve("ball.xml"));
        Run unknown = Run.cli("convert", scene, folder.resolve("ball.pog"));
        assertThat(unknown.code()).isEqualTo(2);
        assertThat(unknown.err()).contains("let it end in .pov, .xml, .obj or .stl; did you mean \"pov\"?");
        Run itself = Run.cli("convert", scene, scene);
        assertThat(itself.code()).isEqualTo(2);
        assertThat(itself.err()).contains("would overwrite the scene");
        Run broken = Run.cli("convert", Scenes.broken(folder.resolve("broken.xml")), folder.resolve("b.pov"));
        assertThat(broken.code()).isEqualTo(3);
        assertThat(broken.err()).contains("did you mean \"radius\"?");
        Files.writeString(folder.resolve("two.xml"), SceneFiles.formatAll(List.of(Scene.EMPTY.withName("a"), Scene.EMPTY.withName("b"))));
        assertThat(Run.cli("convert", folder.resolve("two.xml"), folder.resolve("b.pov")).err()).contains("is a database of 2 scenes");
        assertThat(folder.resolve("b.pov")).doesNotExist();
    }
}
