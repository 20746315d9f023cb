package cz.paprsek.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ReadyMaterialsTest {
    private static final String SCENE = "<scene xmlns=\"urn:paprsek:scene:1\"><camera position=\"0 0 5\" direction=\"0 0 -1\"/>%s<sphere radius=\"1\" material=\"%s\"/></scene>";

    static Stream<String> names() {
        return Material.ready().keySet().stream();
    }

    @Test
    void thereAreManyAndNobodyCanChangeThem() {
        assertThat(Material.ready()).hasSizeGreaterThanOrEqualTo(24);
        assertThatThrownBy(() -> Material.ready().put("mine", Material.DEFAULT)).isInstanceOf(UnsupportedOperationException.class);
    }

    @ParameterizedTest
    @MethodSource("names")
    void eachIsKnownByNameGivesBackNoMoreThanItGetsAndIsTold(String name) throws Exception {
        Scene scene = SceneFiles.parse(SCENE.formatted("", name));
        Material material = Optional.ofNullable(Material.ready().get(name)).orElseThrow();
        assertThat(scene.objects().get(0).material()).isEqualTo(new MaterialName(name));
        double back = material.fresnel() == Fresnel.TRUE ? Math.max(material.reflection(), material.transparency()) : material.reflection() + material.transparency();
        assertThat(material.diffusion() + back).isLessThanOrEqualTo(1);
        assertThat(SceneFiles.format(scene)).contains("material=\"" + name + "\"").doesNotContain("<material");
        StringBuilder pov = new StringBuilder();
        PovFiles.write(scene, pov);
        StringBuilder same = new StringBuilder();
        PovFiles.write(scene.withObjects(scene.objects().stream().map(object -> object.madeOf(material)).toList()), same);
        assertThat(pov.toString()).as("POV-Ray is given the material").isEqualTo(same.toString());
        assertThat(Files.readString(Path.of("../docs/materials.md"))).contains("`" + name + "`");
    }

    @Test
    void aScenesOwnOfThatNameCounts() throws Exception {
        Scene own = SceneFiles.parse(SCENE.formatted("<material name=\"gold\" color=\"0 0 255\" diffusion=\"1\"/>", "gold"));
        Scene lit = own.plus(Light.at(0, 0, 5)).withSettings(new RenderSettings(9, 9, 2, 1));
        Image image = Renderer.render(lit);
        assertThat(image.red(4, 4)).isZero();
        assertThat(image.blue(4, 4)).isGreaterThan(0.9f);
    }

    @Test
    void whatIsNearlyItsNameIsSuggested() {
        assertThatThrownBy(() -> SceneFiles.parse(SCENE.formatted("", "marbel"))).isInstanceOf(SceneFileException.class)
                .hasMessageContaining("there is no material named \"marbel\"; did you mean \"marble\"?");
        assertThatThrownBy(() -> Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).madeOf("golt"))).hasMessageContaining("did you mean \"gold\"?");
    }
}
