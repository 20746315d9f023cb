package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.TreeJson;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.words.Words;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/** Of what is repeated, explanations say which copy it is. */
class ExplainedCopiesTest {
    private static final Words CZECH = Words.in(Locale.forLanguageTag("cs"));

    @Test
    void aToothOfAGearIsACopy() throws Exception {
        Scene gear = SceneFiles.read(Path.of("../scenes/gear.xml"));
        ScenePath tooth = ScenePath.parse(gear, "gear/union#1/teeth/teeth[4]");
        assertThat(Words.ENGLISH.surface(new InScene<>(gear, tooth))).endsWith("cone \"teeth[4]\", copy 5 of 24");
        assertThat(CZECH.surface(new InScene<>(gear, tooth))).endsWith("\"teeth[4]\", kopie 5 z 24");
    }

    @Test
    void theStepThatAPixelShowsIsTold() throws Exception {
        Scene rows = SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1"><render width="30" height="30"/><camera position="4 3 20" target="4 3 0"/>
                <repeat name="row" count="2" index="j" position="0 3 0"><repeat name="ball" count="3" position="4 0 0"><sphere radius="1" position="0 1.5 0"/></repeat></repeat>
                <repeat count="2" position="4 0 0"><sphere radius="1" position="0 -4 0"/></repeat></scene>
                """);
        Pixel pixel = RenderScene.of(rows).explain(15, 12);
        assertThat(lines(pixel, Words.ENGLISH)).anyMatch(line -> line.contains("ball[1][1]\", copy 2 of 2, copy 2 of 3"));
        assertThat(lines(pixel, CZECH)).anyMatch(line -> line.contains("ball[1][1]\", kopie 2 z 2, kopie 2 z 3"));
        assertThat(TreeJson.of(pixel).toString()).contains("\"copies\"");
        assertThat(Words.ENGLISH.surface(new InScene<>(rows, ScenePath.body(6)))).as("without a name only its number").isEqualTo("sphere #7");
    }

    @Test
    void aNameWithBracketsWrittenByHandIsNoCopy() throws Exception {
        Scene scene = SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1"><render width="30" height="30"/><camera position="4 3 20" target="4 3 0"/>
                <repeat name="post" count="3" position="4 0 0"><sphere radius="1"/></repeat>
                <sphere name='lamp[3]' radius="1"/><repeat count="2" position="0 3 0"><block name="lid[1]" min="0 0 0" max="1 1 1"/></repeat></scene>
                """);
        assertThat(Words.ENGLISH.surface(new InScene<>(scene, ScenePath.body(2)))).endsWith("sphere \"post[2]\", copy 3 of 3");
        assertThat(Words.ENGLISH.surface(new InScene<>(scene, ScenePath.body(3)))).endsWith("sphere \"lamp[3]\"");
        assertThat(Words.ENGLISH.surface(new InScene<>(scene, ScenePath.body(5)))).endsWith("block \"lid[1][1]\", copy 2 of 2");
    }

    private static List<String> lines(Pixel pixel, Words words) {
        return TreeText.lines(pixel, 0, Decoration.NONE, words);
    }
}
