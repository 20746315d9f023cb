package cz.paprsek.pov;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** POV-Ray has no twisted prism, and is told a mesh. */
class PovTwistedTest {
    /** A ring whose hole runs the other way, and a star. */
    private static final String RING = "M 1 0 A 1 1 0 1 1 -1 0 A 1 1 0 1 1 1 0 Z M 0.4 -0.4 L -0.4 -0.4 L -0.4 0.4 L 0.4 0.4 Z";
    private static final String STAR = "M 1 0 L 0.3 0.3 L 0 1 L -0.3 0.3 L -1 0 L -0.3 -0.3 L 0 -1 L 0.3 -0.3 Z";

    /** Turning slices keeps their areas: volume = area · height · (1 + s + s²)/3. */
    @ParameterizedTest
    @CsvSource({"30,1", "-200,1", "360,0.5", "90,0", "720,2"})
    void theMeshEnclosesTheVolumeOfTheBody(double twist, double taper) {
        double share = 2 * (1 + taper + taper * taper) / 3;
        assertThat(volume(new Extrude(RING, "", 2, twist, taper))).isCloseTo((Math.PI - 0.64) * share, within(0.003 * share));
        assertThat(volume(new Extrude(STAR, "", 2, twist, taper))).isCloseTo(1.2 * share, within(0.003 * share));
    }

    private static double volume(Extrude body) {
        Triangles mesh = PovTwisted.of(body);
        double sum = 0;
        for (int i = 0; i < mesh.count(); i++) {
            Vec3 a = mesh.place(mesh.corner(i, 0));
            Vec3 b = mesh.place(mesh.corner(i, 1));
            Vec3 c = mesh.place(mesh.corner(i, 2));
            sum += a.dot(b.cross(c)) / 6;
            Vec3 across = b.minus(a).cross(c.minus(a));
            assertThat(mesh.normal(mesh.corner(i, 0)).normalized().dot(across)).as("outwards").isGreaterThan(-1e-9);
        }
        return sum;
    }

    @Test
    void theEndsAreWhatIsInsideByTheEvenOddRule() {
        Random random = new Random(3);
        for (int round = 0; round < 50; round++) {
            List<Vec3> polygon = new ArrayList<>();
            for (int i = 0; i < 9; i++) {
                polygon.add(new Vec3(random.nextInt(7), random.nextInt(7), 0));
            }
            polygon.add(polygon.get(0));
            List<Vec3[]> found = new ArrayList<>();
            new PovFlats(List.of(polygon)).triangles((a, b, c) -> {
                assertThat(b.minus(a).cross(c.minus(a)).z()).isGreaterThanOrEqualTo(0);
                found.add(new Vec3[] {a, b, c});
            });
            for (int i = 0; i < 200; i++) {
                double x = random.nextDouble() * 7;
                double y = random.nextDouble() * 7;
                assertThat(found.stream().filter(triangle -> isInside(List.of(triangle[0], triangle[1], triangle[2], triangle[0]), x, y)).count())
                        .isEqualTo(isInside(polygon, x, y) ? 1 : 0);
            }
        }
    }

    private static boolean isInside(List<Vec3> polygon, double x, double y) {
        boolean inside = false;
        for (int i = 0; i + 1 < polygon.size(); i++) {
            Vec3 a = polygon.get(i);
            Vec3 b = polygon.get(i + 1);
            inside ^= (a.y() > y) != (b.y() > y) && x < a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
        }
        return inside;
    }

    @Test
    void itIsToldAsAMeshWithAnInside() throws IOException {
        StringBuilder text = new StringBuilder();
        Scene scene = Scene.EMPTY.plus(SceneObject.of(new Extrude(STAR, "", 2, 90, 1)).named("screw"));
        assertThat(PovFiles.write(scene, text))
                .contains("\"screw\" is twisted, as nothing is that POV-Ray sweeps; it is told a mesh instead, off by up to about 1/2000 of its radius");
        Scene turns = Scene.EMPTY.plus(SceneObject.of(new Extrude(STAR, "", 2, 36_000, 1)).named("screw"));
        assertThat(PovFiles.write(turns, new StringBuilder())).anyMatch(sentence -> sentence.matches(".*, off by up to about 1/\\d{2,3} of its radius"));
        assertThat(text.toString()).contains("mesh2 {").contains("inside_vector").doesNotContain("prism");
    }
}
