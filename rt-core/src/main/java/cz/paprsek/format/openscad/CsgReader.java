package cz.paprsek.format.openscad;

import cz.paprsek.format.model.Companions;
import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.obj.ObjReader;
import cz.paprsek.format.off.OffReader;
import cz.paprsek.format.stl.StlReader;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Solid;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Reads a dump: a list of bodies, each an operand with its place and, if the file gives it a colour, its material. */
public final class CsgReader {
    /** What OpenSCAD shows a body in that has no colour. */
    public static final Rgb COLOR = new Rgb(249, 215, 44);

    /** Millimetres with z up. */
    public static final Convention CONVENTION = new Convention("mm", true);
    private static final Affine UPRIGHT = Affine.rotation(new Vec3(-90, 0, 0));

    private final Companions companions;
    private final Notes notes;
    private final Extrusion.Meshes meshes;
    private final Bodies bodies;

    private CsgReader(Companions companions, Notes notes, Extrusion.Meshes meshes) {
        this.companions = companions;
        this.notes = notes;
        this.meshes = meshes;
        this.bodies = new Bodies(meshes);
    }

    /** What colour the things within have, if it is said, and what figures of the plane become. */
    private record Within(Affine map, Affine inPlane, Optional<Material> material, Optional<Extrusion> extrusion) {
        Within then(Affine more) {
            return extrusion.isPresent() ? new Within(map, inPlane.after(more), material, extrusion) : new Within(map.after(more), inPlane, material, extrusion);
        }

        Within extruded(Extrusion how) {
            return new Within(map, Affine.IDENTITY, material, Optional.of(how));
        }

        /** The outer colour counts. */
        Within colored(Material color) {
            return material.isPresent() ? this : new Within(map, inPlane, Optional.of(color), extrusion);
        }

        Within at(Affine place) {
            return new Within(place, inPlane, material, extrusion);
        }
    }

    /**
     * The bodies of a file, where z is up.
     *
     * @param meshes makes solids of triangles
     * @throws IOException if something is wrong with it; in one line that begins with the number of a line
     */
    public static List<Operand> read(byte[] text, Companions companions, Notes notes, Extrusion.Meshes meshes) throws IOException {
        List<Node> nodes = new TreeReader(text).read();
        CsgReader reader = new CsgReader(companions, notes, meshes);
        List<Operand> all = reader.all(nodes, new Within(Affine.IDENTITY, Affine.IDENTITY, Optional.empty(), Optional.empty()));
        if (all.isEmpty()) {
            List<String> said = notes.toList();
            throw FormatFault.in("the end", "there is no body in this file" + (said.isEmpty() ? "" : "; " + String.join("; ", said)));
        }
        return all;
    }

    /** A placement where z is up, as one where y is. */
    public static Placement upright(Placement placement) {
        return Placing.of(UPRIGHT.after(placement.toParent())).orElse(placement);
    }

    private List<Operand> all(List<Node> nodes, Within within) throws IOException {
        List<Operand> all = new ArrayList<>();
        for (Node node : nodes) {
            all.addAll(pieces(node, within));
        }
        return all;
    }

    /** What a node is: bodies that together are its union; none if it is nothing. */
    private List<Operand> pieces(Node node, Within within) throws IOException {
        if (node.modifier() == '*') {
            return List.of();
        }
        if (node.modifier() == '%') {
            notes.line(node.line(), "what is marked with % is not shown");
            return List.of();
        }
        return switch (node.name()) {
            case "group", "union", "render" -> all(node.children(), within);
            case "multmatrix" -> all(node.children(), within.then(matrix(node)));
            case "color" -> all(node.children(), within.colored(color(node)));
            case "difference" -> operation(Csg.Operation.DIFFERENCE, node, within);
            case "intersection" -> operation(Csg.Operation.INTERSECTION, node, within);
            case "linear_extrude" -> extruded(node, within, Extrusion.linear(node));
            case "rotate_extrude" -> extruded(node, within, Extrusion.rotating(node));
            case "square", "circle", "polygon" -> figures(node, within);
            case "cube" -> one(bodies.cube(node, within.map), within);
            case "sphere" -> one(bodies.sphere(node, within.map), within);
            case "cylinder" -> one(bodies.cylinder(node, within.map), within);
            case "polyhedron" -> one(bodies.polyhedron(node, within.map), within);
            case "import" -> imported(node, within);
            default -> {
                notes.line(node.line(), node.name() + "() is not read, and left out");
                yield List.of();
            }
        };
    }

    private static List<Operand> one(Optional<Operand> body, Within within) {
        return body.map(operand -> within.material.map(operand::madeOf).orElse(operand)).map(List::of).orElse(List.of());
    }

    private static Affine matrix(Node node) throws IOException {
        List<Value> rows = node.list("0");
        if (rows.size() < 3) {
            throw node.fault("multmatrix must have three or four rows");
        }
        double[] x = node.vector(rows.get(0), 4, "rows");
        double[] y = node.vector(rows.get(1), 4, "rows");
        double[] z = node.vector(rows.get(2), 4, "rows");
        return new Affine(x[0], x[1], x[2], x[3], y[0], y[1], y[2], y[3], z[0], z[1], z[2], z[3]);
    }

    private static Material color(Node node) throws IOException {
        List<Value> said = node.list("0");
        if (said.size() < 3) {
            return Material.color(COLOR);
        }
        double[] rgb = node.vector(new Value.Vec(said), 3, "numbers");
        double alpha = said.size() > 3 ? node.vector(new Value.Vec(said), 4, "numbers")[3] : 1;
        Material opaque = Material.color(new Rgb(channel(rgb[0]), channel(rgb[1]), channel(rgb[2])));
        return alpha < 1 ? opaque.withDiffusion(0.8 * Math.max(0, alpha)).withTransparency(1 - Math.max(0, alpha), 1) : opaque;
    }

    private static double channel(double share) {
        return Math.max(0, Math.min(1, share)) * 255;
    }

    private List<Operand> operation(Csg.Operation operation, Node node, Within within) throws IOException {
        // An operation stays one thing to move if its place can be said of it, and is not that of a figure in the plane.
        Optional<Placement> placement = within.extrusion.isEmpty() && within.map.isSane() ? Placing.of(within.map) : Optional.empty();
        Within inside = placement.isPresent() ? within.at(Affine.IDENTITY) : within;
        List<Operand> operands = new ArrayList<>();
        for (int i = 0; i < node.children().size(); i++) {
            List<Operand> pieces = pieces(node.children().get(i), inside);
            if (pieces.isEmpty() && (i == 0 || operation == Csg.Operation.INTERSECTION)) {
                return List.of();
            }
            if (i > 0 && operation == Csg.Operation.DIFFERENCE) {
                operands.addAll(pieces);
            } else {
                operands.add(together(Csg.Operation.UNION, node, pieces));
            }
        }
        if (operands.isEmpty()) {
            return List.of();
        }
        Operand whole = together(operation, node, operands);
        Operand placed = placement.isEmpty() || placement.get().equals(Placement.NONE) ? whole
                : operands.size() > 1 ? whole.placed(placement.get()) : Operand.of(new Csg(Csg.Operation.UNION, operands)).placed(placement.get());
        return List.of(operands.size() == 1 ? placed : within.material.map(placed::madeOf).orElse(placed));
    }

    /** The bodies as one. */
    private static Operand together(Csg.Operation operation, Node node, List<Operand> operands) throws FormatFault {
        try {
            return operands.size() == 1 ? operands.get(0) : Operand.of(new Csg(operation, operands));
        } catch (IllegalArgumentException open) {
            throw node.fault(node.name() + "(): " + open.getMessage());
        }
    }

    private List<Operand> extruded(Node node, Within within, Extrusion how) throws IOException {
        if (!node.text("file").isEmpty()) {
            notes.line(node.line(), node.name() + "() of a file is not read, and left out");
            return List.of();
        }
        return within.extrusion.isPresent() ? List.of() : all(node.children(), within.extruded(how));
    }

    private List<Operand> figures(Node node, Within within) throws IOException {
        if (within.extrusion.isEmpty()) {
            notes.line(node.line(), node.name() + "() is flat, and left out where it is not extruded");
            return List.of();
        }
        return switch (node.name()) {
            case "square" -> {
                double[] size = node.numbers("size", 2, 1);
                double shift = node.flag("center") ? -0.5 : 0;
                yield size[0] > 0 && size[1] > 0
                        ? body(new Figure.Square(size[0] * shift, size[1] * shift, size[0] * (1 + shift), size[1] * (1 + shift)), within) : List.of();
            }
            case "circle" -> {
                double radius = node.number("r", 1);
                yield radius > 0 ? body(new Figure.Circle(radius, Bodies.sides(node)), within) : List.of();
            }
            default -> Paths.of(node).bodies(path -> body(path, within));
        };
    }

    private List<Operand> body(Figure figure, Within within) {
        return one(within.extrusion.orElseThrow().body(figure, within.inPlane, within.map, meshes), within);
    }

    private List<Operand> imported(Node node, Within within) throws IOException {
        String file = node.text("file");
        String ending = file.substring(file.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        if (within.extrusion.isPresent() || !List.of("stl", "obj", "off").contains(ending)) {
            notes.line(node.line(), "import() of " + FormatFault.quoted(file) + " is not read, and left out");
            return List.of();
        }
        try {
            ByteBuffer content = companions.bytes(file);
            byte[] bytes = new byte[content.remaining()];
            content.get(bytes);
            ByteArrayInputStream input = new ByteArrayInputStream(bytes);
            Model model = switch (ending) {
                case "stl" -> StlReader.read(input, bytes.length);
                case "off" -> OffReader.read(input, bytes.length);
                default -> ObjReader.read(input, Companions.NONE);
            };
            Solid solid = meshes.solid(model.triangles(), false);
            return one(Placing.placed(solid, within.map), within);
        } catch (FormatFault wrong) {
            throw node.fault("in " + FormatFault.quoted(file) + ", " + wrong.getMessage());
        } catch (IOException unreadable) {
            throw node.fault(String.valueOf(unreadable.getMessage()));
        }
    }
}
