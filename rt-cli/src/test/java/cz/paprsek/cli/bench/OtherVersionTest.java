package cz.paprsek.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.scene.Scene;
import java.net.URI;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OtherVersionTest {
    @TempDir
    Path folder;

    @Test
    void anotherVersionIsMeasuredInTurn() throws Exception {
        Path jar = folder.resolve("old.jar");
        try (FileSystem archive = FileSystems.newFileSystem(URI.create("jar:" + jar.toUri()), Map.of("create", "true"))) {
            copy(Scene.class, archive.getPath("/"));
            copy(BenchScenes.class, archive.getPath("/"));
        }
        Run run = Run.cli("bench", "--scene", "few,chain10", "--size", "32x18", "--rounds", 2, "--against-jar", jar);
        assertThat(run.err()).isEmpty();
        assertThat(run.out().lines().skip(2)).hasSize(2).allMatch(row -> row.strip().matches("\\w+( +[0-9.]+){14}"));
    }

    @Test
    void whatIsNoJarOfOursIsRefused() throws Exception {
        Path other = Files.writeString(folder.resolve("other.jar"), "no archive");
        assertThat(Run.cli("bench", "--against-jar", folder.resolve("none.jar")).err()).contains("there is no file ", "none.jar");
        assertThat(Run.cli("bench", "--against-jar", other).err()).contains("other.jar is no jar of this program");
        assertThat(Run.cli("bench", "--against-jar", other).code()).isEqualTo(ExitCode.WRONG_USAGE);
    }

    /** Copies the classes beside which one lies, from a folder or a jar. */
    private static void copy(Class<?> one, Path to) throws Exception {
        Path from = Path.of(one.getProtectionDomain().getCodeSource().getLocation().toURI());
        if (Files.isDirectory(from)) {
            copy(from, to);
        } else {
            try (FileSystem archive = FileSystems.newFileSystem(from)) {
                copy(archive.getPath("/"), to);
            }
        }
    }

    private static void copy(Path from, Path to) throws Exception {
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : files.filter(f -> f.toString().endsWith(".class")).toList()) {
                Path target = to.resolve(from.relativize(file).toString());
                Files.createDirectories(target.getParent());
                Files.copy(file, target, java.nio.file.StandardCopyOption.REPLACE_EXISTING);
            }
        }
    }
}
