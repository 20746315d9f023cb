package cz.paprsek.render.join;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.render.TileStore;
import cz.paprsek.render.film.Film;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Not only the picture, whose colours are rounded, but every number that is kept of the sums is that of one machine. */
class JoinedPassesTest {
    private static final int WIDTH = 36;
    private static final int HEIGHT = 20;
    private static final int PASSES = 5;
    private static final int PASS = RenderSettings.USUAL_PATHS;
    private static final Scene SCENE = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 1, 4), new Vec3(0, 0.5, 0)))
            .withBackground(new Rgb(40, 60, 90)).withLights(List.of(SphereLight.of(new Vec3(1, 3, 1), 0.5).withIntensity(2)))
            .plus(SceneObject.of(new Rectangle(-3, -3, 3, 3)).rotated(-90, 0, 0)).plus(SceneObject.of(new Sphere(0.6)).at(0, 0.6, 0));

    /** What is kept after each pass, pixel by pixel; of a pass by itself, after the paths before it, of which nothing is told but their number. */
    private static final class Kept implements TileStore {
        private final int from;
        private final int size;
        private final int before;
        private final List<float[][]> passes = new ArrayList<>();

        Kept(int from, int size, int before) {
            this.from = from;
            this.size = size;
            this.before = before;
            for (int i = 0; i < PASSES; i++) {
                passes.add(new float[WIDTH * HEIGHT][size]);
            }
        }

        @Override
        public boolean load(Tile tile, int pass, Film into) {
            if (before == 0) {
                return false;
            }
            float[] none = new float[into.channels()];
            none[from] = before;
            for (int i = 0; i < tile.width() * tile.height(); i++) {
                into.setChannels(tile.x() + i % tile.width(), tile.y() + i / tile.width(), none);
            }
            return true;
        }

        @Override
        public synchronized void save(Tile tile, int pass, Film film) {
            for (int y = tile.y(); y < tile.y() + tile.height(); y++) {
                for (int x = tile.x(); x < tile.x() + tile.width(); x++) {
                    int made = (int) film.channel(from, x, y) / PASS;
                    for (int i = 0; i < size; i++) {
                        passes.get(made - 1)[y * WIDTH + x][i] = film.channel(from + i, x, y);
                    }
                }
            }
        }
    }

    private static Kept rendered(PixelFilter filter, int before, int paths) throws IOException {
        RenderOptions options = RenderOptions.of(new RenderSettings(WIDTH, HEIGHT, 4, 1).withIntegrator(Integrator.PATH).withSamples(paths).withFilter(filter));
        Kept kept = new Kept(options.keptFrom(SCENE), JoinedPasses.size(filter), before);
        Renderer.render(SCENE, Assets.none(), options, RenderMonitor.NONE, kept);
        return kept;
    }

    /** After every pass, with and without what a filter takes away. */
    @ParameterizedTest
    @EnumSource(value = PixelFilter.class, names = {"BOX", "MITCHELL"})
    void everyNumberThatIsKeptIsThatOfOneMachine(PixelFilter filter) throws IOException {
        Kept whole = rendered(filter, 0, PASSES * PASS);
        JoinedPasses joined = new JoinedPasses(WIDTH, HEIGHT, filter);
        float[] now = new float[JoinedPasses.size(filter)];
        for (int pass = 0; pass < PASSES; pass++) {
            float[][] alone = rendered(filter, pass * PASS, (pass + 1) * PASS).passes.get(pass);
            float[][] expected = whole.passes.get(pass);
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                joined.add(i % WIDTH, i / WIDTH, alone[i]);
                joined.copy(i % WIDTH, i / WIDTH, now);
                for (int k = 0; k < now.length; k++) {
                    assertThat(Float.floatToRawIntBits(now[k])).as("number %d of pixel %d after pass %d: %s and not %s", k, i, pass + 1, now[k], expected[i][k])
                            .isEqualTo(Float.floatToRawIntBits(expected[i][k]));
                }
            }
        }
    }
}
