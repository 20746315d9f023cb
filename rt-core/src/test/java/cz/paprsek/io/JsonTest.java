package cz.paprsek.io;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Vec3;
import java.util.List;
import org.junit.jupiter.api.Test;

class JsonTest {
    @Test
    void textIsEscapedToAscii() {
        assertThat(new Json().with("\"a\\", "\u001b\u00e9\ud83d\ude00\n").toString())
                .isEqualTo("{\"\\\"a\\\\\":\"\\u001b\\u00e9\\ud83d\\ude00\\u000a\"}");
    }

    @Test
    void numbersAndListsAreWrittenAsJsonHasThem() {
        assertThat(new Json().with("n", 0.1).with("i", Double.POSITIVE_INFINITY).with("l", 3).with("b", true)
                .with("v", new Vec3(1, 2.5, 0)).withTexts("t", List.of("a", "b")).with("o", List.of(new Json())).toString())
                .isEqualTo("{\"n\":0.1,\"i\":null,\"l\":3,\"b\":true,\"v\":[1,2.5,0],\"t\":[\"a\",\"b\"],\"o\":[{}]}");
    }
}
