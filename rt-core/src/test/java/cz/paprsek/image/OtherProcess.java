package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A Java of its own, with limits that a test cannot set for itself. */
final class OtherProcess {
    private OtherProcess() {}

    /** What it writes to standard output; fails if it fails. The words are options, a class, arguments. */
    static byte[] output(String... words) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp", System.getProperty("java.class.path"), "-Djava.awt.headless=true"));
        command.addAll(List.of(words));
        Path errors = Files.createTempFile("errors", ".txt");
        try {
            Process process = new ProcessBuilder(command).redirectError(errors.toFile()).start();
            byte[] output = process.getInputStream().readAllBytes();
            assertThat(process.waitFor()).as(Files.readString(errors, StandardCharsets.UTF_8)).isZero();
            return output;
        } finally {
            Files.delete(errors);
        }
    }
}
