package cz.paprsek.cli.bench;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.io.InterruptedIOException;

/** POV-Ray, a process for each picture. */
record PovRayRival(PovRay povRay, Stop stop) implements Rival {
    @Override
    public String label() {
        return "POV-Ray";
    }

    @Override
    public String version() {
        return "POV-Ray " + povRay.version();
    }

    @Override
    public boolean warmsUp() {
        return false;
    }

    @Override
    public double seconds(String name, Scene scene, int threads) throws IOException {
        double[] seconds = new double[1];
        stop.guard(() -> {
            try {
                seconds[0] = povRay.render(scene, threads).traceCpuSeconds();
            } catch (InterruptedException e) {
                throw new InterruptedIOException("interrupted");
            }
        });
        return seconds[0];
    }
}
