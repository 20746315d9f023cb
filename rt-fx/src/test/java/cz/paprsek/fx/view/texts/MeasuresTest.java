package cz.paprsek.fx.view.texts;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

class MeasuresTest {
    private static final Scene SCENE = Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).named("a").at(3, 0, 0)).plus(SceneObject.of(new Sphere(1)).named("b"))
            .plus(SceneObject.of(new Sphere(1)).named("c").at(2, 2, 0));

    @Test
    void twoThingsAreSomeWayApartAndThreeMakeAnAngleAtTheSecond() {
        assertThat(said(Locale.ENGLISH, 0, 1)).contains("3 apart");
        assertThat(said(Locale.ENGLISH, 0, 1, 2)).endsWith("45° at b");
        assertThat(said(Locale.ENGLISH, 1, 0, 2)).endsWith("63.43° at a");
        assertThat(said(Locale.forLanguageTag("cs"), 1, 0, 2)).endsWith("63,43° u a");
    }

    private static String said(Locale locale, Integer... bodies) {
        return Measures.of(EditorState.of(SCENE).withSelection(new LinkedHashSet<>(List.of(bodies).stream().map(ScenePath::body).toList())), Texts.in(locale));
    }
}
