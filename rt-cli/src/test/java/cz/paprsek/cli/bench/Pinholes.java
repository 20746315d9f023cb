package cz.paprsek.cli.bench;

import cz.paprsek.image.Image;
import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.io.IOException;
import java.util.Locale;

/** A thin lens as the mean of sheared pinholes of POV-Ray's, one for each of the points that the fixed sampler has in every pixel. */
final class Pinholes {
    private final Camera camera;
    private final int width;
    private final int height;
    private final int perSide;

    private Pinholes(Scene scene) {
        camera = scene.camera();
        width = scene.settings().width();
        height = scene.settings().height();
        perSide = scene.settings().samples();
    }

    /** What POV-Ray makes of a scene whose samples are a grid. */
    static Image mean(PovRay povRay, Scene scene) throws IOException, InterruptedException {
        return new Pinholes(scene).mean(povRay, words(scene));
    }

    private static String words(Scene scene) throws IOException {
        StringBuilder words = new StringBuilder();
        PovFiles.write(scene, words);
        return words.toString();
    }

    private Image mean(PovRay povRay, String words) throws IOException, InterruptedException {
        int count = perSide * perSide;
        double[][] sums = new double[3][width * height];
        Sampler sampler = Sampler.fixed(count);
        for (int k = 0; k < count; k++) {
            sampler.start(0, 0, k);
            sampler.lens();
            sampler.next();
            String pinhole = words.replaceFirst("(?m)^camera \\{.*$", "camera { " + pinhole(k, sampler) + " }");
            Image theirs = povRay.render(pinhole, width, height);
            for (int i = 0; i < width * height; i++) {
                sums[0][i] += theirs.red(i % width, i / width);
                sums[1][i] += theirs.green(i % width, i / width);
                sums[2][i] += theirs.blue(i % width, i / width);
            }
        }
        Image mean = new Image(width, height);
        double share = 1.0 / count;
        for (int i = 0; i < width * height; i++) {
            mean.set(i % width, i / width, (float) (share * sums[0][i]), (float) (share * sums[1][i]), (float) (share * sums[2][i]));
        }
        return mean;
    }

    /** From the lens's point, through the plane in focus, and through the sample's place within the pixel. */
    private String pinhole(int k, Sampler sampler) {
        Ray ray = new Ray(new Spans());
        Eye.of(camera, width, height).start(ray, 1, 1, sampler.u, sampler.v);
        Vec3 start = new Vec3(ray.ox, ray.oy, ray.oz);
        double high = 2 * Angles.tan(((Lens.Perspective) camera.lens()).fovy() / 2) * camera.focus();
        Vec3 up = camera.trueUp().times(high);
        Vec3 right = camera.right().times(high * width / height);
        int row = k / perSide;
        Vec3 aside = right.times(((k % perSide + 0.5) / perSide - 0.5) / width).plus(up.times((0.5 - (row + 0.5) / perSide) / height));
        Vec3 direction = camera.forward().times(camera.focus()).minus(start.minus(camera.position())).plus(aside);
        return "perspective location " + words(start) + " direction " + words(direction) + " up " + words(up) + " right " + words(right);
    }

    private static String words(Vec3 v) {
        return String.format(Locale.ROOT, "<%.17g, %.17g, %.17g>", v.x(), v.y(), v.z());
    }
}
