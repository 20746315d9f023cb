import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Packs the editor, the command line and the Java they run on, so that nobody needs to install any. After {@code mvn -DskipTests package}, in the project's folder:
 * <pre>java rt-fx/src/main/installer/Installer.java archive | deb | msi | dmg</pre>
 * What comes of it lies in {@code rt-fx/target/installer}. Each system packs for itself. {@code msi} (Windows, with WiX) and {@code dmg} (macOS) have not been tried yet.
 */
class Installer {
    /** What the jars need of Java: found with jdeps, besides Czech words for numbers and dates, zip files as folders, and vectors. */
    private static final String MODULES = "java.base,java.desktop,java.logging,java.management,java.naming,java.xml,jdk.incubator.vector,jdk.localedata,jdk.unsupported,jdk.zipfs";
    private static final Path HERE = Path.of("rt-fx/src/main/installer");
    private static final Path OUT = Path.of("rt-fx/target/installer");
    private static final Path JAVA = Path.of(System.getProperty("java.home"), "bin");
    private static final String SYSTEM = System.getProperty("os.name").toLowerCase(Locale.ROOT);
    private static final boolean WINDOWS = SYSTEM.startsWith("windows");
    private static final boolean MAC = SYSTEM.startsWith("mac");

    public static void main(String[] words) throws Exception {
        if (words.length != 1 || !List.of("archive", "deb", "msi", "dmg").contains(words[0])) {
            throw fault("expected one of archive, deb, msi, dmg, but found \"" + String.join(" ", words) + "\"");
        }
        for (Path jar : List.of(Path.of("rt-cli/target/rt-cli.jar"), Path.of("rt-fx/target/rt-fx.jar"))) {
            if (!Files.exists(jar)) {
                throw fault("there is no " + jar + "; build it with: mvn -DskipTests package");
            }
        }
        Matcher version = Pattern.compile("<version>(.*?)</version>").matcher(Files.readString(Path.of("pom.xml")));
        if (!version.find()) {
            throw fault("pom.xml says no version");
        }
        remove(OUT);
        Files.createDirectories(OUT);
        icons();
        Path image = image(version.group(1), words[0].equals("msi") || words[0].equals("dmg"));
        switch (words[0]) {
            case "archive" -> archive(image, version.group(1));
            case "deb" -> deb(image, version.group(1));
            default -> foreign(words[0], image, version.group(1));
        }
    }

    /** The program's picture is rendered by the program. */
    private static void icons() throws Exception {
        Path png = OUT.resolve("paprsek.png");
        run(JAVA.resolve("java").toString(), "-jar", "rt-cli/target/rt-cli.jar", "render", HERE.resolve("icon.xml").toString(), "--transparent", "--quiet", "-o", png.toString());
        byte[] picture = Files.readAllBytes(png);
        // One picture of 256 × 256 points as PNG, which both formats allow.
        Files.write(OUT.resolve("paprsek.ico"), ByteBuffer.allocate(22 + picture.length).order(ByteOrder.LITTLE_ENDIAN).putShort((short) 0).putShort((short) 1).putShort((short) 1)
                .putInt(0).putShort((short) 1).putShort((short) 32).putInt(picture.length).putInt(22).put(picture).array());
        Files.write(OUT.resolve("paprsek.icns"), ByteBuffer.allocate(16 + picture.length).put(ascii("icns")).putInt(16 + picture.length).put(ascii("ic08"))
                .putInt(8 + picture.length).put(picture).array());
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    /** A folder with both programs and their Java. */
    private static Path image(String version, boolean both) throws Exception {
        Path input = Files.createDirectories(OUT.resolve("input"));
        Files.copy(Path.of("rt-cli/target/rt-cli.jar"), input.resolve("rt-cli.jar"));
        Path editor = Files.copy(Path.of("rt-fx/target/rt-fx.jar"), input.resolve("rt-fx.jar"));
        try (FileSystem jar = FileSystems.newFileSystem(editor)) {
            for (Path root : jar.getRootDirectories()) {
                try (Stream<Path> all = Files.walk(root, 1)) {
                    for (Path file : all.filter(file -> isForeign(String.valueOf(file.getFileName()))).toList()) {
                        Files.delete(file);
                    }
                }
            }
        }
        Path runtime = OUT.resolve("runtime");
        boolean hasLevels = Runtime.version().feature() >= 21;
        run(JAVA.resolve("jlink").toString(), "--add-modules", MODULES, "--include-locales=en,cs", "--strip-java-debug-attributes", "--no-header-files", "--no-man-pages",
                "--compress=" + (hasLevels ? "zip-6" : "2"), "--output", runtime.toString());
        // Java's own classes as they lie in memory: all starts are quicker, and the command line's script cannot keep its own without.
        run(runtime.resolve("bin/java").toString(), "-Xshare:dump");
        List<String> command = new ArrayList<>(List.of(JAVA.resolve("jpackage").toString(), "--type", "app-image", "--dest", OUT.toString(), "--name", MAC ? "Paprsek" : "paprsek-editor",
                "--app-version", MAC ? version.replaceFirst("^0", "1") : version, "--vendor", "The Paprsek project", "--description", "A ray tracer: scene editor and command line",
                "--input", input.toString(), "--main-jar", "rt-fx.jar", "--main-class", "cz.paprsek.fx.Launcher", "--runtime-image", runtime.toString(),
                "--icon", OUT.resolve(WINDOWS ? "paprsek.ico" : MAC ? "paprsek.icns" : "paprsek.png").toString(), "--java-options", "--add-modules=jdk.incubator.vector"));
        if (Runtime.version().feature() >= 24) {
            command.addAll(List.of("--java-options", "--enable-native-access=ALL-UNNAMED"));
        }
        if (both || WINDOWS || MAC) {
            Path line = Files.writeString(OUT.resolve("paprsek.properties"), "main-jar=rt-cli.jar\nmain-class=cz.paprsek.cli.Main\nwin-console=true\njava-options=-XX:MaxGCPauseMillis=50\n");
            command.addAll(List.of("--add-launcher", "paprsek=" + line));
        }
        run(command.toArray(String[]::new));
        Path image = OUT.resolve(MAC ? "Paprsek.app" : "paprsek-editor");
        if (!WINDOWS && !MAC) {
            // The script of the command line, which keeps an archive of loaded classes and knows vectors, with the Java beside it.
            Path app = image.resolve("lib/app");
            executable(Files.copy(Path.of("rt-cli/src/main/launcher/paprsek"), app.resolve("paprsek")));
            executable(Files.copy(HERE.resolve("paprsek"), image.resolve("bin/paprsek")));
            Files.copy(Path.of("LICENSE"), image.resolve("LICENSE"));
            Files.copy(Path.of("scenes/showcase.xml"), image.resolve("showcase.xml"));
        }
        return image;
    }

    private static boolean isForeign(String name) {
        return (!WINDOWS && name.endsWith(".dll")) || (!MAC && name.endsWith(".dylib")) || ((WINDOWS || MAC) && name.endsWith(".so"));
    }

    private static void archive(Path image, String version) throws Exception {
        String name = "paprsek-" + version;
        Path named = Files.move(image, OUT.resolve(name));
        Path file = OUT.resolve(name + "-" + (WINDOWS ? "windows" : MAC ? "macos" : "linux") + "-" + System.getProperty("os.arch") + (WINDOWS ? ".zip" : ".tar.gz"));
        run("tar", WINDOWS ? "-acf" : "-czf", file.toString(), "-C", OUT.toString(), named.getFileName().toString());
        tell(file);
        if (!WINDOWS) {
            Path zip = OUT.resolve(file.getFileName().toString().replace(".tar.gz", ".zip"));
            zip(named, zip);
            tell(zip);
        }
    }

    /** The same once more, with what may be executed, for who takes nothing else: Homebrew and SDKMAN, by jreleaser.yml. */
    private static void zip(Path folder, Path file) throws IOException {
        try (FileSystem zip = FileSystems.newFileSystem(file, Map.of("create", true, "enablePosixFileAttributes", true)); Stream<Path> all = Files.walk(folder)) {
            for (Path one : all.sorted().toList()) {
                Path into = zip.getPath(folder.getParent().relativize(one).toString());
                if (Files.isDirectory(one)) {
                    Files.createDirectories(into);
                } else {
                    Files.copy(one, into);
                    Files.setPosixFilePermissions(into, Files.getPosixFilePermissions(one));
                }
            }
        }
    }

    /** As Debian lays things out; the system's own triggers then take up the kind of file, the icon and the entry of the menu. */
    private static void deb(Path image, String version) throws Exception {
        Path root = OUT.resolve("deb");
        Path share = Files.createDirectories(root.resolve("usr/share"));
        Files.createDirectories(root.resolve("opt"));
        Files.move(image, root.resolve("opt/paprsek"));
        Path bin = Files.createDirectories(root.resolve("usr/bin"));
        for (String program : List.of("paprsek", "paprsek-editor")) {
            Files.createSymbolicLink(bin.resolve(program), Path.of("../../opt/paprsek/bin", program));
        }
        put(HERE.resolve("paprsek.desktop"), share.resolve("applications/paprsek.desktop"));
        put(HERE.resolve("paprsek-scene.xml"), share.resolve("mime/packages/paprsek-scene.xml"));
        put(OUT.resolve("paprsek.png"), share.resolve("icons/hicolor/256x256/apps/paprsek.png"));
        put(Path.of("LICENSE"), share.resolve("doc/paprsek/copyright"));
        String paprsek = "rt-cli/target/rt-cli.jar";
        run(JAVA.resolve("java").toString(), "-jar", paprsek, "generate-man", "-o", Files.createDirectories(share.resolve("man/man1")).toString());
        completion(share.resolve("bash-completion/completions/paprsek"), "bash");
        put(HERE.resolve("_paprsek"), share.resolve("zsh/vendor-completions/_paprsek"));
        completion(share.resolve("fish/vendor_completions.d/paprsek.fish"), "fish");
        long size;
        try (Stream<Path> all = Files.walk(root)) {
            size = all.filter(Files::isRegularFile).mapToLong(file -> file.toFile().length()).sum();
        }
        String machine = System.getProperty("os.arch").equals("aarch64") ? "arm64" : "amd64";
        Files.createDirectories(root.resolve("DEBIAN"));
        Files.writeString(root.resolve("DEBIAN/control"), Files.readString(HERE.resolve("control")).replace("{version}", version).replace("{machine}", machine)
                .replace("{size}", String.valueOf(size / 1024)));
        open(root);
        Path file = OUT.resolve("paprsek_" + version + "_" + machine + ".deb");
        run("dpkg-deb", "--root-owner-group", "--build", root.toString(), file.toString());
        tell(file);
    }

    /** For everybody to read, whatever files of who builds are like. */
    private static void open(Path root) throws IOException {
        try (Stream<Path> all = Files.walk(root)) {
            for (Path file : all.filter(file -> !Files.isSymbolicLink(file)).toList()) {
                Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(Files.isDirectory(file) || Files.isExecutable(file) ? "rwxr-xr-x" : "rw-r--r--"));
            }
        }
    }

    private static void completion(Path into, String shell) throws Exception {
        Files.createDirectories(into.getParent());
        List<String> command = new ArrayList<>(List.of(JAVA.resolve("java").toString(), "-jar", "rt-cli/target/rt-cli.jar", "generate-completion"));
        if (shell.equals("fish")) {
            command.addAll(List.of("--shell", "fish"));
        }
        if (new ProcessBuilder(command).redirectOutput(into.toFile()).redirectError(ProcessBuilder.Redirect.INHERIT).start().waitFor() != 0) {
            throw fault("no completion came of " + String.join(" ", command));
        }
    }

    /** By jpackage alone. It takes files by their ending, so the ending asked for is one that other programs do not have; .xml is opened by hand or dragged in. */
    private static void foreign(String type, Path image, String version) throws Exception {
        Path kinds = Files.writeString(OUT.resolve("kinds.properties"), "extension=paprsek\nmime-type=application/vnd.paprsek.scene+xml\ndescription=Paprsek scene\n");
        List<String> command = new ArrayList<>(List.of(JAVA.resolve("jpackage").toString(), "--type", type, "--app-image", image.toString(), "--name", "Paprsek", "--dest", OUT.toString(),
                "--app-version", MAC ? version.replaceFirst("^0", "1") : version, "--license-file", "LICENSE", "--file-associations", kinds.toString()));
        if (WINDOWS) {
            command.addAll(List.of("--win-menu", "--win-dir-chooser", "--win-per-user-install"));
        }
        run(command.toArray(String[]::new));
    }

    private static void put(Path from, Path to) throws IOException {
        Files.createDirectories(to.getParent());
        Files.copy(from, to);
    }

    private static void executable(Path file) throws IOException {
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private static void remove(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> all = Files.walk(folder)) {
                all.sorted(Comparator.reverseOrder()).forEach(file -> {
                    try {
                        Files.delete(file);
                    } catch (IOException e) {
                        throw new UncheckedIOException(e);
                    }
                });
            }
        }
    }

    private static void tell(Path file) throws IOException {
        System.out.printf(Locale.ROOT, "%s, %.1f MB%n", file, Files.size(file) / 1e6);
    }

    private static void run(String... command) throws Exception {
        int code = new ProcessBuilder(command).inheritIO().start().waitFor();
        if (code != 0) {
            throw fault(command[0] + " ended with " + code);
        }
    }

    private static RuntimeException fault(String sentence) {
        System.err.println("installer: " + sentence);
        System.exit(1);
        return new IllegalStateException(sentence);
    }
}
