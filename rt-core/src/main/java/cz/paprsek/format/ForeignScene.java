package cz.paprsek.format;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.nff.NffReader;
import cz.paprsek.format.openscad.CsgReader;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.mesh.Triangles;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A file of another program as a scene that can be rendered at once: what is in it, where y is up, and what a picture needs besides.
 *
 * @param scene with the triangles of its meshes
 * @param convention what the numbers of the file mean; a z that goes up there goes up here
 * @param triangles what a file of triangles holds, in its own space
 * @param notes what is in the file but not taken along, in sentences
 */
public record ForeignScene(Scene scene, Convention convention, Optional<Triangles> triangles, List<String> notes) {
    private static final Placement Z_UP = Placement.NONE.withRotation(new Vec3(-90, 0, 0));
    private static final Material PLAIN = Material.color(new Rgb(205, 208, 214)).withDiffusion(0.85).withHighlight(0.2, 40);
    /** Edges of what stands for something round, in degrees. */
    private static final double ROUND = 30;

    public ForeignScene {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(convention, "convention");
        Objects.requireNonNull(triangles, "triangles");
        notes = List.copyOf(notes);
    }

    /**
     * Reads a file.
     *
     * @param file its name, as the assets have it
     * @throws IOException in one line that begins with the name
     */
    public static ForeignScene read(String file, ForeignFormat format, Assets assets) throws IOException {
        Objects.requireNonNull(file, "file");
        String name = file.substring(file.lastIndexOf('/') + 1).replaceFirst("\\.[^.]*$", "");
        if (format.isMesh()) {
            return mesh(file, name, assets);
        }
        try {
            return format == ForeignFormat.NFF ? nff(file, name, assets) : openscad(file, name, assets);
        } catch (FormatFault | IllegalArgumentException wrong) {
            throw new IOException(FormatFault.quoted(file) + ": " + wrong.getMessage(), wrong);
        }
    }

    private static ForeignScene mesh(String file, String name, Assets assets) throws IOException {
        Model model = MeshFiles.model(file, assets);
        Mesh mesh = Mesh.of(file).read(MeshFiles.whole(file, assets));
        SceneObject object = SceneObject.of(mesh).named(name).placed(model.convention().isZUp() ? Z_UP : Placement.NONE)
                .madeOf(model.materialOf().isEmpty() && !model.triangles().hasColors() ? PLAIN : Inherited.INHERITED);
        return new ForeignScene(Stage.of(name, List.of(object), model.cameras(), model.lights()), model.convention(), Optional.of(model.triangles()), model.notes());
    }

    private static ForeignScene openscad(String file, String name, Assets assets) throws IOException {
        Notes notes = new Notes();
        Kept kept = new Kept(name);
        String folder = file.substring(0, file.lastIndexOf('/') + 1);
        List<Operand> bodies = CsgReader.read(bytes(file, assets), beside -> assets.bytes(folder + beside), notes,
                (triangles, isRound) -> kept.mesh(triangles).withSmoothAngle(isRound ? ROUND : 0));
        List<SceneObject> objects = new ArrayList<>();
        for (Operand body : bodies) {
            objects.add(new SceneObject("", body.solid(), CsgReader.upright(body.placement()), body.material() == Inherited.INHERITED ? Material.color(CsgReader.COLOR) : body.material()));
        }
        List<Camera> cameras = List.of();
        List<Light> lights = List.of();
        return new ForeignScene(Stage.of(name, objects, cameras, lights), CsgReader.CONVENTION, Optional.empty(), notes.toList());
    }

    private static ForeignScene nff(String file, String name, Assets assets) throws IOException {
        Notes notes = new Notes();
        Kept kept = new Kept(name);
        Scene scene = NffReader.read(new ByteArrayInputStream(bytes(file, assets)), notes, triangles -> kept.mesh(triangles));
        return new ForeignScene(scene.withName(name), new Convention("", false), Optional.empty(), notes.toList());
    }

    /** Without the floor that it was given; itself if it has none. */
    public ForeignScene withoutFloor() {
        int last = scene.objects().size() - 1;
        return last < 0 || !(scene.objects().get(last).shape() instanceof Plane) ? this : new ForeignScene(scene.withObjects(scene.objects().subList(0, last)), convention, triangles, notes);
    }

    /** Makes meshes of triangles that lie in no file: as if they had been read from one, which they bring along. */
    private static final class Kept {
        private final String name;
        private int count;

        Kept(String name) {
            this.name = name;
        }

        Mesh mesh(Triangles triangles) {
            String file = name + "-" + ++count + ".obj";
            ByteArrayOutputStream text = new ByteArrayOutputStream();
            try {
                MeshWriter.obj(triangles, text);
            } catch (IOException impossible) {
                throw new UncheckedIOException("memory takes everything", impossible);
            }
            return Mesh.of(file).read(new Mesh.Whole(file, triangles, Map.of(), Map.of(file, text.toByteArray()), Set.of(), List.of()));
        }
    }

    private static byte[] bytes(String file, Assets assets) throws IOException {
        ByteBuffer content = assets.bytes(file);
        byte[] bytes = new byte[content.remaining()];
        content.get(bytes);
        return bytes;
    }
}
