package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import cz.paprsek.format.model.Notes;
import cz.paprsek.format.nff.NffReader;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/**
 * The first of the Standard Procedural Databases, {@code balls}, and the rays it takes. Its z axis is up.
 *
 * @source Haines, A Proposal for Standard Graphics Environments, IEEE CG&amp;A 7(11), 1987, with the counts of the package's own readme
 */
class BallsTest {
    private static final Material BALL = Material.color(Rgb.ofLinear(1, 0.9, 0.7)).withDiffusion(0.5).withHighlight(0.5, 37).withReflection(0.5);
    private static final Material FLOOR = Material.color(Rgb.ofLinear(1, 0.75, 0.33)).withDiffusion(0.8);

    private final List<SceneObject> objects = new ArrayList<>();

    @Test
    void theNumbersOfRaysAreThoseOfTheTable() {
        objects.add(SceneObject.of(new Rectangle(-12, -12, 12, 12)).at(0, 0, -0.5).madeOf(FLOOR));
        grow(Vec3.ZERO, 0.5, Vec3.Z, 4);
        assertThat(objects).hasSize(7382);
        // There the angle lies between the centres of the outer rows of pixels; here it spans whole pixels.
        double fovy = 2 * Math.toDegrees(Math.atan(Math.tan(Math.toRadians(22.5)) * 513 / 512));
        Scene scene = Scene.EMPTY.withSettings(new RenderSettings(513, 513, 5, 1))
                .withCamera(Camera.lookingAt(new Vec3(2.1, 1.3, 1.7), Vec3.ZERO).withUp(Vec3.Z).withFovy(fovy))
                .withLights(List.of(Light.at(4, 3, 2), Light.at(1, -4, 4), Light.at(-3, 1, 5)))
                .withObjects(objects);
        RenderScene ready = RenderScene.of(scene);
        RenderOptions shallow = RenderOptions.of(scene.settings().withMaxDepth(1));
        assertThat(Renderer.render(ready, shallow, RenderMonitor.NONE).stats().hits()).as("eye rays that hit").isEqualTo(263_169);
        RenderResult.Stats stats = Renderer.render(ready, RenderOptions.of(scene), RenderMonitor.NONE).stats();
        assertThat(stats.reflected()).as("reflected rays").isCloseTo(175_095, withinPercentage(1));
        assertThat(stats.refracted()).as("refracted rays").isZero();
        assertThat(stats.shadow()).as("shadow rays").isCloseTo(954_368, withinPercentage(1));
    }

    /** As the database's own program writes them, six digits each. */
    @Test
    void theFileOfItGivesTheSameNumbers() throws IOException {
        grow(Vec3.ZERO, 0.5, Vec3.Z, 4);
        StringBuilder file = new StringBuilder("""
                v
                from 2.1 1.3 1.7
                at 0 0 0
                up 0 0 1
                angle 45
                hither 1
                resolution 513 513
                b 0.078 0.361 0.753
                l 4 3 2
                l 1 -4 4
                l -3 1 5
                f 1 0.75 0.33 0.8 0 0 0 1
                p 4
                12 12 -0.5
                -12 12 -0.5
                -12 -12 -0.5
                12 -12 -0.5
                f 1 0.9 0.7 0.5 0.5 37 0 0
                """);
        for (SceneObject ball : objects) {
            Vec3 centre = ball.placement().position();
            file.append(String.format(Locale.ROOT, "s %g %g %g %g%n", centre.x(), centre.y(), centre.z(), ((Sphere) ball.shape()).radius()));
        }
        Notes notes = new Notes();
        Scene scene = NffReader.read(new ByteArrayInputStream(file.toString().getBytes(StandardCharsets.US_ASCII)), notes, Mesh::of);
        assertThat(notes.toList()).isEmpty();
        assertThat(scene.objects()).hasSize(7382);
        RenderResult.Stats stats = Renderer.render(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE).stats();
        assertThat(stats.reflected()).as("reflected rays").isCloseTo(175_095, withinPercentage(1));
        assertThat(stats.shadow()).as("shadow rays").isCloseTo(954_368, withinPercentage(1));
    }

    /** Adds a ball and its nine children: six around its equator, three above, in a frame whose z axis is the way it grew itself. */
    private void grow(Vec3 centre, double radius, Vec3 direction, int levels) {
        objects.add(SceneObject.of(new Sphere(radius)).at(centre.x(), centre.y(), centre.z()).madeOf(BALL));
        if (levels == 0) {
            return;
        }
        Affine turned = fromZ(direction);
        for (int i = 0; i < 9; i++) {
            double azimuth = Math.toRadians(i < 6 ? 15 + 60 * i : 45 + 120 * i);
            double z = i < 6 ? 0 : Math.sqrt(2 / 3.0);
            double rho = Math.sqrt(1 - z * z);
            Vec3 child = turned.direction(new Vec3(rho * Math.cos(azimuth), rho * Math.sin(azimuth), z));
            grow(centre.plus(child.times(radius * 4 / 3)), radius / 3, child, levels - 1);
        }
    }

    /** The rotation about z × direction that takes z there. */
    private static Affine fromZ(Vec3 direction) {
        Vec3 axis = Vec3.Z.cross(direction);
        double sine = axis.length();
        double cosine = direction.z();
        if (sine < 1e-12) {
            return cosine > 0 ? Affine.IDENTITY : Affine.scaling(new Vec3(-1, 1, -1));
        }
        Vec3 a = axis.normalized();
        double k = 1 - cosine;
        return new Affine(
                cosine + k * a.x() * a.x(), k * a.x() * a.y() - sine * a.z(), k * a.x() * a.z() + sine * a.y(), 0,
                k * a.x() * a.y() + sine * a.z(), cosine + k * a.y() * a.y(), k * a.y() * a.z() - sine * a.x(), 0,
                k * a.x() * a.z() - sine * a.y(), k * a.y() * a.z() + sine * a.x(), cosine + k * a.z() * a.z(), 0);
    }
}
