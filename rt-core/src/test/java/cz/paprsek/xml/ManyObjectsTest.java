package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import cz.paprsek.material.Material;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scenes so long that several threads read them. */
class ManyObjectsTest {
    private static final int COUNT = 100_000;
    private static final String HEAD = "<scene xmlns='urn:paprsek:scene:1'><camera position='0 1 5' direction='0 0 -1'/>";
    private static final String LIGHT = "<point-light position='1 2 3'/>";

    /** Every other of them has operands or a material inside, which look like objects where nothing is indented. */
    private static String object(int i, String gap) {
        String sphere = "<sphere radius='" + (1 + i % 5) + "' position='" + i / 8.0 + " 2 3'";
        return switch (i % 4) {
            case 1 -> sphere + ">" + gap + "<material color='" + i % 250 + " 1 2'/></sphere>";
            case 3 -> "<union>" + gap + sphere + "/>" + gap + "<sphere radius='9'/></union>";
            default -> sphere + "/>";
        };
    }

    private static SceneObject expected(int i) {
        SceneObject sphere = SceneObject.of(new Sphere(1 + i % 5)).at(i / 8.0, 2, 3);
        return switch (i % 4) {
            case 1 -> sphere.madeOf(Material.color(i % 250, 1, 2));
            case 3 -> SceneObject.of(Csg.union(Operand.of(new Sphere(1 + i % 5)).at(i / 8.0, 2, 3), Operand.of(new Sphere(9))));
            default -> sphere;
        };
    }

    private static String text(String gap, String inside, int place, String between) {
        StringBuilder text = new StringBuilder(HEAD);
        for (int i = 0; i < COUNT; i++) {
            text.append(i == place ? between : "").append(gap).append(object(i, inside));
        }
        return text.append("\n</scene>\n").toString();
    }

    /** Nothing between them, so that operands look as objects do; indented, so that they do not; and as if there were some in comments. */
    @ParameterizedTest
    @CsvSource({"'',''", "'\n  ','\n    '", "'\r\n\t<!-- />\r\n\t<sphere -->\r\n\t',' '"})
    void allAreReadInTheirOrder(String gap, String inside) throws Exception {
        List<SceneObject> all = new ArrayList<>();
        for (int i = 0; i < COUNT; i++) {
            all.add(expected(i));
        }
        Scene scene = SceneFiles.parse(text(gap, inside, 70_001, LIGHT + "<!-- />" + (gap + object(0, "")).replace("<!--", "").replace("-->", "").repeat(10) + "\n -->"));
        assertThat(scene.objects().equals(all)).isTrue();
        assertThat(scene.lights()).hasSize(1);
    }

    @Test
    void materialsWrittenAlikeAreOneWhoeverReadsThem() throws Exception {
        StringBuilder text = new StringBuilder(HEAD);
        for (int i = 0; i < COUNT; i++) {
            text.append("<sphere radius='1'><material color='").append(i % 3).append(" 1 2'/></sphere>");
        }
        Set<Object> materials = Collections.newSetFromMap(new IdentityHashMap<>());
        SceneFiles.parse(text.append("</scene>").toString()).objects().forEach(object -> materials.add(object.material()));
        assertThat(materials).hasSize(3);
    }

    /** As long as what is read by one thread. */
    @Test
    void thereMayBeAnyNumberOfBlanksBetweenTwo() throws Exception {
        String text = HEAD + object(0, "").repeat(1 << 14) + " ".repeat(1 << 18) + object(0, "").repeat(COUNT) + "</scene>";
        assertThat(SceneFiles.parse(text).objects()).hasSize((1 << 14) + COUNT);
    }

    @Test
    void whatIsWrongWithALateOneIsToldWithItsLine() {
        assertThatExceptionOfType(SceneFileException.class).isThrownBy(() -> SceneFiles.parse(text("\n  ", "", 90_000, "\n<sphere radius='-1'/>")))
                .satisfies(wrong -> assertThat(wrong.problems()).singleElement().satisfies(problem -> assertThat(problem.line()).isEqualTo(90_002)));
    }
}
