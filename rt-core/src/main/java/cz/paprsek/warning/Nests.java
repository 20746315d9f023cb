package cz.paprsek.warning;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import java.util.BitSet;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Which objects of a scene have so many operands, in a few lines of definitions within one another, that nobody would wait until all are looked at. */
final class Nests {
    /** An object of so many primitives is still looked through, in about a second. */
    static final int LARGEST = 1 << 15;
    /** As are so many of all operations together. */
    private static final int MOST = 1 << 18;

    private final Scene scene;
    private final BitSet vast = new BitSet();

    Nests(Scene scene) {
        this.scene = scene;
        long left = MOST;
        for (int i = 0; i < scene.objects().size(); i++) {
            if (scene.objects().get(i).shape() instanceof Csg) {
                long most = Math.min(left, LARGEST);
                long primitives = Body.of(scene.objects().get(i)).primitives(most + 1);
                vast.set(i, primitives > most);
                left -= primitives > most ? 0 : primitives;
            }
        }
    }

    /** Whether its operands are not looked at, one by one. */
    boolean isVast(BodyAt body) {
        return vast.get(body.object().index());
    }

    /** The object and its operands at any depth; it alone if they are too many. */
    Stream<BodyAt> parts(BodyAt object) {
        return isVast(object) ? Stream.of(object) : object.withOperands(scene);
    }

    /** What operands are made of that are not looked at one by one. */
    Set<MaterialSource> materials() {
        Set<MaterialSource> materials = new LinkedHashSet<>();
        Set<Csg> seen = Collections.newSetFromMap(new IdentityHashMap<>());
        vast.stream().forEach(i -> collect((Csg) scene.objects().get(i).shape(), seen, materials));
        return materials;
    }

    /** Whether anything of an object shines. */
    boolean shines(BodyAt object) {
        if (!isVast(object)) {
            return object.withOperands(scene).anyMatch(part -> part.material(scene).shines());
        }
        Set<MaterialSource> materials = new LinkedHashSet<>();
        collect((Csg) object.in(scene).shape(), Collections.newSetFromMap(new IdentityHashMap<>()), materials);
        return object.material(scene).shines() || materials.stream().anyMatch(this::shines);
    }

    boolean shines(MaterialSource source) {
        return source instanceof MaterialName name ? name.in(scene.materials()).shines() : source instanceof Material own && own.shines();
    }

    /** Each operation is looked at once, however often it stands there. */
    private static void collect(Csg csg, Set<Csg> seen, Set<MaterialSource> materials) {
        if (seen.add(csg)) {
            for (Operand operand : csg.operands()) {
                materials.add(operand.material());
                if (operand.solid() instanceof Csg within) {
                    collect(within, seen, materials);
                }
            }
        }
    }

    /** All bodies that are looked at. */
    Stream<BodyAt> bodies() {
        return IntStream.range(0, scene.objects().size()).mapToObj(ScenePath::body).flatMap(this::parts);
    }
}
