package cz.paprsek.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class WordsTest {
    @Test
    void wordsGoToRenderOrToMerge() {
        Words words = Words.of(List.of("scene.xml", "--size", "640x360", "--side=64", "--bits", "16", "-o", "hdfs:///films/a-{frame}.png"));
        assertThat(words).isEqualTo(new Words("hdfs:///films/a-{frame}.png", Optional.of(64), List.of("--bits", "16"), List.of("scene.xml", "--size", "640x360")));
        assertThat(words.order()).containsExactly("scene.xml", "--size", "640x360", "--format", "png");
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
    }
}
