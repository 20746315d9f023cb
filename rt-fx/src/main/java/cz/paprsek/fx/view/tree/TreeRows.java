package cz.paprsek.fx.view.tree;

import cz.paprsek.formula.Maker;
import cz.paprsek.fx.model.Copies;
import cz.paprsek.fx.view.look.Icons;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Operand;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/** Lays a scene out as lines: the cameras, the lights, the objects, and within expanded operations their operands. */
final class TreeRows {
    /** Which copies they are, the first of all. */
    private static final Pattern NUMBERS = Pattern.compile("(\\[\\d+\\])+$");
    private final Texts texts;
    private final Set<BodyAt> expanded;
    private final String wanted;
    private final Copies copies;

    /**
     * @param copies of what is repeated the first is shown
     * @param wanted what a name or kind must contain to be shown, with all that is around it; empty for everything
     */
    TreeRows(Texts texts, Set<BodyAt> expanded, Copies copies, String wanted) {
        this.copies = copies;
        this.texts = texts;
        this.expanded = expanded;
        this.wanted = wanted.strip().toLowerCase(Locale.ROOT);
    }

    List<TreeRow> of(Scene scene) {
        List<TreeRow> rows = new ArrayList<>();
        for (int i = 0; i < scene.cameras().size(); i++) {
            String name = scene.cameras().get(i).name();
            String kind = texts.of("kind.camera");
            add(rows, new TreeRow(ScenePath.camera(i), 0, name.isEmpty() ? kind : name, !name.isEmpty(), Icons.CAMERA, false, false), kind);
        }
        for (int i = 0; i < scene.lights().size(); i++) {
            String name = scene.lights().get(i).name();
            String kind = texts.kind(scene.lights().get(i));
            add(rows, new TreeRow(ScenePath.light(i), 0, name.isEmpty() ? kind : name, !name.isEmpty(), Icons.of(scene.lights().get(i)), false, false), kind);
        }
        for (int i = 0; i < scene.objects().size(); i++) {
            addBody(rows, ScenePath.body(i), Body.of(scene.objects().get(i)));
        }
        return rows;
    }

    /** Adds a body and what is shown of what is within; if something is wanted, only with that. */
    private boolean addBody(List<TreeRow> rows, BodyAt at, Body body) {
        if (copies.isCopy(at)) {
            return false;
        }
        List<Operand> operands = body.operands();
        String kind = texts.kind(body.shape());
        boolean open = !operands.isEmpty() && (expanded.contains(at) || !wanted.isEmpty());
        int mark = rows.size();
        Optional<Maker> repeat = copies.repeat(at);
        String name = repeat.isEmpty() ? body.name() : NUMBERS.matcher(body.name()).replaceAll("");
        // The number stands at what is all of them.
        String times = repeat.filter(one -> one.whole().isEmpty() || one.whole().equals(at.numbers())).map(one -> " \u00d7 " + one.count()).orElse("");
        rows.add(new TreeRow(at, at.depth(), (name.isEmpty() ? kind : name) + times, !body.name().isEmpty(),
                Icons.of(body.shape()), !operands.isEmpty(), open));
        boolean shown = wanted.isEmpty() || matches(body.name()) || matches(kind);
        if (open) {
            for (int i = 0; i < operands.size(); i++) {
                shown |= addBody(rows, at.child(i), Body.of(operands.get(i)));
            }
        }
        if (!shown) {
            rows.subList(mark, rows.size()).clear();
        }
        return shown;
    }

    private void add(List<TreeRow> rows, TreeRow row, String kind) {
        if (wanted.isEmpty() || matches(row.text()) || matches(kind)) {
            rows.add(row);
        }
    }

    private boolean matches(String text) {
        return text.toLowerCase(Locale.ROOT).contains(wanted);
    }
}
