package cz.paprsek.scene;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Surface;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Where in a scene something stands: an object or an operand of one at any depth, the camera, a light, a named material. Places, not
 * things: in another scene, or after an edit, the same place may hold another thing.
 */
public sealed interface ScenePath {
    /**
     * As text: an object by its name, or its kind and number where it has none, its operands likewise after a slash, such as
     * {@code bowl/block#2}; the others by their kind, such as {@code light:lamp}, {@code light:#2} or {@code material:glass}.
     *
     * @throws IllegalArgumentException if the scene has nothing there
     */
    default String text(Scene scene) {
        return PathText.of(Objects.requireNonNull(scene, "scene"), this);
    }

    /**
     * What a {@link #text} leads to. Whatever has a name may be called by its kind and number as well, if nothing else is called so.
     *
     * @throws IllegalArgumentException if it leads nowhere or to several things, with what was probably meant
     */
    static ScenePath parse(Scene scene, String text) {
        return PathText.parse(scene, text);
    }

    /** Whether the scene has something there. */
    boolean isIn(Scene scene);

    /** All objects of a scene, each followed by its operands, in the order of the file. */
    static Stream<BodyAt> bodies(Scene scene) {
        return IntStream.range(0, scene.objects().size()).mapToObj(ScenePath::body).flatMap(object -> object.withOperands(scene));
    }

    /** The camera whose picture it is: the first. */
    static CameraAt camera() {
        return camera(0);
    }

    static CameraAt camera(int index) {
        return new CameraAt(index);
    }

    static LightAt light(int index) {
        return new LightAt(index);
    }

    /** @param numbers as in {@link BodyAt} */
    static BodyAt body(Integer... numbers) {
        return new BodyAt(List.of(numbers));
    }

    /** A camera, by its index in the scene. */
    record CameraAt(int index) implements ScenePath {
        public CameraAt {
            Require.that(index >= 0, "an index must not be below 0, but is " + index);
        }

        @Override
        public boolean isIn(Scene scene) {
            return index < scene.cameras().size();
        }
    }

    /** A light, by its index in the scene. */
    record LightAt(int index) implements ScenePath {
        public LightAt {
            Require.that(index >= 0, "an index must not be below 0, but is " + index);
        }

        @Override
        public boolean isIn(Scene scene) {
            return index < scene.lights().size();
        }
    }

    /** A named material. */
    record MaterialAt(String name) implements ScenePath {
        public MaterialAt {
            Objects.requireNonNull(name, "name");
        }

        @Override
        public boolean isIn(Scene scene) {
            return scene.materials().containsKey(name);
        }

        Material in(Scene scene) {
            return Objects.requireNonNull(scene.materials().get(name), name);
        }
    }

    /**
     * An object, or an operand within one. What takes a scene throws an {@link IllegalArgumentException} if that has nothing here.
     *
     * @param numbers the object's index in the scene, then the index among the operands of each operation on the way; at least one number
     */
    record BodyAt(List<Integer> numbers) implements ScenePath {
        public BodyAt {
            numbers = List.copyOf(numbers);
            Require.that(!numbers.isEmpty(), "a path must not be empty");
        }

        @Override
        public boolean isIn(Scene scene) {
            return depth() == 0 ? index() >= 0 && index() < scene.objects().size() : find(scene).isPresent();
        }

        /** How many operations are around it: 0 for an object of the scene. */
        public int depth() {
            return numbers.size() - 1;
        }

        /** The object of the scene that it is or belongs to. */
        public BodyAt object() {
            return body(numbers.get(0));
        }

        /** The operation around it; itself for an object of the scene. */
        public BodyAt parent() {
            return depth() == 0 ? this : new BodyAt(numbers.subList(0, depth()));
        }

        /** Its index among its siblings. */
        public int index() {
            return numbers.get(depth());
        }

        /** The operand of the given index within it. */
        public BodyAt child(int operand) {
            return new BodyAt(Stream.concat(numbers.stream(), Stream.of(operand)).toList());
        }

        /** Whether the other is within this operation, at any depth. */
        public boolean holds(BodyAt other) {
            return other.depth() > depth() && other.numbers.subList(0, numbers.size()).equals(numbers);
        }

        /** The way to it: the object, each operation within that, itself. */
        public Stream<BodyAt> way() {
            return IntStream.rangeClosed(1, numbers.size()).mapToObj(length -> new BodyAt(numbers.subList(0, length)));
        }

        /** It and its operands at any depth. */
        public Stream<BodyAt> withOperands(Scene scene) {
            return Stream.concat(Stream.of(this), in(scene).shape() instanceof Csg csg
                    ? IntStream.range(0, csg.operands().size()).mapToObj(this::child).flatMap(operand -> operand.withOperands(scene))
                    : Stream.empty());
        }

        /** What stands here; empty if nothing does. */
        public Optional<Body> find(Scene scene) {
            int object = numbers.get(0);
            Optional<Body> body = object >= 0 && object < scene.objects().size() ? Optional.of(Body.of(scene.objects().get(object))) : Optional.empty();
            for (int number : numbers.subList(1, numbers.size())) {
                body = body.filter(around -> number >= 0 && number < around.operands().size()).map(around -> Body.of(around.operands().get(number)));
            }
            return body;
        }

        /** What stands here. */
        public Body in(Scene scene) {
            return find(scene).orElseThrow(() -> new IllegalArgumentException("there is nothing at " + numbers));
        }

        /** Its kind, and its name or number among its siblings from 1, for people: {@code sphere "ball"}, {@code block #2}. */
        public String label(Scene scene) {
            Body body = in(scene);
            return body.shape().kind() + " " + nameOrNumber(scene);
        }

        /** Its name in quotes; its number among its siblings, from 1, if it has none: {@code "ball"}, {@code #2}. */
        public String nameOrNumber(Scene scene) {
            String name = in(scene).name();
            return name.isEmpty() ? "#" + (index() + 1) : "\"" + name + "\"";
        }

        /** Where its material comes from: from its operation if it has none of its own. */
        public MaterialSource source(Scene scene) {
            MaterialSource own = in(scene).material();
            return own == Inherited.INHERITED && depth() > 0 ? parent().source(scene) : own;
        }

        /** What it is made of, by itself or as its operation. */
        public Material material(Scene scene) {
            MaterialSource source = source(scene);
            return source instanceof MaterialName reference ? reference.in(scene.materials())
                    : source instanceof Material own ? own : Material.DEFAULT;
        }

        /** The name of the scene's material that it is made of; empty if that has none. */
        public String materialName(Scene scene) {
            return source(scene) instanceof MaterialName reference ? reference.name() : "";
        }

        /** The map from its own space to the world. */
        public Affine toWorld(Scene scene) {
            Affine own = in(scene).placement().toParent();
            return depth() == 0 ? own : parent().toWorld(scene).after(own);
        }

        /** The map to the world from the space that its placement is in: that of its operation. */
        public Affine parentToWorld(Scene scene) {
            return depth() == 0 ? Affine.IDENTITY : parent().toWorld(scene);
        }

        /** It alone, placed in the world as for rendering; an operand as if nothing were taken from it. */
        public Surface placed(Scene scene) {
            return in(scene).shape().place(toWorld(scene), Parts.UNTOLD);
        }

        /**
         * Whether a point lies inside it, an operand as if nothing were taken from it; never in what has no inside. Places it for this one
         * question: for many, keep what {@link #placed} gives.
         *
         * @param point world space
         */
        public boolean contains(Scene scene, Vec3 point) {
            return placed(scene).contains(point);
        }
    }
}
