package cz.paprsek.render.integrate;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;

/** Says where the parts of one object stand, by placing it once more and watching where each part comes from, so that renders need not keep it. */
public final class PartPaths {
    private final List<BodyAt> paths = new ArrayList<>();

    private PartPaths() {}

    /** The place of each part of an object, in the order in which the parts are registered. */
    public static List<BodyAt> of(Scene scene, int object) {
        PartPaths all = new PartPaths();
        BodyAt at = ScenePath.body(object);
        at.in(scene).shape().place(at.toWorld(scene), all.new Scope(at));
        return all.paths;
    }

    private final class Scope implements Parts {
        private final BodyAt at;
        private int operands;

        Scope(BodyAt at) {
            this.at = at;
        }

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            paths.add(at);
            return maker.apply(paths.size() - 1);
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return new Scope(at.child(operands++));
        }
    }
}
