package cz.paprsek.fx.view.xml;

import cz.paprsek.material.Material;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.typing.Completion.Names;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** The names that can be written. */
final class Naming {
    private static final Pattern DEFINED = Pattern.compile("<define\\s[^<>]*?name=\"([^\"]+)\"");

    private Naming() {}

    static Names of(Scene scene, String text) {
        Set<String> materials = new TreeSet<>(scene.materials().keySet());
        materials.addAll(Material.ready().keySet());
        List<String> targets = new ArrayList<>();
        scene.objects().forEach(one -> targets.add(one.name()));
        scene.cameras().forEach(one -> targets.add("camera:" + one.name()));
        scene.lights().forEach(one -> targets.add("light:" + one.name()));
        scene.materials().keySet().forEach(name -> targets.add("material:" + name));
        scene.recipe().parameters().forEach(one -> targets.add("param:" + one.name()));
        targets.removeIf(name -> name.isEmpty() || name.endsWith(":"));
        return new Names(materials, DEFINED.matcher(text).results().map((MatchResult found) -> found.group(1)).distinct().toList(), targets.stream().distinct().toList());
    }
}
