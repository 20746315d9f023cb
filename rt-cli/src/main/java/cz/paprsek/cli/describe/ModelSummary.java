package cz.paprsek.cli.describe;

import cz.paprsek.format.ForeignScene;
import cz.paprsek.io.Json;
import cz.paprsek.math.Bounds;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.text.Numbers;
import java.util.ArrayList;
import java.util.List;

/** What is said of a file of triangles: whether it is a body, and how large. Numbers are those of the file. */
public final class ModelSummary {
    private static final int MOST_PARTS = 20;

    private ModelSummary() {}

    /** @param raw the triangles as the file has them */
    public static List<String> lines(ForeignScene model, Triangles raw) {
        Triangles mesh = raw.sewn(Mesh.USUAL_WELD);
        Bounds bounds = mesh.bounds();
        String unit = model.convention().unit();
        List<String> lines = new ArrayList<>();
        lines.add("  triangles   " + mesh.count() + ", vertices " + mesh.vertexCount());
        lines.add("  closed      " + (mesh.isClosed() ? "yes" : "no, " + mesh.openEdges() + (mesh.openEdges() == 1 ? " edge is open" : " edges are open")) + welded(raw));
        if (mesh.isClosed()) {
            lines.add("  volume      " + Numbers.text(mesh.volume()) + (unit.isEmpty() ? "" : " " + unit + "³"));
        }
        lines.add("  area        " + Numbers.text(mesh.area()) + (unit.isEmpty() ? "" : " " + unit + "²"));
        lines.add("  bounds      " + Numbers.text(bounds.minX()) + " " + Numbers.text(bounds.minY()) + " " + Numbers.text(bounds.minZ())
                + " to " + Numbers.text(bounds.maxX()) + " " + Numbers.text(bounds.maxY()) + " " + Numbers.text(bounds.maxZ()));
        lines.add("  unit        " + (unit.isEmpty() ? "not said" : unit) + ", " + (model.convention().isZUp() ? "z" : "y") + " is up");
        if (mesh.hasColors()) {
            lines.add("  colours     at its vertices");
        }
        if (mesh.parts().size() > 1 || !mesh.parts().get(0).isEmpty()) {
            lines.add("  parts       " + mesh.parts().size() + ": " + String.join(", ", mesh.parts().stream().limit(MOST_PARTS).map(part -> part.isEmpty() ? "\"\"" : part).toList())
                    + (mesh.parts().size() > MOST_PARTS ? ", …" : ""));
        }
        return lines;
    }

    private static String welded(Triangles raw) {
        int welded = raw.placesSewn(Mesh.USUAL_WELD);
        int kept = raw.shortSides(Mesh.USUAL_WELD);
        return (welded == 0 ? "" : ", with " + welded + (welded == 1 ? " corner" : " corners") + " welded to the next")
                + (kept == 0 ? "" : "; " + kept + (kept == 1 ? " side" : " sides") + " no longer than what is welded left alone");
    }

    /** @param raw the triangles as the file has them */
    public static Json json(String file, ForeignScene model, Triangles raw) {
        return measured(new Json().with("file", file), raw.sewn(Mesh.USUAL_WELD)).with("welded", raw.placesSewn(Mesh.USUAL_WELD))
                .with("unit", model.convention().unit()).with("up", model.convention().isZUp() ? "z" : "y").withTexts("parts", raw.parts()).withTexts("notes", model.notes());
    }

    /** What a scene's mesh is like, in its own space. */
    static Json json(Mesh mesh) {
        return measured(new Json().with("file", mesh.file()).with("part", mesh.part()), mesh.triangles());
    }

    /** The same in a line. */
    static String line(Mesh mesh) {
        Triangles triangles = mesh.triangles();
        return (mesh.part().isEmpty() ? "" : "part " + mesh.part() + ", ") + triangles.count() + " triangles, "
                + (triangles.isClosed() ? "closed, volume " + Numbers.text(triangles.volume()) : "open edges " + triangles.openEdges()) + ", area " + Numbers.text(triangles.area()) + (triangles.hasColors() ? ", coloured at its vertices" : "");
    }

    private static Json measured(Json json, Triangles mesh) {
        Bounds bounds = mesh.bounds();
        return json.with("triangles", mesh.count()).with("vertices", mesh.vertexCount()).with("vertex-colors", mesh.hasColors()).with("closed", mesh.isClosed())
                .with("open-edges", mesh.openEdges()).with("volume", mesh.isClosed() ? mesh.volume() : Double.NaN).with("area", mesh.area())
                .with("bounds", new Json().withNumbers("min", bounds.minX(), bounds.minY(), bounds.minZ()).withNumbers("max", bounds.maxX(), bounds.maxY(), bounds.maxZ()));
    }
}
