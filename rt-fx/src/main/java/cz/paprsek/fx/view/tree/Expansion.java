package cz.paprsek.fx.view.tree;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

/** Which operations are opened; follows objects that an edit takes to another place. */
final class Expansion {
    private final Set<BodyAt> open = new HashSet<>();
    private Scene scene;

    Expansion(Scene scene) {
        this.scene = scene;
    }

    Set<BodyAt> open() {
        return open;
    }

    void set(BodyAt at, boolean isOpen) {
        if (isOpen) {
            open.add(at);
        } else {
            open.remove(at);
        }
    }

    /** Opens all operations around an item; whether any was not open. */
    boolean reveal(BodyAt at) {
        boolean changed = false;
        for (BodyAt around = at; around.depth() > 0; ) {
            around = around.parent();
            changed |= open.add(around);
        }
        return changed;
    }

    /** Closes all: what stands in the same place of another file is something else. */
    void closeAll() {
        open.clear();
    }

    /** Takes note of another scene. */
    void follow(Scene now) {
        List<SceneObject> before = scene.objects();
        scene = now;
        if (open.isEmpty() || before == now.objects() || before.size() == now.objects().size()) {
            return;
        }
        IdentityHashMap<SceneObject, Integer> places = new IdentityHashMap<>();
        for (int i = 0; i < now.objects().size(); i++) {
            places.put(now.objects().get(i), i);
        }
        Set<BodyAt> moved = new HashSet<>();
        for (BodyAt at : open) {
            int old = at.numbers().get(0);
            Integer place = old < before.size() ? places.get(before.get(old)) : null;
            List<Integer> path = new ArrayList<>(at.numbers());
            path.set(0, place == null ? old : place);
            moved.add(new BodyAt(path));
        }
        open.clear();
        open.addAll(moved);
    }
}
