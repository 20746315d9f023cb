package cz.paprsek.fx.view.library;

import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** Which of the scenes that are shown are selected, by their names, in the order shown. */
final class SceneSelection {
    private final ReadOnlyObjectWrapper<List<String>> names = new ReadOnlyObjectWrapper<>(List.of());
    private List<String> shown = List.of();
    /** Some may come only later: a scene that has just been renamed or copied. */
    private Set<String> wanted = Set.of();
    private Optional<String> lead = Optional.empty();
    private Optional<String> anchor = Optional.empty();

    List<String> names() {
        return names.get();
    }

    ReadOnlyObjectProperty<List<String>> namesProperty() {
        return names.getReadOnlyProperty();
    }

    /** Where the keyboard is: the place of the scene that was chosen last; -1 for none. */
    int leadPlace() {
        return lead.map(shown::indexOf).orElse(-1);
    }

    /** Takes the scenes that are shown now; what is not among them is not selected. */
    void show(List<Scene> scenes) {
        shown = scenes.stream().map(Scene::name).toList();
        set(wanted);
    }

    void only(String name) {
        lead = Optional.of(name);
        anchor = lead;
        set(Set.of(name));
    }

    /** Selects these and no others, such as copies that have just been made. */
    void only(List<String> chosen) {
        chosen.stream().findFirst().ifPresent(this::only);
        set(new LinkedHashSet<>(chosen));
    }

    void toggle(String name) {
        Set<String> next = new LinkedHashSet<>(names());
        if (!next.remove(name)) {
            next.add(name);
        }
        lead = Optional.of(name);
        anchor = lead;
        set(next);
    }

    /** Selects all from where the selection began to here. */
    void extend(String name) {
        int from = anchor.map(shown::indexOf).orElse(-1);
        int to = shown.indexOf(name);
        lead = Optional.of(name);
        set(new LinkedHashSet<>(from < 0 ? List.of(name) : shown.subList(Math.min(from, to), Math.max(from, to) + 1)));
    }

    void all() {
        set(new LinkedHashSet<>(shown));
    }

    private void set(Set<String> chosen) {
        wanted = chosen;
        List<String> next = new ArrayList<>(shown);
        next.retainAll(wanted);
        names.set(List.copyOf(next));
    }
}
