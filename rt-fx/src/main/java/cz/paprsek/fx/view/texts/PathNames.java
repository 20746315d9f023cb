package cz.paprsek.fx.view.texts;

import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.Collection;
import java.util.List;

/** What items are called: by their names, or else by what they are. */
public final class PathNames {
    private PathNames() {}

    public static String of(Scene scene, ScenePath item, Texts texts) {
        if (item instanceof LightAt light) {
            if (light.index() >= scene.lights().size()) {
                return texts.of("kind.light");
            }
            String name = scene.lights().get(light.index()).name();
            return name.isEmpty() ? texts.kind(scene.lights().get(light.index())) : name;
        }
        if (item instanceof BodyAt body) {
            return body.find(scene).map(b -> b.name().isEmpty() ? texts.kind(b.shape()) : b.name()).orElse("");
        }
        List<Camera> cameras = scene.cameras();
        String name = item instanceof CameraAt camera && camera.index() < cameras.size() ? cameras.get(camera.index()).name() : "";
        return name.isEmpty() ? texts.of("item.camera") : name;
    }

    /** The name of the only one, or how many there are; empty for none. */
    public static String of(Scene scene, Collection<? extends ScenePath> items, Texts texts) {
        return switch (items.size()) {
            case 0 -> "";
            case 1 -> of(scene, items.iterator().next(), texts);
            default -> texts.of("item.several", items.size());
        };
    }
}
