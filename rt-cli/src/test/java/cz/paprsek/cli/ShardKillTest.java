package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.ExitCode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Shares of a picture rendered by processes that are killed at random and started again. How many there are is the system property {@code paprsek.shards}, {@value #FEW} if not given;
 * how many kills, {@code paprsek.kills}, as many.
 */
class ShardKillTest {
    private static final int FEW = 2;
    private static final int SHARDS = Integer.getInteger("paprsek.shards", FEW);
    private static final int KILLS = Integer.getInteger("paprsek.kills", SHARDS);
    /** Each share has dozens of parts of 32 × 32, and takes some seconds. */
    private static final List<String> PICTURE = List.of("render", "../scenes/lens.xml", "--size", "256x256", "--samples", "5");

    @TempDir
    Path folder;

    /** Of a film as many frames as the system property {@code paprsek.frames} says, all tiles of which are dealt out one by one. */
    private static final int FRAMES = Integer.getInteger("paprsek.frames", 0);

    /** The words that render a picture, or the frames of a film. */
    private List<String> words() throws IOException {
        List<String> words = new ArrayList<>(PICTURE);
        if (FRAMES > 0) {
            words.subList(4, 6).clear();
            String moving = Files.readString(Path.of(PICTURE.get(1))).replace("</scene>",
                    "<animate target=\"camera:#1\" attribute=\"fovy\"><key t=\"0\" value=\"30\"/><key t=\"1\" value=\"60\"/></animate></scene>");
            words.set(1, Files.writeString(folder.resolve("film.xml"), moving).toString());
            words.addAll(List.of("--frames", "1-" + FRAMES, "--samples", "2"));
        }
        return words;
    }

    private static byte[] sha256(Path folder, String beginning) throws Exception {
        MessageDigest digest = MessageDigest.getInstance("SHA-256");
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.filter(each -> each.getFileName().toString().startsWith(beginning)).sorted().toList()) {
                digest.update(Files.readAllBytes(file));
            }
        }
        return digest.digest();
    }

    @Test
    void sharesKilledAgainAndAgainAreTheSamePictureAndNoPartIsMadeTwice() throws Exception {
        List<String> words = words();
        Run whole = Run.cli(Stream.concat(words.stream(), Stream.of("-o", folder.resolve("whole.png"))).toArray());
        assertThat(whole.code()).as(whole.err()).isEqualTo(ExitCode.DONE);
        Path parts = Files.createDirectories(folder.resolve("parts"));
        List<Process> workers = new ArrayList<>();
        for (int i = 1; i <= SHARDS; i++) {
            workers.add(started(words, i, parts));
        }
        Random random = new Random(4);
        Map<Path, Object> known = new TreeMap<>();
        int hit = 0;
        for (int kill = 0; kill < KILLS; kill++) {
            Process victim = workers.get(kill % SHARDS);
            victim.waitFor(300 + random.nextInt(1700), TimeUnit.MILLISECONDS);
            hit += victim.isAlive() ? 1 : 0;
            victim.destroyForcibly().waitFor();
            known.putAll(unchanged(parts, known));
            workers.set(kill % SHARDS, started(words, kill % SHARDS + 1, parts));
        }
        for (Process worker : workers) {
            assertThat(worker.waitFor()).isEqualTo(ExitCode.DONE);
        }
        assertThat(hit).as("kills that met a process at work").isPositive();
        assertThat(unchanged(parts, known)).hasSize(64 * Math.max(1, FRAMES));
        assertThat(Run.cli("merge", parts, "-o", folder.resolve("merged.png")).code()).isEqualTo(ExitCode.DONE);
        assertThat(sha256(folder, "merged")).isEqualTo(sha256(folder, "whole"));
    }

    /** The parts that are there, each the very file that it was before: who is killed loses what was under way, one part of a thread, and nothing else. */
    private static Map<Path, Object> unchanged(Path parts, Map<Path, Object> known) throws IOException {
        Map<Path, Object> keys = new TreeMap<>();
        try (Stream<Path> files = Files.walk(parts)) {
            for (Path file : files.filter(each -> each.toString().endsWith(".part")).toList()) {
                BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
                keys.put(file, now.lastModifiedTime() + " " + now.fileKey());
            }
        }
        assertThat(keys).containsAllEntriesOf(known);
        return keys;
    }

    private static Process started(List<String> words, int shard, Path parts) throws IOException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-XX:TieredStopAtLevel=1", "-cp",
                System.getProperty("java.class.path"), Main.class.getName()));
        command.addAll(words);
        command.addAll(List.of("--threads", "1", "--shard", shard + "/" + SHARDS, "-o", parts.toString(), "--quiet"));
        return new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
    }
}
