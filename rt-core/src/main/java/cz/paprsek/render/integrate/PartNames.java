package cz.paprsek.render.integrate;

import cz.paprsek.math.Affine;
import cz.paprsek.render.explain.SurfacePath;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Part;
import cz.paprsek.shape.Parts;
import cz.paprsek.shape.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;

/** Names the parts of one object, by placing it once more and watching where each part comes from, so that renders need not keep it. */
public final class PartNames {
    private final List<Name> names = new ArrayList<>();

    /** Where a part comes from, and the shape whose faces it has. */
    public record Name(SurfacePath path, Shape shape) {}

    public PartNames(int number, SceneObject object) {
        SurfacePath path = new SurfacePath(List.of(number), List.of(label(object.shape(), object.name(), number)));
        object.shape().place(object.placement().toParent(), new Scope(path, object.shape()));
    }

    /** The names in the order in which the parts are registered. */
    public List<Name> names() {
        return names;
    }

    private static String label(Shape shape, String name, int number) {
        return shape.kind() + (name.isEmpty() ? " #" + (number + 1) : " \"" + name + "\"");
    }

    private final class Scope implements Parts {
        private final SurfacePath path;
        private final Shape shape;
        private int operands;

        Scope(SurfacePath path, Shape shape) {
            this.path = path;
            this.shape = shape;
        }

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            names.add(new Name(path, shape));
            return maker.apply(names.size() - 1);
        }

        @Override
        public Parts within(Operand operand, Affine toWorld) {
            int number = operands++;
            return new Scope(path.to(number, label(operand.solid(), operand.name(), number)), operand.solid());
        }
    }
}
