package cz.paprsek.cli.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.cli.Main;
import cz.paprsek.cli.Run;
import cz.paprsek.cli.process.ExitCode;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.SecureRandom;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * A plan handed to a real Slurm, of which this machine is the only node: the distribution's own slurmctld, slurmd and munged (packages slurm-wlm and munge), started as root with all they need in a
 * folder of their own and ended by their process files. Only with the system property {@code paprsek.slurm=true}.
 */
@EnabledIfSystemProperty(named = "paprsek.slurm", matches = "true")
class SlurmTest {
    private static final int MOST_SECONDS = 300;

    @TempDir
    Path folder;

    @BeforeEach
    void slurmIsStarted() throws Exception {
        assumeTrue(Stream.of("/usr/sbin/slurmctld", "/usr/sbin/slurmd", "/usr/sbin/munged", "/usr/bin/sbatch").map(Path::of).allMatch(Files::exists), "there is no Slurm");
        assumeTrue("root".equals(System.getProperty("user.name")), "Slurm's node must be started by root");
        byte[] key = new byte[1024];
        new SecureRandom().nextBytes(key);
        Files.setPosixFilePermissions(Files.write(folder.resolve("key"), key), PosixFilePermissions.fromString("r--------"));
        Files.createDirectories(folder.resolve("state"));
        Files.createDirectories(folder.resolve("spool"));
        String host = InetAddress.getLocalHost().getHostName().split("\\.", -1)[0];
        Files.writeString(folder.resolve("slurm.conf"), """
                ClusterName=paprsek
                SlurmctldHost=@HOST(127.0.0.1)
                SlurmctldPort=26817
                SlurmdPort=26818
                SlurmUser=root
                AuthType=auth/munge
                AuthInfo=socket=@/munge.socket
                StateSaveLocation=@/state
                SlurmdSpoolDir=@/spool
                SlurmctldPidFile=@/slurmctld.pid
                SlurmdPidFile=@/slurmd.pid
                SlurmctldLogFile=@/slurmctld.log
                SlurmdLogFile=@/slurmd.log
                ProctrackType=proctrack/linuxproc
                TaskPlugin=task/none
                SelectType=select/cons_tres
                SelectTypeParameters=CR_CPU
                ReturnToService=2
                JobRequeue=1
                MailProg=/bin/true
                NodeName=@HOST NodeAddr=127.0.0.1 CPUs=2 RealMemory=2500 State=UNKNOWN
                PartitionName=main Nodes=@HOST Default=YES State=UP
                """.replace("@HOST", host).replace("@", folder.toString()));
        run("munged", "--force", "--socket=" + folder.resolve("munge.socket"), "--key-file=" + folder.resolve("key"), "--pid-file=" + folder.resolve("munged.pid"),
                "--log-file=" + folder.resolve("munged.log"), "--seed-file=" + folder.resolve("seed"));
        run("slurmctld", "-f", folder.resolve("slurm.conf").toString());
        run("slurmd", "-f", folder.resolve("slurm.conf").toString());
        Path program = Files.createDirectories(folder.resolve("bin")).resolve("paprsek");
        Files.writeString(program, "#!/bin/sh\nexec '" + Path.of(System.getProperty("java.home"), "bin", "java") + "' -XX:TieredStopAtLevel=1 -cp '" + System.getProperty("java.class.path") + "' "
                + Main.class.getName() + " \"$@\"\n");
        Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    @AfterEach
    void slurmIsEnded() throws IOException {
        for (String name : List.of("slurmd", "slurmctld", "munged")) {
            Path file = folder.resolve(name + ".pid");
            if (Files.exists(file)) {
                Optional<ProcessHandle> process = ProcessHandle.of(Long.parseLong(Files.readString(file).strip()));
                process.ifPresent(ProcessHandle::destroy);
                process.ifPresent(each -> each.onExit().orTimeout(20, TimeUnit.SECONDS).join());
            }
        }
    }

    @Test
    void tasksKilledWhileTheyRunAreTriedAgainAndThePictureIsTheSame() throws Exception {
        Path whole = folder.resolve("whole.png");
        String scene = Path.of("../scenes/lens.xml").toRealPath().toString();
        List<String> options = List.of("--size", "256x256", "--samples", "6");
        assertThat(Run.cli(Stream.concat(Stream.of("render", scene, "-o", whole), options.stream()).toArray()).code()).isEqualTo(ExitCode.DONE);
        Run plan = Run.cli(Stream.concat(Stream.of("plan", scene, "--slurm", "--shards", "4", "--memory", "1000", "--program", folder.resolve("bin/paprsek"), "-o", folder, "--"), options.stream()).toArray());
        assertThat(plan.code()).as(plan.err()).isEqualTo(ExitCode.DONE);
        run("sh", folder.resolve("lens.slurm.sh").toString());
        Set<String> killed = new TreeSet<>();
        Path picture = folder.resolve("lens.png");
        for (int tenth = 0; tenth < 10 * MOST_SECONDS && !Files.exists(picture); tenth++) {
            if (tenth % 15 == 14) {
                killOne(killed);
            }
            TimeUnit.MILLISECONDS.sleep(100);
        }
        assertThat(killed).hasSize(4);
        assertThat(picture).hasSameBinaryContentAs(whole);
        assertThat(run("squeue", "--noheader", "--states=PENDING")).isEmpty();
    }

    @Test
    void aSceneThatIsGoneIsNotTriedAgainAndTheMergeSaysWhatIsMissing() throws Exception {
        Path scene = Files.copy(Path.of("../scenes/lens.xml"), folder.resolve("lens.xml"));
        assertThat(Run.cli("plan", scene, "--slurm", "--shards", "2", "--memory", "1000", "--program", folder.resolve("bin/paprsek"), "-o", folder).code()).isEqualTo(ExitCode.DONE);
        Files.delete(scene);
        run("sh", folder.resolve("lens.slurm.sh").toString());
        Path log = folder.resolve("lens.parts/merge.log");
        for (int tenth = 0; tenth < 10 * MOST_SECONDS && !(Files.exists(log) && Files.size(log) > 0); tenth++) {
            TimeUnit.MILLISECONDS.sleep(100);
        }
        assertThat(log).content().contains("there is no part of a picture in it");
        try (Stream<Path> logs = Files.list(folder.resolve("lens.parts"))) {
            assertThat(logs.filter(file -> file.getFileName().toString().startsWith("render-"))).hasSize(2).allSatisfy(file -> assertThat(file).content().containsOnlyOnce("lens.xml"));
        }
    }

    /** Kills a process that renders a share of this test's, if there is one that has not been killed before. */
    private void killOne(Set<String> killed) {
        ProcessHandle.allProcesses().filter(process -> share(process).filter(share -> !killed.contains(share)).isPresent()).findAny().ifPresent(victim -> {
            killed.add(share(victim).orElse(""));
            victim.destroyForcibly();
        });
    }

    /** Whose work a process does: the words after --shard. */
    private static Optional<String> share(ProcessHandle process) {
        return process.info().commandLine().filter(line -> line.contains(Main.class.getName()) && line.contains("--shard ") && line.endsWith("lens.parts"))
                .map(line -> line.replaceFirst(".*--shard ", ""));
    }

    private String run(String... words) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(words).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(folder.resolve("said").toFile());
        builder.environment().put("SLURM_CONF", folder.resolve("slurm.conf").toString());
        builder.environment().put("PATH", System.getenv("PATH") + ":/usr/sbin");
        Process process = builder.start();
        String said = process.waitFor(30, TimeUnit.SECONDS) ? Files.readString(folder.resolve("said"), StandardCharsets.UTF_8) : "did not end";
        assertThat(process.exitValue()).as("%s: %s", words[0], said).isZero();
        return said;
    }
}
