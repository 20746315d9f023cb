package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Several processes, each with several threads, that all change one database. */
class DatabaseWritersTest {
    private static final int PROCESSES = 3;
    private static final int THREADS = 2;
    private static final int EACH = 25;

    @Test
    void noneOfManyWritersLosesAnything(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("db.xml");
        DatabaseFile.create(file).save(SceneDatabase.EMPTY);
        List<Process> processes = new ArrayList<>();
        for (int i = 0; i < PROCESSES; i++) {
            processes.add(new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                    System.getProperty("java.class.path"), Writer.class.getName(), file.toString(), "process " + i).inheritIO().start());
        }
        for (Process process : processes) {
            assertThat(process.waitFor()).isZero();
        }
        assertThat(SceneFiles.readDatabase(file).size()).isEqualTo(PROCESSES * THREADS * EACH);
        assertThat(folder).isDirectoryNotContaining("glob:**.lock");
    }

    /** One of the processes. */
    static final class Writer {
        private Writer() {}

        public static void main(String[] arguments) throws Exception {
            ExecutorService threads = Executors.newFixedThreadPool(THREADS);
            List<Future<?>> running = new ArrayList<>();
            for (int i = 0; i < THREADS; i++) {
                String name = arguments[1] + " thread " + i;
                running.add(threads.submit(() -> write(Path.of(arguments[0]), name)));
            }
            threads.shutdown();
            for (Future<?> thread : running) {
                thread.get();
            }
        }

        private static boolean write(Path file, String name) throws IOException, SceneFileException {
            for (int i = 0; i < EACH; i++) {
                Scene scene = Scene.EMPTY.withName(name + " scene " + i);
                DatabaseFile.update(file, database -> database.plus(scene));
            }
            return true;
        }
    }
}
