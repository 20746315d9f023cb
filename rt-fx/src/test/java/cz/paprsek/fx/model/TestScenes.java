package cz.paprsek.fx.model;

import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;

public final class TestScenes {
    public static final Material RED = Material.color(255, 0, 0);
    public static final Material BLUE = Material.color(0, 0, 255);

    private TestScenes() {}

    /** 0 ball · 1 bowl = (0 outer − (0 hole ∪ 1 notch)), turned a quarter about y and moved · 2 floor · 3 ball 2; lights key and fill. */
    public static Scene kitchen() {
        Csg cut = Csg.union(Operand.of(new Sphere(0.5)).named("hole").at(0, 0.5, 0), Operand.of(new Sphere(0.2)).named("notch").at(1, 0, 0));
        Csg bowl = Csg.difference(Operand.of(new Sphere(1)).named("outer"), Operand.of(cut).named("cut").at(0, 0, 0.25).madeOf(BLUE));
        return Scene.EMPTY
                .plus("red", RED)
                .plus(Light.at(4, 6, 5).named("key"))
                .plus(Light.at(-4, 6, 5).named("fill"))
                .plus(
                        SceneObject.of(new Sphere(0.5)).named("ball").madeOf("red"),
                        SceneObject.of(bowl).named("bowl").at(3, 0, 0).rotated(0, 90, 0).madeOf("red"),
                        SceneObject.of(new Rectangle(-1, -1, 1, 1)).named("floor"),
                        SceneObject.of(new Block(Vec3.ZERO, Vec3.ONE)).named("ball 2").at(0, 2, 0));
    }

    public static EditorState kitchenState() {
        return EditorState.of(kitchen());
    }

    /** The names of the scene's objects, in order, separated by blanks. */
    public static String names(EditorState state) {
        return String.join(", ", state.scene().objects().stream().map(SceneObject::name).toList());
    }
}
