package cz.paprsek.origin;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.ImageFormat;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class OriginsTest {
    private static String digest(int times) {
        Solid nest = new Sphere(1);
        for (int i = 0; i < times; i++) {
            nest = Csg.union(nest, nest);
        }
        Scene scene = Scene.EMPTY.plus(SceneObject.of(nest));
        return Origins.of(scene, RenderOptions.of(scene), Optional.empty(), Optional.empty(), ImageFormat.PNG).toString();
    }

    /** Written as text, one operation alone may be as large as a scene. */
    @Test
    @Timeout(10)
    void aNestOfTooManyIsNotWrittenDownToBeDigested() {
        assertThat(digest(26)).doesNotContain("sha256");
        assertThat(digest(5)).contains("scene sha256");
    }
}
