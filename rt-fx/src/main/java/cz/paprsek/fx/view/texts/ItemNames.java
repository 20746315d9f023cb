package cz.paprsek.fx.view.texts;

import cz.paprsek.fx.model.item.Bodies;
import cz.paprsek.fx.model.item.Item;
import cz.paprsek.fx.model.item.Item.BodyAt;
import cz.paprsek.fx.model.item.Item.CameraAt;
import cz.paprsek.fx.model.item.Item.LightAt;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import java.util.Collection;
import java.util.List;

/** What items are called: by their names, or else by what they are. */
public final class ItemNames {
    private ItemNames() {}

    public static String of(Scene scene, Item item, Texts texts) {
        if (item instanceof LightAt light) {
            if (light.index() >= scene.lights().size()) {
                return texts.of("kind.light");
            }
            String name = scene.lights().get(light.index()).name();
            return name.isEmpty() ? texts.kind(scene.lights().get(light.index())) : name;
        }
        if (item instanceof BodyAt body) {
            return Bodies.find(scene, body).map(b -> b.name().isEmpty() ? texts.kind(b.shape()) : b.name()).orElse("");
        }
        List<Camera> cameras = scene.cameras();
        String name = item instanceof CameraAt camera && camera.index() < cameras.size() ? cameras.get(camera.index()).name() : "";
        return name.isEmpty() ? texts.of("item.camera") : name;
    }

    /** The name of the only one, or how many there are; empty for none. */
    public static String of(Scene scene, Collection<? extends Item> items, Texts texts) {
        return switch (items.size()) {
            case 0 -> "";
            case 1 -> of(scene, items.iterator().next(), texts);
            default -> texts.of("item.several", items.size());
        };
    }
}
