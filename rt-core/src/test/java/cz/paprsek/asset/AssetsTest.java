package cz.paprsek.asset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import java.io.ByteArrayInputStream;
import java.io.FileNotFoundException;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.ByteBuffer;
import java.nio.ReadOnlyBufferException;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What lies beside a scene is read, once; and nothing else is, whatever it is called and whoever puts links there. */
@Timeout(60)
class AssetsTest {
    @Test
    @SuppressWarnings("NullAway") // What nobody may do, but some will.
    void aSourceThatGivesNullIsToldByTheNameThatItWasAskedFor() {
        assertThatThrownBy(() -> Assets.from(name -> null).bytes("wood.png")).hasMessage("the source of assets gave null for \"wood.png\"");
    }

    /** Of the four bytes {@code oak\n}; sha256sum says the same. */
    private static final String OAK_DIGEST = "38376757e5c870d200d2c8b13cdec16c0997bd9c089d857d56e3c856f99b8f38";

    @TempDir
    Path outside;

    private Path folder;

    @BeforeEach
    void putFilesThere() throws IOException {
        folder = Files.createDirectories(outside.resolve("scene"));
        Files.createDirectories(folder.resolve("textures/deep"));
        Files.writeString(folder.resolve("textures/oak.txt"), "oak\n");
        Files.writeString(outside.resolve("secret"), "secret");
    }

    private static String text(Assets assets, String name) throws IOException {
        return StandardCharsets.UTF_8.decode(assets.bytes(name)).toString();
    }

    @Test
    void everySourceGivesTheSameFilesByTheSameNames(@TempDir Path elsewhere) throws Exception {
        Path zip = elsewhere.resolve("scene.zip");
        try (FileSystem inside = FileSystems.newFileSystem(zip, Map.of("create", "true"))) {
            Files.createDirectories(inside.getPath("/scene/textures"));
            Files.writeString(inside.getPath("/scene/textures/oak.txt"), "oak\n");
            Files.writeString(inside.getPath("/secret"), "secret");
        }
        try (FileSystem inside = FileSystems.newFileSystem(zip); URLClassLoader loader = new URLClassLoader(new URL[] {zip.toUri().toURL()}, null)) {
            for (Assets assets : new Assets[] {Assets.in(folder), Assets.beside(folder.resolve("a.xml")), Assets.in(inside.getPath("/scene")),
                    Assets.in(inside.getPath("scene")), Assets.in(loader, "scene"), Assets.in(loader, "scene/"),
                    Assets.of(Map.of("textures/oak.txt", "oak\n".getBytes(StandardCharsets.UTF_8)))}) {
                assertThat(text(assets, "textures/oak.txt")).isEqualTo("oak\n");
                assertThat(text(assets, "./textures/./oak.txt")).isEqualTo("oak\n");
                assertThat(assets.digests()).containsOnlyKeys("textures/oak.txt");
                assertThatThrownBy(() -> assets.bytes("textures/elm.txt")).isInstanceOf(IOException.class)
                        .hasMessageStartingWith("\"textures/elm.txt\": there is no").hasMessageNotContaining("\n");
                assertThatThrownBy(() -> assets.bytes("../secret")).hasMessageContaining(".. leads out");
            }
        }
        assertThatThrownBy(() -> Assets.none().bytes("oak.txt")).hasMessage("\"oak.txt\": there are no files beside this scene");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', ignoreLeadingAndTrailingWhitespace = false, value = {
        "''|is empty", "'  '|is empty", ".|is empty", "./.|is empty",
        "/etc/passwd|absolute", "//server/share/a.png|absolute", "..|.. leads out", "../a.png|.. leads out", "a/../../b|.. leads out", "a/..|.. leads out",
        "textures/../textures/oak.txt|.. leads out",
        "..\\a.png|write / between", "C:\\a.png|write / between", "\\\\server\\share\\a.png|write / between", "a\\..\\..\\b|write / between",
        "C:a.png|no drives", "c:/a.png|no drives", "file:///etc/passwd|no addresses", "http://example.org/a.png|no addresses", "jar:file:a!/b|no addresses",
        "a.png::$DATA|no addresses",
        "a//b.png|between two /", "textures/|name of a folder", "NUL|device on Windows", "a/con.png|device on Windows", "Com1|device on Windows",
        "lpt9.tar.gz|device on Windows", "a.png.|some systems drop it", "a.png |some systems drop it", "a./b|some systems drop it", ".../a|some systems drop it",
    })
    void aNameThatIsNoPlaceBesideTheSceneIsRefusedInOneSentence(String name, String sentence) {
        AtomicInteger asked = new AtomicInteger();
        Assets assets = Assets.from(any -> {
            asked.incrementAndGet();
            return new ByteArrayInputStream(new byte[0]);
        });
        String expected = sentence.equals("no drives") ? "no addresses, no drives" : sentence;
        assertThatThrownBy(() -> assets.bytes(name)).isInstanceOf(IOException.class).hasMessageStartingWith("\"" + name + "\": ").hasMessageContaining(expected);
        assertThat(asked).as("nobody was asked for it").hasValue(0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"a\0b", "a\nb", "a\u001b[31mb", "a\u202eb", "\ud800"})
    void aNameWithHiddenCharactersIsRefusedAndShownWithoutThem(String name) {
        assertThatThrownBy(() -> Assets.in(folder).bytes(name)).isInstanceOf(IOException.class).hasMessageMatching("\"a?\\\\u\\p{XDigit}{4}\\S*\": .*");
        assertThatThrownBy(() -> Assets.in(folder).bytes("a".repeat(1001))).hasMessageContaining("longer than 1000");
    }

    @Test
    void namesOfAllLanguagesAreFine() throws IOException {
        Map<String, byte[]> files = IntStream.range(0, 1).boxed().collect(Collectors.toMap(i -> "obrázky/dřevo – dub (2).png", i -> new byte[] {7}));
        assertThat(Assets.of(files).bytes("obrázky/dřevo – dub (2).png").get()).isEqualTo((byte) 7);
    }

    @Test
    void linksAreFollowedWithinTheFolderOnly() throws IOException {
        Files.createSymbolicLink(folder.resolve("inner.txt"), Path.of("textures/oak.txt"));
        Files.createSymbolicLink(folder.resolve("inner"), Path.of("textures/deep/.."));
        Files.createSymbolicLink(folder.resolve("outer.txt"), outside.resolve("secret"));
        Files.createSymbolicLink(folder.resolve("relative.txt"), Path.of("../secret"));
        Files.createSymbolicLink(folder.resolve("up"), Path.of(".."));
        Files.createSymbolicLink(folder.resolve("self"), Path.of("self"));
        Files.createSymbolicLink(folder.resolve("dangling"), Path.of("nowhere"));
        Files.createSymbolicLink(outside.resolve("link-to-scene"), folder);
        Assets assets = Assets.in(outside.resolve("link-to-scene"));
        assertThat(text(assets, "inner.txt")).isEqualTo("oak\n");
        assertThat(text(assets, "inner/oak.txt")).isEqualTo("oak\n");
        for (String name : new String[] {"outer.txt", "relative.txt", "up/secret", "up"}) {
            assertThatThrownBy(() -> assets.bytes(name)).hasMessage("\"" + name + "\": this is a link that leads out of the scene's folder, "
                    + "and only files within can be read");
        }
        assertThatThrownBy(() -> assets.bytes("self")).isInstanceOf(IOException.class).hasMessageStartingWith("\"self\": ");
        assertThatThrownBy(() -> assets.bytes("dangling")).hasMessageContaining("there is no such file");
        assertThat(assets.digests()).containsOnlyKeys("inner.txt", "inner/oak.txt");
    }

    @Test
    void aLinkThatIsSwappedWhileItIsReadGivesWhatIsWithinOrNothing() throws Exception {
        Path swapped = folder.resolve("swapped");
        Path secretFolder = Files.createDirectories(outside.resolve("elsewhere"));
        Files.writeString(secretFolder.resolve("oak.txt"), "secret");
        AtomicBoolean done = new AtomicBoolean();
        Thread enemy = new Thread(() -> {
            for (int i = 0; !done.get(); i++) {
                try {
                    Path link = outside.resolve("link" + i % 2);
                    Files.deleteIfExists(link);
                    if (i % 3 == 2) {
                        Files.createDirectory(link);
                        Files.writeString(link.resolve("oak.txt"), "oak\n");
                        move(swapped);
                    } else {
                        Files.createSymbolicLink(link, i % 3 == 0 ? folder.resolve("textures") : secretFolder);
                    }
                    Files.move(link, swapped, StandardCopyOption.ATOMIC_MOVE);
                } catch (IOException tryAgain) {
                    // A folder cannot be replaced by a link in one step.
                    move(swapped);
                }
            }
        });
        enemy.start();
        int read = 0;
        try {
            for (int i = 0; i < 3000; i++) {
                try {
                    assertThat(text(Assets.in(folder), "swapped/oak.txt")).isEqualTo("oak\n");
                    read++;
                } catch (IOException refused) {
                    assertThat(refused).hasMessageStartingWith("\"swapped/oak.txt\": ");
                }
            }
        } finally {
            done.set(true);
            enemy.join();
        }
        assertThat(read).as("how often it lay within").isPositive();
    }

    private void move(Path away) {
        try {
            Files.move(away, outside.resolve("old" + System.nanoTime()));
        } catch (IOException gone) {
            // It was a link just then.
        }
    }

    @Test
    void devicesPipesAndFoldersAreRefusedAtOnce() throws Exception {
        Process made = new ProcessBuilder("mkfifo", folder.resolve("pipe").toString()).start();
        assertThat(made.waitFor(10, TimeUnit.SECONDS)).isTrue();
        assertThatThrownBy(() -> Assets.in(folder).bytes("pipe")).hasMessage("\"pipe\": this is a device or pipe, not a file");
        assertThatThrownBy(() -> Assets.in(Path.of("/dev")).bytes("zero")).hasMessage("\"zero\": this is a device or pipe, not a file");
        assertThatThrownBy(() -> Assets.in(folder).bytes("textures")).hasMessage("\"textures\": this is a folder, not a file");
        assertThatThrownBy(() -> Assets.in(folder).bytes("textures/oak.txt/more")).hasMessageContaining("there is no such file");
        assertThatThrownBy(() -> Assets.in(outside.resolve("none")).bytes("a")).isInstanceOf(IOException.class).hasMessageContaining("there is no such");
    }

    @Test
    void aFileThatIsTooLargeIsRefusedUnread() throws IOException {
        Path huge = folder.resolve("huge");
        try (SeekableByteChannel channel = Files.newByteChannel(huge, Set.of(StandardOpenOption.WRITE, StandardOpenOption.CREATE_NEW, StandardOpenOption.SPARSE))) {
            channel.position(10_000_000_000L).write(ByteBuffer.wrap(new byte[1]));
        }
        long begin = System.nanoTime();
        assertThatThrownBy(() -> Assets.in(folder).bytes("huge")).hasMessage("\"huge\": is larger than the 268435456 bytes that a file may have here");
        assertThat(System.nanoTime() - begin).isLessThan(5_000_000_000L);
    }

    @Test
    void whatNeverEndsIsReadNoFurtherThanTheLimit() {
        AtomicInteger given = new AtomicInteger();
        Assets endless = Assets.from(name -> new FilterInputStream(InputStream.nullInputStream()) {
            @Override
            public int read(byte[] into, int offset, int length) {
                given.addAndGet(length);
                return length;
            }
        }).withLimits(100_000, 1_000_000);
        assertThatThrownBy(() -> endless.bytes("a")).hasMessageContaining("larger than the 100000 bytes");
        assertThat(given).hasValueLessThan(200_000);
        assertThat(endless.digests()).isEmpty();
    }

    @Test
    void allFilesTogetherAreBounded() throws IOException {
        Assets assets = Assets.from(name -> new ByteArrayInputStream(new byte[400])).withLimits(500, 1000);
        assets.bytes("a");
        assets.bytes("b");
        assertThatThrownBy(() -> assets.bytes("c")).hasMessage("\"c\": makes all files of the scene larger than the 1000 bytes that they may have together here");
        assertThat(assets.bytes("a").remaining()).isEqualTo(400);
    }

    @Test
    void aFileIsReadOnceByAnyNumberOfThreadsAndStaysAsItWas() throws IOException {
        AtomicInteger opened = new AtomicInteger();
        Assets assets = Assets.from(name -> {
            opened.incrementAndGet();
            return new ByteArrayInputStream(name.getBytes(StandardCharsets.UTF_8));
        });
        assertThat(IntStream.range(0, 2000).parallel().mapToObj(i -> {
            try {
                return text(assets, "file" + i % 10);
            } catch (IOException e) {
                return e.toString();
            }
        }).distinct().toList()).hasSize(10).allMatch(text -> text.startsWith("file"));
        assertThat(opened).hasValue(10);
        Assets files = Assets.in(folder);
        ByteBuffer bytes = files.bytes("textures/oak.txt");
        Files.writeString(folder.resolve("textures/oak.txt"), "elm\n");
        assertThat(text(files, "textures/oak.txt")).isEqualTo("oak\n");
        assertThat(text(Assets.in(folder), "textures/oak.txt")).isEqualTo("elm\n");
        assertThatThrownBy(() -> bytes.put(0, (byte) 1)).isInstanceOf(ReadOnlyBufferException.class);
    }

    @Test
    void whatIsHereAlreadyIsDecodedWithoutItsSource() throws IOException {
        Assets assets = Assets.none();
        assets.supply("model.glb-oak.txt", new byte[] {'o', 'a', 'k', '\n'});
        String decoded = assets.decoded("model.glb-oak.txt", (name, input, size) -> size + " " + new String(input.readAllBytes(), StandardCharsets.UTF_8));
        assertThat(decoded).isEqualTo("4 oak\n");
        assertThat(assets.digests()).containsExactly(Map.entry("model.glb-oak.txt", OAK_DIGEST));
    }

    @Test
    void whatCouldNotBeReadIsTriedAgain() throws IOException {
        Assets files = Assets.in(folder);
        assertThatThrownBy(() -> files.bytes("late.txt")).isInstanceOf(IOException.class);
        Files.writeString(folder.resolve("late.txt"), "late");
        assertThat(text(files, "late.txt")).isEqualTo("late");
    }

    @Test
    void digestsTellContentsAndNamesApart() throws IOException {
        Assets files = Assets.in(folder);
        String none = files.digest();
        assertThat(files.digest("textures/oak.txt")).isEqualTo(OAK_DIGEST);
        String one = files.digest();
        assertThat(Set.of(none, one, digestOf("textures/elm.txt", "oak\n"), digestOf("textures/oak.txt", "oak"))).hasSize(4);
        assertThat(digestOf("textures/oak.txt", "oak\n")).isEqualTo(one);
    }

    private static String digestOf(String name, String content) throws IOException {
        Assets assets = Assets.of(Map.of(name, content.getBytes(StandardCharsets.UTF_8)));
        assets.bytes(name);
        return assets.digest();
    }

    @Test
    void picturesAreDecodedOnceAndWhatIsNoneIsRefusedByName() throws IOException {
        Image image = new Image(3, 2);
        image.set(1, 1, 1, 0, 0);
        ImageFiles.write(image, folder.resolve("textures/a.png"));
        Assets files = Assets.in(folder);
        assertThat(files.picture("textures/a.png").image().red(1, 1)).isEqualTo(1);
        assertThat(files.picture("textures/a.png")).isSameAs(files.picture("./textures/a.png"));
        Files.writeString(folder.resolve("bad.png"), "hello, this is no picture");
        assertThatThrownBy(() -> files.picture("bad.png")).isInstanceOf(IOException.class).hasMessageStartingWith("\"bad.png\": ").hasMessageNotContaining("\n");
    }

    @Test
    void aSourceThatFailsIsNamedAndWhatItGivesIsClosed() {
        Assets failing = Assets.from(name -> {
            throw new FileNotFoundException();
        });
        assertThatThrownBy(() -> failing.bytes("a")).isInstanceOf(IOException.class).hasMessage("\"a\": FileNotFoundException");
        AtomicBoolean closed = new AtomicBoolean();
        Assets broken = Assets.from(name -> new FilterInputStream(InputStream.nullInputStream()) {
            @Override
            public int read(byte[] into, int offset, int length) throws IOException {
                throw new IOException("the wire broke");
            }

            @Override
            public void close() {
                closed.set(true);
            }
        });
        assertThatThrownBy(() -> broken.bytes("a")).hasMessage("\"a\": the wire broke");
        assertThat(closed).isTrue();
    }
}
