package cz.paprsek.fx.view.texts;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.model.edit.Pivots;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.text.Numbers;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Set;

/** What is selected, in words and numbers: how large the only body is along its own axes; of two things, how far they are apart; of three, the angle at the one that was selected second. */
public final class Measures {
    private static final MathContext DIGITS = new MathContext(4);

    private Measures() {}

    public static String of(EditorState state, Texts texts) {
        Scene scene = state.scene();
        String name = PathNames.of(scene, state.selection(), texts);
        if (state.selection().size() > 3) {
            return name;
        }
        List<ScenePath> items = List.copyOf(state.selection());
        if (items.size() == 2) {
            double apart = place(scene, items.get(0)).minus(place(scene, items.get(1))).length();
            return texts.of("measure.apart", name, number(apart, texts));
        }
        if (items.size() == 3) {
            Vec3 corner = place(scene, items.get(1));
            Vec3 one = place(scene, items.get(0)).minus(corner);
            Vec3 other = place(scene, items.get(2)).minus(corner);
            double degrees = Math.toDegrees(Math.atan2(one.cross(other).length(), one.dot(other)));
            return texts.of("measure.angle", name, number(degrees, texts), PathNames.of(scene, Set.of(items.get(1)), texts));
        }
        return items.size() == 1 && items.get(0) instanceof BodyAt at && at.isIn(scene) ? name + size(scene, at, texts) : name;
    }

    /** Along its own axes; nothing of what has no end. */
    private static String size(Scene scene, BodyAt at, Texts texts) {
        Bounds box = at.in(scene).shape().bounds();
        Affine toWorld = at.toWorld(scene);
        return box.isEmpty() || !box.isFinite() ? "" : "   " + number((box.maxX() - box.minX()) * toWorld.direction(Vec3.X).length(), texts)
                + " × " + number((box.maxY() - box.minY()) * toWorld.direction(Vec3.Y).length(), texts)
                + " × " + number((box.maxZ() - box.minZ()) * toWorld.direction(Vec3.Z).length(), texts);
    }

    /** Of bodies, what they are turned about. */
    private static Vec3 place(Scene scene, ScenePath item) {
        return item instanceof BodyAt body && body.isIn(scene) ? Pivots.of(scene, body)
                : item instanceof LightAt light && light.isIn(scene) ? LightMoves.place(scene.lights().get(light.index()))
                : item instanceof CameraAt camera && camera.isIn(scene) ? scene.cameras().get(camera.index()).position() : Vec3.ZERO;
    }

    private static String number(double value, Texts texts) {
        return texts.number(Numbers.text(new BigDecimal(value).round(DIGITS).doubleValue()));
    }
}
