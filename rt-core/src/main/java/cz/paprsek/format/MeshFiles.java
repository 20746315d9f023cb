package cz.paprsek.format;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.model.Companions;
import cz.paprsek.format.model.Model;
import cz.paprsek.io.PlainText;
import cz.paprsek.material.Material;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Text;
import cz.paprsek.shape.font.Fonts;
import cz.paprsek.shape.height.HeightField;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;

/** Reads the files of a scene's meshes and height fields, and the fonts of its texts. */
public final class MeshFiles {
    private static final int LARGEST_FONT = 1 << 25;
    private static final Assets.Decoder<byte[]> FONT_BYTES = (name, input, size) -> {
        byte[] bytes = input.readNBytes(LARGEST_FONT + 1);
        if (bytes.length > LARGEST_FONT) {
            throw new IOException("a font must have at most " + LARGEST_FONT + " bytes");
        }
        return bytes;
    };

    private MeshFiles() {}

    /**
     * The same scene with the triangles of its meshes, the heights of its fields and the letters of its texts, as far as they can be read; itself if there is nothing to read.
     *
     * @param assets where files come from; each is read once, and the files within it are among them from then on
     * @param problems told of every file that cannot be read, or has open edges and is an operand all the same: where it is, and why in one sentence
     */
    public static Scene read(Scene scene, Assets assets, BiConsumer<BodyAt, IOException> problems) {
        Objects.requireNonNull(assets, "assets");
        return new Reading(assets, Objects.requireNonNull(problems, "problems")).read(scene);
    }

    /**
     * As {@link #read(Scene, Assets, BiConsumer)}, or not at all.
     *
     * @throws IOException if there is any problem: the first
     */
    public static Scene read(Scene scene, Assets assets) throws IOException {
        List<IOException> found = new ArrayList<>();
        Scene read = read(scene, assets, (place, problem) -> found.add(problem));
        if (!found.isEmpty()) {
            throw found.get(0);
        }
        return read;
    }

    /**
     * What is in a file.
     *
     * @throws IOException with a sentence that begins with the name, if it cannot be read
     */
    public static Mesh.Whole whole(String file, Assets assets) throws IOException {
        Read read = assets.decoded(file, new Decoder(assets));
        return read.wholes.computeIfAbsent(file, name -> whole(name, read));
    }

    private static Mesh.Whole whole(String file, Read read) {
        Model model = read.model;
        Map<String, Material> materials = new HashMap<>();
        Set<String> companions = new TreeSet<>(read.asked);
        model.materialOf().forEach((part, name) -> {
            Material material = model.materials().get(name);
            if (material != null) {
                Material found = beside(file, material, model);
                materials.put(part, found);
                companions.addAll(found.files());
            }
        });
        companions.removeAll(model.pictures().keySet());
        return new Mesh.Whole(file, model.triangles(), materials, model.pictures(), companions, model.missing());
    }

    /**
     * The heights that a picture holds.
     *
     * @throws IOException with a sentence that begins with the name, if it cannot be read
     */
    public static HeightField.Content heights(String file, Assets assets) throws IOException {
        return assets.decoded(file, new HeightPicture(assets.largest()));
    }

    /** All that is in a file, as {@link #whole} reads it. */
    static Model model(String file, Assets assets) throws IOException {
        return assets.decoded(file, new Decoder(assets)).model;
    }

    /** A material whose pictures are found from the scene's folder; those within the file itself have names that begin there already. */
    private static Material beside(String file, Material material, Model model) {
        return Renaming.of(material, name -> model.pictures().containsKey(name) ? name : folder(file) + name);
    }

    private static String folder(String file) {
        return file.substring(0, file.lastIndexOf('/') + 1);
    }

    /**
     * A file that has been read.
     *
     * @param asked the files beside it that were read with it
     * @param wholes what meshes have of it, by the name that they call it, so that all share one tree
     */
    private record Read(Model model, Set<String> asked, Map<String, Mesh.Whole> wholes) {}

    /** Those for the same assets are equal. */
    private record Decoder(Assets assets) implements Assets.Decoder<Read> {
        @Override
        public Read decode(String name, InputStream input, long size) throws IOException {
            InputStream again = new BufferedInputStream(input, ForeignFormat.HEAD);
            again.mark(ForeignFormat.HEAD);
            byte[] head = again.readNBytes(ForeignFormat.HEAD);
            again.reset();
            if (head.length > 1 && head[0] == 0x1F && head[1] == (byte) 0x8B) {
                throw new IOException("this is a packed file; unpack it first");
            }
            ForeignFormat format = ForeignFormat.of(name, head).filter(ForeignFormat::isMesh)
                    .orElseThrow(() -> new IOException("this is none of the files that hold meshes: " + ForeignFormat.meshes()));
            Beside beside = new Beside(assets, folder(name), new TreeSet<>());
            return new Read(ForeignFiles.model(name, format, again, size, beside), beside.asked, new ConcurrentHashMap<>());
        }
    }

    /**
     * The files beside one that is read.
     *
     * @param asked those of them that were read with it
     */
    private record Beside(Assets assets, String folder, Set<String> asked) implements Companions {
        @Override
        public ByteBuffer bytes(String name) throws IOException {
            String beside = folder + Objects.requireNonNull(name, "name");
            ByteBuffer content = assets.bytes(beside);
            asked.add(beside);
            return content;
        }

        /** It is not read: the scene may not need it. */
        @Override
        public boolean isThere(String name) {
            try {
                assets.open(folder + Objects.requireNonNull(name, "name")).close();
                return true;
            } catch (IOException unreadable) {
                return false;
            }
        }
    }

    /** Reads what one scene needs. */
    private static final class Reading {
        private static final int FEW = 8;

        private final Assets assets;
        private final BiConsumer<BodyAt, IOException> problems;
        /** How many problems have been told. */
        private int told;
        /** What operations have become of which there was nothing to tell: wherever else they stand, there is not either. */
        private final IdentityHashMap<Csg, Csg> done = new IdentityHashMap<>();

        Reading(Assets assets, BiConsumer<BodyAt, IOException> problems) {
            this.assets = assets;
            this.problems = problems;
        }

        Scene read(Scene scene) {
            List<SceneObject> objects = null;
            for (int i = 0; i < scene.objects().size(); i++) {
                SceneObject object = scene.objects().get(i);
                Shape shape = object.shape();
                if (mayRead(shape)) {
                    Shape read = read(shape, ScenePath.body(i));
                    if (read != shape) {
                        objects = objects == null ? new ArrayList<>(scene.objects()) : objects;
                        objects.set(i, object.withShape(read));
                    }
                }
            }
            return objects == null ? scene : scene.withObjects(objects);
        }

        private static boolean mayRead(Shape shape) {
            return shape instanceof Mesh || shape instanceof Text || shape instanceof HeightField || shape instanceof Csg;
        }

        private Shape read(Shape shape, BodyAt at) {
            if (shape instanceof Mesh mesh) {
                return read(mesh, at);
            }
            if (shape instanceof Text text) {
                return read(text, at);
            }
            if (shape instanceof HeightField field) {
                return read(field, at);
            }
            return shape instanceof Csg csg ? read(csg, at) : shape;
        }

        private Mesh read(Mesh mesh, BodyAt at) {
            try {
                Mesh read = mesh.isRead() ? mesh : mesh.read(whole(mesh.file(), assets));
                read.triangles();
                for (Map.Entry<String, byte[]> inner : read.within().entrySet()) {
                    assets.supply(inner.getKey(), inner.getValue());
                }
                return read;
            } catch (IllegalArgumentException refused) {
                tell(at, new IOException(refused.getMessage(), refused));
            } catch (IOException e) {
                tell(at, e);
            }
            return mesh;
        }

        private Text read(Text text, BodyAt at) {
            if (text.isRead()) {
                return text;
            }
            String file = text.font();
            try {
                return text.read(assets.decoded(file, FONT_BYTES));
            } catch (IllegalArgumentException refused) {
                tell(at, new IOException('"' + PlainText.of(file, 100) + "\": " + refused.getMessage(), refused));
            } catch (IOException e) {
                tell(at, file.contains(".") ? e : new IOException(e.getMessage() + "; the fonts that are shipped are " + String.join(", ", Fonts.NAMES), e));
            }
            return text;
        }

        private HeightField read(HeightField field, BodyAt at) {
            if (field.isRead()) {
                return field;
            }
            try {
                return field.read(heights(field.file(), assets));
            } catch (IllegalArgumentException refused) {
                tell(at, new IOException('"' + PlainText.of(field.file(), 100) + "\": " + refused.getMessage(), refused));
            } catch (IOException e) {
                tell(at, e);
            }
            return field;
        }

        private Csg read(Csg csg, BodyAt at) {
            Csg known = done.get(csg);
            if (known != null) {
                return known;
            }
            int before = told;
            boolean isWorthKnowing = csg.operands().size() > FEW;
            List<Operand> operands = null;
            for (int i = 0; i < csg.operands().size(); i++) {
                Operand operand = csg.operands().get(i);
                if (!mayRead(operand.solid())) {
                    continue;
                }
                isWorthKnowing = true;
                Solid read = (Solid) read(operand.solid(), at.child(i));
                try {
                    csg.refuseOpen(read);
                } catch (IllegalArgumentException open) {
                    tell(at.child(i), new IOException(open.getMessage(), open));
                }
                if (read != operand.solid()) {
                    operands = operands == null ? new ArrayList<>(csg.operands()) : operands;
                    operands.set(i, operand.withSolid(read));
                }
            }
            Csg read = operands == null ? csg : new Csg(csg.operation(), operands);
            if (isWorthKnowing && told == before) {
                done.put(csg, read);
            }
            return read;
        }

        private void tell(BodyAt at, IOException problem) {
            told++;
            problems.accept(at, problem);
        }
    }
}
