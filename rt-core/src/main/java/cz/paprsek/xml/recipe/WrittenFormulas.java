package cz.paprsek.xml.recipe;

import cz.paprsek.formula.Written;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.xml.recipe.Output.Mark;
import cz.paprsek.xml.text.Form;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Finds out where in a scene the formulas stand of which it is made. */
final class WrittenFormulas {
    private final Map<Integer, List<Mark>> marks = new HashMap<>();
    private final Map<Optional<ScenePath>, List<Written>> found = new LinkedHashMap<>();
    private int line;

    private WrittenFormulas(Output out) {
        out.marks().forEach(mark -> marks.computeIfAbsent(mark.line(), at -> new ArrayList<>()).add(mark));
    }

    /** By what has them; without a place, those of the scene itself and of what there is once in it. */
    static Map<Optional<ScenePath>, List<Written>> of(Output out) {
        if (out.marks().isEmpty()) {
            return Map.of();
        }
        WrittenFormulas all = new WrittenFormulas(out);
        all.scene(Form.parse(out.text()));
        return all.found;
    }

    private void scene(Form scene) {
        here(Optional.empty(), List.of());
        int bodies = 0;
        int lights = 0;
        int cameras = 0;
        for (Form child : scene.body().children()) {
            String name = child.body().name();
            switch (Form.group(name)) {
                case "body" -> body(child, ScenePath.body(bodies++));
                case "light" -> within(child, Optional.of(ScenePath.light(lights++)), List.of());
                case "camera" -> within(child, Optional.of(ScenePath.camera(cameras++)), List.of());
                case "material" -> within(child, Optional.of(new MaterialAt(Raw.text(child.body().attributes().getOrDefault("name", "")))), List.of());
                default -> within(child, Optional.empty(), List.of(name));
            }
        }
    }

    private void body(Form form, BodyAt at) {
        here(Optional.of(at), List.of());
        int operands = 0;
        for (Form child : form.body().children()) {
            if (Form.group(child.body().name()).equals("body")) {
                body(child, at.child(operands++));
            } else {
                within(child, Optional.of(at), List.of(child.body().name()));
            }
        }
    }

    private void within(Form form, Optional<ScenePath> place, List<String> elements) {
        here(place, elements);
        for (Form child : form.body().children()) {
            List<String> longer = new ArrayList<>(elements);
            longer.add(child.body().name());
            within(child, place, longer);
        }
    }

    private void here(Optional<ScenePath> place, List<String> elements) {
        for (Mark mark : marks.getOrDefault(line++, List.of())) {
            Tokens written = Tokens.of(mark.attribute().text());
            Tokens values = Tokens.of(Raw.text(mark.raw()));
            if (written.texts().size() != values.texts().size()) {
                continue;
            }
            for (int i = 0; i < values.texts().size(); i++) {
                String token = written.texts().get(i);
                if (token.startsWith("{") && token.indexOf('}') == token.length() - 1) {
                    found.computeIfAbsent(place, at -> new ArrayList<>()).add(new Written(elements, mark.attribute().name(), i, values.texts().size(),
                            token.substring(1, token.length() - 1).strip(), values.texts().get(i)));
                }
            }
        }
    }
}
