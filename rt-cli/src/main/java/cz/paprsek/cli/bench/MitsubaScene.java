package cz.paprsek.cli.bench;

import cz.paprsek.io.Json;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.mesh.Triangles;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The scenes that are compared with Mitsuba, as {@code bench.py} reads them: matt rectangles, blocks and meshes, one light. */
final class MitsubaScene {
    private MitsubaScene() {}

    /** Writes {@code scene.json} into a folder, and a mesh beside it. */
    static void write(Scene scene, Path folder) throws IOException {
        Camera camera = scene.camera();
        Json words = new Json().with("width", scene.settings().width()).with("height", scene.settings().height()).with("depth", scene.settings().maxDepth())
                .with("samples", scene.settings().samples()).with("paths", scene.settings().isPath())
                .with("eye", camera.position()).with("target", camera.position().plus(camera.forward())).with("up", camera.up()).with("fovy", ((Lens.Perspective) camera.lens()).fovy())
                .with("light", light(scene.lights().get(0)));
        Json[] bodies = new Json[scene.objects().size()];
        for (int i = 0; i < bodies.length; i++) {
            bodies[i] = body(scene.objects().get(i), folder);
        }
        Files.writeString(folder.resolve("scene.json"), words.with("bodies", List.of(bodies)).toString());
    }

    private static Json light(Light light) {
        if (light instanceof AreaLight area && area.form() instanceof AreaLight.Size size) {
            // What arrives straight before it, one unit away, is as much as of a point there.
            return placed(area.placement().toParent(), new Vec3(0, 0, 0), new Vec3(size.width() / 2, size.height() / 2, 1))
                    .with("radiance", light(area.color(), Math.PI * area.intensity() / area.form().area()));
        }
        return new Json().with("position", ((PointLight) light).position());
    }

    private static Json body(SceneObject body, Path folder) throws IOException {
        Affine toWorld = body.placement().toParent();
        return shape(body, toWorld, folder).with("albedo", albedo((Material) body.material()));
    }

    private static Json shape(SceneObject body, Affine toWorld, Path folder) throws IOException {
        if (body.shape() instanceof Rectangle flat) {
            return placed(toWorld, new Vec3((flat.minX() + flat.maxX()) / 2, (flat.minY() + flat.maxY()) / 2, 0),
                    new Vec3((flat.maxX() - flat.minX()) / 2, (flat.maxY() - flat.minY()) / 2, 1)).with("type", "rectangle");
        }
        if (body.shape() instanceof Block block) {
            return placed(toWorld, block.min().plus(block.max()).times(0.5), block.max().minus(block.min()).times(0.5)).with("type", "cube");
        }
        writePly(((Mesh) body.shape()).triangles(), folder.resolve("mesh.ply"));
        return placed(toWorld, Vec3.ZERO, new Vec3(1, 1, 1)).with("type", "ply");
    }

    /** Of what reaches from −1 to 1 along each axis. */
    private static Json placed(Affine toWorld, Vec3 middle, Vec3 half) {
        Affine whole = toWorld.after(Affine.scalingAndMoving(half, middle));
        Vec3 o = whole.point(Vec3.ZERO);
        Vec3 x = whole.direction(Vec3.X);
        Vec3 y = whole.direction(Vec3.Y);
        Vec3 z = whole.direction(Vec3.Z);
        return new Json().withNumbers("matrix", x.x(), y.x(), z.x(), o.x(), x.y(), y.y(), z.y(), o.y(), x.z(), y.z(), z.z(), o.z());
    }

    private static Vec3 albedo(Material material) {
        return light(((Pattern.Plain) material.pattern()).color(), material.diffusion());
    }

    private static Vec3 light(Rgb color, double factor) {
        return new Vec3(color.linearRed(), color.linearGreen(), color.linearBlue()).times(factor);
    }

    private static void writePly(Triangles mesh, Path file) throws IOException {
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file), 1 << 16)) {
            out.write(("ply\nformat binary_little_endian 1.0\nelement vertex " + mesh.vertexCount() + "\nproperty float x\nproperty float y\nproperty float z\nelement face "
                    + mesh.count() + "\nproperty list uchar int vertex_indices\nend_header\n").getBytes(StandardCharsets.US_ASCII));
            ByteBuffer one = ByteBuffer.allocate(13).order(ByteOrder.LITTLE_ENDIAN);
            for (int i = 0; i < mesh.vertexCount(); i++) {
                one.clear().putFloat((float) mesh.x(i)).putFloat((float) mesh.y(i)).putFloat((float) mesh.z(i));
                out.write(one.array(), 0, one.position());
            }
            for (int i = 0; i < mesh.count(); i++) {
                one.clear().put((byte) 3).putInt(mesh.corner(i, 0)).putInt(mesh.corner(i, 1)).putInt(mesh.corner(i, 2));
                out.write(one.array(), 0, one.position());
            }
        }
    }
}
