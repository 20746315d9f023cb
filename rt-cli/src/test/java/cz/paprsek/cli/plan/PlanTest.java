package cz.paprsek.cli.plan;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.Scenes;
import cz.paprsek.cli.process.ExitCode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What clusters are told: read by shells, run with a Slurm of three lines, and held against Kubernetes' own description of its types. */
class PlanTest {
    private static final String HARD = "it's $(HOME) & \"more\"";

    @TempDir
    Path folder;

    /** Words of the command line that a manifest or a script is of. */
    private String plan(String... words) throws IOException {
        Scenes.ball(folder.resolve("ball.xml"));
        Run run = Run.cli(Stream.concat(Stream.of("plan"), Stream.of(words)).toArray());
        assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.DONE);
        return run.text();
    }

    @Test
    void everyMemberOfAManifestIsOneThatKubernetesKnows() throws IOException {
        Map<String, String> types = types();
        Path scene = Path.of("").toAbsolutePath().relativize(Scenes.ball(folder.resolve("ball.xml")).toAbsolutePath());
        List<Object> documents = Manifest.documents(plan(scene.toString(), "--kubernetes", "--shards", "12", "--parallel", "5"));
        assertThat(documents).hasSize(3);
        for (Object document : documents) {
            check(types, String.valueOf(map(document).get("kind")), document);
        }
        assertThat(documents.stream().map(each -> map(each).get("kind"))).containsExactly("PersistentVolumeClaim", "Job", "Job");
        Map<String, Object> spec = map(in(documents.get(1), "spec"));
        assertThat(spec).containsEntry("completionMode", "Indexed").containsEntry("completions", 12).containsEntry("parallelism", 5).containsEntry("backoffLimitPerIndex", 6);
        assertThat(in(spec, "template", "spec", "containers").toString()).contains("{name=PAPRSEK_JAVA_OPTIONS, value=-Xmx1536m -XX:ActiveProcessorCount=1}");
        assertThat(in(spec, "podFailurePolicy").toString()).isEqualTo("{rules=[{action=FailJob, onExitCodes={containerName=render, operator=In, values=[2, 3]}}, "
                + "{action=Ignore, onPodConditions=[{type=DisruptionTarget, status=True}]}]}");
        assertThat(Manifest.documents(plan(scene.toString(), "--kubernetes", "--claim", "scenes"))).hasSize(2);
    }

    private static void check(Map<String, String> types, String type, Object value) {
        if (type.startsWith("list[")) {
            ((List<?>) value).forEach(item -> check(types, type.substring(5, type.length() - 1), item));
        } else if (type.startsWith("map(")) {
            assertThat(map(value).values()).allMatch(String.class::isInstance);
        } else if (type.equals("str") || type.equals("int") || type.equals("bool")) {
            assertThat(value).isInstanceOf(type.equals("str") ? String.class : type.equals("int") ? Integer.class : Boolean.class);
        } else {
            types.keySet().stream().filter(key -> key.startsWith(type + " ") && key.endsWith(" required")).forEach(key -> assertThat(map(value)).containsKey(key.split(" ", -1)[1]));
            map(value).forEach((key, member) -> {
                String known = Objects.requireNonNullElse(types.get(type + " " + key), types.getOrDefault(type + " " + key + " required", ""));
                assertThat(known).as("%s has a member %s", type, key).isNotEmpty();
                check(types, known, member);
            });
        }
    }

    private static Object in(Object value, String... keys) {
        Object found = value;
        for (String key : keys) {
            found = Objects.requireNonNull(map(found).get(key), key);
        }
        return found;
    }

    @SuppressWarnings("unchecked")
    private static Map<String, Object> map(Object value) {
        return (Map<String, Object>) value;
    }

    private static Map<String, String> types() throws IOException {
        Map<String, String> types = new TreeMap<>();
        String text = new String(Objects.requireNonNull(PlanTest.class.getResourceAsStream("kubernetes-1.33.txt")).readAllBytes(), StandardCharsets.UTF_8);
        text.lines().filter(line -> !line.startsWith("#")).map(line -> line.replace("map(str, str)", "map(str)").split(" ", -1)).forEach(words ->
                types.put(words[0] + " " + words[1] + (words.length > 3 ? " required" : ""), words[2]));
        return types;
    }

    /** As the cluster does it: with two dollars made one, and the index in the environment. */
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aPodGetsTheWordsThatWereGiven() throws Exception {
        Path scene = Path.of("").toAbsolutePath().relativize(Scenes.ball(folder.resolve("ball.xml")).toAbsolutePath());
        List<Object> documents = Manifest.documents(plan(scene.toString(), "--kubernetes", "--shards", "4", "--parts", HARD));
        program("paprsek", "for word; do echo \"[$word]\"; done");
        for (int job = 1; job <= 2; job++) {
            Object container = ((List<?>) in(documents.get(job), "spec", "template", "spec", "containers")).get(0);
            List<?> command = (List<?>) in(container, "command");
            List<String> words = command.stream().map(word -> word.toString().replace("$$", "$")).toList();
            String said = run(Map.of("JOB_COMPLETION_INDEX", "2"), words.toArray(String[]::new));
            assertThat(said).contains(job == 1 ? "[render]\n[" + scene + "]\n[--threads]\n[1]\n[--shard]\n[3/4]\n[-o]\n[" + HARD + "]\n" : "[merge]\n[" + HARD + "]\n[-o]\n[ball.png]\n[--wait]\n");
        }
    }

    /** A Slurm that runs each job at once, in its own place. */
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void slurmIsGivenEveryShareOnceAndThenTheMerge() throws Exception {
        String scene = Scenes.ball(folder.resolve("ball.xml")).toString();
        Path script = Files.writeString(folder.resolve("plan.sh"), plan(scene, "--slurm", "--shards", "1003", "--parallel", "7", "--cpus", "3", "--parts", HARD));
        assertThat(run(Map.of(), "bash", "-n", script.toString())).isEmpty();
        program("sbatch", """
                cat > job
                echo "sbatch $*" >> calls
                range=; first=0
                for word; do case $word in --array=1-*) range=${word#--array=1-} ;; --export=*) first=${word##*=} ;; esac; done
                for i in 1 ${range%%%*}; do SLURM_ARRAY_TASK_ID=$i PAPRSEK_FIRST=$first sh job; [ -z "$range" ] && break; done >> calls
                echo "77;cluster"
                """);
        program("paprsek", "echo \"paprsek $*\"\necho \"java $PAPRSEK_JAVA_OPTIONS\"");
        run(Map.of(), "sh", script.toString());
        List<String> calls = Files.readAllLines(folder.resolve("calls"));
        assertThat(calls).filteredOn(call -> call.startsWith("paprsek")).containsExactly(
                "paprsek render " + scene + " --threads 3 --shard 1/1003 -o " + HARD, "paprsek render " + scene + " --threads 3 --shard 1000/1003 -o " + HARD,
                "paprsek render " + scene + " --threads 3 --shard 1001/1003 -o " + HARD, "paprsek render " + scene + " --threads 3 --shard 1003/1003 -o " + HARD,
                "paprsek merge " + HARD + " -o ball.png");
        assertThat(calls).filteredOn(call -> call.startsWith("java")).as("Java helps itself to what was asked for, not to the whole node").endsWith("java -Xmx1536m -XX:ActiveProcessorCount=1")
                .filteredOn(call -> call.equals("java -Xmx1536m -XX:ActiveProcessorCount=3")).hasSize(4);
        assertThat(calls).filteredOn(call -> call.startsWith("sbatch")).hasSize(3);
        assertThat(calls.get(0)).contains("--array=1-1000%7", "--mem=2048M", "--requeue");
        assertThat(calls).filteredOn(call -> call.contains("-merge")).singleElement().asString().contains("--dependency=afterany:77:77 ");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void whatIsWrongIsNotTriedAgainAndWhatFailedIs() throws Exception {
        Path script = Files.writeString(folder.resolve("plan.sh"), plan(Scenes.ball(folder.resolve("ball.xml")).toString(), "--slurm", "--shards", "1"));
        program("sbatch", "cat > job; SLURM_ARRAY_TASK_ID=1 PAPRSEK_FIRST=0 sh job >> calls; echo $? >> calls; echo 5");
        for (String[] each : new String[][] {{"3", "render 3"}, {"2", "render 2"}, {"1", "render render render 1"}, {"137", "render render render 137"}}) {
            Files.deleteIfExists(folder.resolve("calls"));
            program("paprsek", "echo $1; exit " + each[0]);
            run(Map.of(), "sh", script.toString());
            assertThat(String.join(" ", Files.readAllLines(folder.resolve("calls")))).startsWith(each[1] + " merge");
        }
    }

    @Test
    void whatIsWrongIsToldBeforeAnythingIsWritten() throws IOException {
        String scene = Scenes.ball(folder.resolve("ball.xml")).toString();
        Map<List<String>, String> mistakes = new TreeMap<>(Comparator.comparing(List::toString));
        mistakes.put(List.of(scene), "say for what: --slurm or --kubernetes");
        mistakes.put(List.of(scene, "--slurm", "--shards", "0"), "--shards must be from 1 to 1000000, but is 0");
        mistakes.put(List.of(scene, "--slurm", "--", "--sise", "3x3"), "the options after -- are not those of render: ");
        mistakes.put(List.of(scene, "--slurm", "--", "--resume"), "--shard is without --resume");
        mistakes.put(List.of(scene, "--slurm", "--", "--region", "0,0,99,99"), "must lie inside the picture of 16");
        mistakes.put(List.of(scene, "--kubernetes"), "name the scene from the folder that will be on the volume");
        mistakes.put(List.of(scene, "--slurm", "--", "--aov", "depth"), "png has no layers; --aov needs a picture in exr");
        mistakes.put(List.of(scene, "--slurm", "--picture", "a.exr", "--", "--mode", "depth"), "parts for exr must hold numbers; add --format exr");
        mistakes.put(List.of(scene, "--slurm", "--picture", "a.picture"), "cannot tell the format of 'a.picture'");
        mistakes.forEach((words, sentence) -> {
            Run run = Run.cli(Stream.concat(Stream.of("plan"), words.stream()).toArray());
            assertThat(run.err()).contains(sentence);
            assertThat(run.code()).isEqualTo(ExitCode.WRONG_USAGE);
            assertThat(run.text()).isEmpty();
        });
        Run broken = Run.cli("plan", Scenes.broken(folder.resolve("broken.xml")), "--slurm");
        assertThat(broken.code()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(broken.text()).isEmpty();
    }

    /** Parameters count, and files that are elsewhere. */
    @Test
    void theSceneIsReadAsRenderWillReadIt() throws IOException {
        Path library = Files.createDirectories(folder.resolve("lib"));
        Files.writeString(library.resolve("more.xml"), "<scene xmlns=\"urn:paprsek:scene:1\"><camera position=\"0 0 9\" target=\"0 0 0\"/><sphere radius=\"1\"/></scene>");
        Path scene = Files.writeString(folder.resolve("s.xml"), """
                <scene xmlns="urn:paprsek:scene:1">
                  <param name="w" value="32"/>
                  <include file="more.xml"/>
                  <render width="{w}" height="32"/>
                  <camera position="0 0 9" target="0 0 0"/>
                </scene>
                """);
        Run small = Run.cli("plan", scene, "--slurm", "--", "--assets", library);
        assertThat(small.code()).as(small.err()).isEqualTo(ExitCode.DONE);
        assertThat(small.err()).contains("of 8 shares 7 have nothing to do");
        Run wide = Run.cli("plan", scene, "--slurm", "--", "--assets", library, "-D", "w=800");
        assertThat(wide.code()).as(wide.err()).isEqualTo(ExitCode.DONE);
        assertThat(wide.err()).isEmpty();
    }

    @Test
    void aFileIsWrittenWhereOneIsWishedFor() throws IOException {
        Path scene = Scenes.ball(folder.resolve("Žluťoučký kůň (2).xml"));
        Run run = Run.cli("plan", scene, "--slurm", "-o", folder.resolve("plans"), "--shards", "1");
        assertThat(run.out()).isEqualTo(folder.resolve("plans/zlutoucky-kun-2.slurm.sh") + "\n");
        assertThat(folder.resolve("plans/zlutoucky-kun-2.slurm.sh")).content().isEqualTo(Run.cli("plan", scene, "--slurm", "--shards", "1").text());
    }

    private void program(String name, String lines) throws IOException {
        Path file = Files.writeString(Files.createDirectories(folder.resolve("bin")).resolve(name), "#!/bin/sh\n" + lines + "\n");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    /** What a program says that is started in the folder, with those of the folder before all others. */
    private String run(Map<String, String> environment, String... words) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(words).directory(folder.toFile()).redirectErrorStream(true);
        builder.environment().putAll(environment);
        builder.environment().put("PATH", folder.resolve("bin") + ":" + System.getenv("PATH"));
        Process process = builder.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return said;
    }
}
