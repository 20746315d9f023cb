package cz.paprsek.scene;

import cz.paprsek.material.Inherited;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** An object of a scene, or an operand of one at any depth: what it is and where it stands among the others. */
public final class ScenePart {
    private final Scene scene;
    private final @Nullable ScenePart parent;
    private final int number;
    private final String name;
    private final Shape shape;
    private final Placement placement;
    private final MaterialSource source;

    private ScenePart(Scene scene, int number, SceneObject object) {
        this.scene = scene;
        this.parent = null;
        this.number = number;
        this.name = object.name();
        this.shape = object.shape();
        this.placement = object.placement();
        this.source = object.material();
    }

    private ScenePart(ScenePart parent, int number, Operand operand) {
        this.scene = parent.scene;
        this.parent = parent;
        this.number = number;
        this.name = operand.name();
        this.shape = operand.solid();
        this.placement = operand.placement();
        this.source = operand.material();
    }

    /** All objects of a scene, each followed by its operands, in the order of the file. */
    public static Stream<ScenePart> all(Scene scene) {
        return IntStream.range(0, scene.objects().size()).mapToObj(i -> new ScenePart(scene, i + 1, scene.objects().get(i)))
                .flatMap(ScenePart::withOperands);
    }

    /** This part and its operands at any depth. */
    public Stream<ScenePart> withOperands() {
        if (!(shape instanceof Csg csg)) {
            return Stream.of(this);
        }
        return Stream.concat(Stream.of(this), IntStream.range(0, csg.operands().size())
                .mapToObj(i -> new ScenePart(this, i + 1, csg.operands().get(i))).flatMap(ScenePart::withOperands));
    }

    public Scene scene() {
        return scene;
    }

    /** The operation that this is an operand of; empty for a whole object. */
    public Optional<ScenePart> parent() {
        return Optional.ofNullable(parent);
    }

    /** Its place among its siblings, from 1. */
    public int number() {
        return number;
    }

    /** Its name; empty for none. */
    public String name() {
        return name;
    }

    public Shape shape() {
        return shape;
    }

    /** Where it stands in the space of its operation, or in the world. */
    public Placement placement() {
        return placement;
    }

    /** Where its material comes from. */
    public MaterialSource source() {
        return source;
    }

    /** How many operations it is an operand of; 0 for a whole object. */
    public int depth() {
        return parent == null ? 0 : parent.depth() + 1;
    }

    /** The way to it from the scene, by names, or kinds and numbers where there are none: {@code bowl/block#2}. */
    public String path() {
        String step = name.isEmpty() ? shape.kind() + "#" + number : name;
        return parent == null ? step : parent.path() + "/" + step;
    }

    /** What it is made of, by itself or as its operation. */
    public Material material() {
        MaterialSource effective = effectiveSource();
        return effective instanceof MaterialName reference ? scene.materials().getOrDefault(reference.name(), Material.DEFAULT)
                : effective instanceof Material own ? own : Material.DEFAULT;
    }

    /** The name of the scene's material that it is made of; empty if that has none. */
    public String materialName() {
        return effectiveSource() instanceof MaterialName reference ? reference.name() : "";
    }

    private MaterialSource effectiveSource() {
        return source == Inherited.INHERITED && parent != null ? parent.effectiveSource() : source;
    }
}
