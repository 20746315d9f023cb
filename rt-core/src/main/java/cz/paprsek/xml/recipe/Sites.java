package cz.paprsek.xml.recipe;

import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.xml.text.Form;
import java.util.LinkedHashMap;
import java.util.Map;

/** Finds out where in a file the elements begin that what is in a scene stands for: what comes of a definition stands where that is used. */
final class Sites {
    private final Node scene;
    private final Node[] sites;
    private final Map<ScenePath, Integer> found = new LinkedHashMap<>();
    private int line;

    private Sites(Node scene, Output out) {
        this.scene = scene;
        sites = out.sites();
    }

    /** In bytes of the file that the scene itself is in. */
    static Map<ScenePath, Integer> of(Node scene, Output out) {
        Sites all = new Sites(scene, out);
        all.scene(Form.parse(out.text()));
        return all.found;
    }

    private void scene(Form form) {
        line++;
        int bodies = 0;
        int lights = 0;
        int cameras = 0;
        for (Form child : form.body().children()) {
            switch (Form.group(child.body().name())) {
                case "body" -> body(child, ScenePath.body(bodies++));
                case "light" -> one(child, ScenePath.light(lights++));
                case "camera" -> one(child, ScenePath.camera(cameras++));
                case "material" -> one(child, new MaterialAt(Raw.text(child.body().attributes().getOrDefault("name", ""))));
                default -> pass(child);
            }
        }
    }

    private void body(Form form, BodyAt at) {
        here(at);
        int operands = 0;
        for (Form child : form.body().children()) {
            if (Form.group(child.body().name()).equals("body")) {
                body(child, at.child(operands++));
            } else {
                pass(child);
            }
        }
    }

    private void one(Form form, ScenePath place) {
        here(place);
        form.body().children().forEach(this::pass);
    }

    private void pass(Form form) {
        line++;
        form.body().children().forEach(this::pass);
    }

    private void here(ScenePath place) {
        Node site = sites[line++];
        if (site.origin().equals(scene.origin())) {
            found.put(place, site.at());
        }
    }
}
