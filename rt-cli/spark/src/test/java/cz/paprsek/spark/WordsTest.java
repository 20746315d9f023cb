package cz.paprsek.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.cli.output.Writing;
import cz.paprsek.cli.process.WrongUsage;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class WordsTest {
    @Test
    void wordsGoToRenderOrToMerge() {
        Words words = Words.of(List.of("scene.xml", "--size", "640x360", "--side=64", "--bits", "16", "-o", "hdfs:///films/a-{frame}.png"));
        assertThat(words).isEqualTo(new Words("hdfs:///films/a-{frame}.png", Optional.of(64), "png", new Writing(Optional.of(16), false), List.of("scene.xml", "--size", "640x360")));
        assertThat(words.order()).containsExactly("scene.xml", "--size", "640x360", "--format", "png");
        assertThat(words.written()).containsExactly("--format", "png", "--bits", "16");
        assertThat(Words.of(List.of("a.xml", "-o", "file:/v.1/film-{frame}", "--format", "exr", "--uncompressed")).written()).containsExactly("--format", "exr", "--uncompressed");
        assertThat(Words.of(List.of("a.xml", "--output=file:/films/", "--format", "exr")).ending()).isEqualTo("exr");
    }

    @Test
    void aCopyOfTheSceneHasItsFilesBesideIt() {
        assertThat(Words.elsewhere(List.of("a.xml", "--assets", "b", "--samples", "2", "--assets=c"), "a.xml", "/tmp/a.xml")).containsExactly("/tmp/a.xml", "--samples", "2");
    }

    @Test
    void wrongWordsAreToldInASentence() {
        assertThatThrownBy(() -> Words.of(List.of("a.xml"))).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("say where the pictures go");
        assertThatThrownBy(() -> Words.of(List.of("a.xml", "-o"))).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("-o wants a value");
        assertThatThrownBy(() -> Words.of(List.of("a.xml", "--side", "x", "-o", "b/"))).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("multiple of 32, not x");
        assertThatThrownBy(() -> Words.of(List.of("a.xml", "-o", "file:/v.1/film-{frame}"))).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("cannot tell the format of 'file:/v.1/film-{frame}'");
        assertThatThrownBy(() -> Words.of(List.of("a.xml", "-o", "b/", "--output=c/"))).isInstanceOf(IllegalArgumentException.class).hasMessage("--output is said twice");
        assertThatThrownBy(() -> Words.of(List.of("a.xml", "-o", "b/", "--bits", "12")).check()).isInstanceOf(WrongUsage.class).hasMessageContaining("not 12");
        assertThatThrownBy(() -> Words.of(List.of("a.xml", "-o", "b/", "--uncompressed")).check()).isInstanceOf(WrongUsage.class).hasMessageContaining("--uncompressed is for exr");
        for (int side : new int[] {33, 0, -5, 2147483616}) {
            assertThatThrownBy(() -> Words.of(List.of("a.xml", "--side", String.valueOf(side), "-o", "b/"))).isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("the side of a tile is a multiple of 32 pixels, from 32 to 65536, not " + side);
        }
    }
}
