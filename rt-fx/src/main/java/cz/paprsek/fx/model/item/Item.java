package cz.paprsek.fx.model.item;

import cz.paprsek.math.Require;
import java.util.ArrayList;
import java.util.List;

/** Where in a scene something stands that can be selected. Places, not things: the same item may be another thing after an edit. */
public sealed interface Item {

    /** The camera whose picture it is: the first. */
    Item CAMERA = new CameraAt(0);

    /** A camera, by its index in the scene. */
    record CameraAt(int index) implements Item {
        public CameraAt {
            Require.that(index >= 0, "an index must not be below 0, but is " + index);
        }
    }

    /** A light, by its index in the scene. */
    record LightAt(int index) implements Item {
        public LightAt {
            Require.that(index >= 0, "an index must not be below 0, but is " + index);
        }
    }

    /**
     * An object, or an operand within one.
     *
     * @param path the object's index in the scene, then the index among the operands of each operation on the way; at least one number
     */
    record BodyAt(List<Integer> path) implements Item {
        public BodyAt {
            path = List.copyOf(path);
            Require.that(!path.isEmpty(), "a path must not be empty");
        }

        /** How many operations are around it: 0 for an object of the scene. */
        public int depth() {
            return path.size() - 1;
        }

        /** The object of the scene that it is or belongs to. */
        public BodyAt object() {
            return body(path.get(0));
        }

        /** The operation around it; itself for an object of the scene. */
        public BodyAt parent() {
            return path.size() == 1 ? this : new BodyAt(path.subList(0, path.size() - 1));
        }

        /** Its index among its siblings. */
        public int index() {
            return path.get(path.size() - 1);
        }

        /** The operand of the given index within it. */
        public BodyAt child(int operand) {
            List<Integer> longer = new ArrayList<>(path);
            longer.add(operand);
            return new BodyAt(longer);
        }

        /** Whether the other is within this operation, at any depth. */
        public boolean holds(BodyAt other) {
            return other.path.size() > path.size() && other.path.subList(0, path.size()).equals(path);
        }
    }

    static CameraAt camera(int index) {
        return new CameraAt(index);
    }

    static LightAt light(int index) {
        return new LightAt(index);
    }

    static BodyAt body(Integer... path) {
        return new BodyAt(List.of(path));
    }
}
