package cz.paprsek.asset;

import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.StoredImage;
import cz.paprsek.io.PlainText;
import cz.paprsek.math.Require;
import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.FileNotFoundException;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;

/**
 * The files that one scene needs, by relative name, with {@code /} between folders: {@code textures/oak.png}. Each is read once, when it is first
 * asked for, and stays the same from then on, whatever becomes of the file. Any number of threads may ask at once.
 *
 * <p>What a name means is up to the source; none can reach out of it. Every {@link IOException} from here is one sentence, which begins with the name.
 */
public final class Assets {
    /** How many bytes a file may have: 256 MiB. */
    public static final long LARGEST = 1L << 28;
    /** How many bytes all files of a scene may have together: 1 GiB. */
    public static final long LARGEST_TOGETHER = 1L << 30;

    private final Source source;
    private final long largest;
    private final long largestTogether;
    private final AtomicLong together = new AtomicLong();
    private final Map<String, Entry> entries = new ConcurrentHashMap<>();

    /** Where files come from. */
    @FunctionalInterface
    public interface Source {
        /**
         * Opens a file; it is read to its end or to the limit, and closed.
         *
         * @param name relative, of parts between single slashes, none of which is empty, {@code .} or {@code ..}
         * @throws IOException with a sentence that need not repeat the name, if there is no such file or it cannot be read
         */
        InputStream open(String name) throws IOException;
    }

    /** Makes something of a file. */
    @FunctionalInterface
    public interface Decoder<T> {
        /**
         * Reads a file as far as it is needed.
         *
         * @param name of the file, in its normal form: that of a file beside it begins with the same folders
         * @param size how many bytes there are; {@link Long#MAX_VALUE} if nobody knows
         * @throws IOException with a sentence that need not repeat the name
         */
        T decode(String name, InputStream input, long size) throws IOException;
    }

    private Assets(Source source, long largest, long largestTogether) {
        this.source = Objects.requireNonNull(source, "source");
        this.largest = largest;
        this.largestTogether = largestTogether;
    }

    /** No files at all: for a scene that comes from a stream or out of a text. */
    public static Assets none() {
        return from(name -> {
            throw new FileNotFoundException("there are no files beside this scene");
        });
    }

    /** The files of a folder and those below; links that lead out of it are refused. It may lie in a zip file system. */
    public static Assets in(Path folder) {
        return from(new Folder(Objects.requireNonNull(folder, "folder"), false));
    }

    /** The files beside that of a scene. */
    public static Assets beside(Path sceneFile) {
        Path folder = sceneFile.toAbsolutePath().getParent();
        return folder == null ? none() : from(new Folder(folder, true));
    }

    /** Files in memory, of which copies are made. */
    public static Assets of(Map<String, byte[]> files) {
        Map<String, byte[]> copies = new HashMap<>();
        files.forEach((name, bytes) -> copies.put(Objects.requireNonNull(name, "name"), bytes.clone()));
        return from(name -> new ByteArrayInputStream(found(copies.get(name), "there is no file of this name")));
    }

    /**
     * Resources that a class loader finds: those in a jar, say.
     *
     * @param folder what comes before every name: {@code com/example/textures}; empty for nothing
     */
    public static Assets in(ClassLoader loader, String folder) {
        Objects.requireNonNull(loader, "loader");
        String prefix = folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/";
        return from(name -> found(loader.getResourceAsStream(prefix + name), "there is no resource of this name"));
    }

    /** Files from anywhere. */
    public static Assets from(Source source) {
        return new Assets(source, LARGEST, LARGEST_TOGETHER);
    }

    /** The same source with other limits, and nothing read yet. */
    public Assets withLimits(long bytes, long bytesTogether) {
        Require.that(bytes > 0 && bytes < Integer.MAX_VALUE - 8 && bytesTogether > 0, "limits must be above 0, and a file fits into an array");
        return new Assets(source, bytes, bytesTogether);
    }

    /** How many bytes a file may have here. */
    public long largest() {
        return largest;
    }

    /** What a file is called in messages; empty if it stands beside that of the scene, and is called as it is seen from there. */
    public Optional<String> called(String name) {
        Objects.requireNonNull(name, "name");
        return source instanceof Folder known && known.isBeside() ? Optional.empty() : Optional.of(source instanceof Folder other ? other.folder().resolve(name).toString() : name);
    }

    /** The content of a file, which cannot be changed. */
    public ByteBuffer bytes(String name) throws IOException {
        return ByteBuffer.wrap(entry(name).bytes()).asReadOnlyBuffer();
    }

    /** A file as a picture of any kind that {@link ImageFiles} reads, decoded once, and with its limits. */
    public StoredImage picture(String name) throws IOException {
        return entry(name).picture();
    }

    /**
     * A file as what a decoder makes of it, which is kept, while its bytes are not: for large ones, of which any has as many bytes as all files
     * together.
     *
     * @param decoder always the very same object for the same kind of thing
     */
    public <T> T decoded(String name, Decoder<T> decoder) throws IOException {
        return entry(name).decoded(Objects.requireNonNull(decoder, "decoder"));
    }

    /** Takes in what was found within another file, to be read under a name of its own from now on. The bytes are not copied. */
    public void supply(String name, byte[] content) throws IOException {
        entry(name).supply(Objects.requireNonNull(content, "content"));
    }

    /**
     * A file as it is now, however large: nothing of it is kept. If it is there no more, as it was read.
     *
     * @throws IOException as for any other way to read it: where its name leads out, say
     */
    public InputStream open(String name) throws IOException {
        return entry(name).open();
    }

    /** The SHA-256 of a file's content, as 64 hexadecimal digits. */
    public String digest(String name) throws IOException {
        return sha256(entry(name).bytes());
    }

    /** The digests of all files that have been read so far, by name. */
    public SortedMap<String, String> digests() {
        SortedMap<String, String> digests = new TreeMap<>();
        entries.forEach((name, entry) -> entry.digest().ifPresent(digest -> digests.put(name, digest)));
        return digests;
    }

    /** One digest for all files that have been read so far: another if any of them had another name or content. */
    public String digest() {
        StringBuilder lines = new StringBuilder();
        digests().forEach((name, digest) -> lines.append(digest).append(' ').append(name).append('\n'));
        return sha256(lines.toString().getBytes(StandardCharsets.UTF_8));
    }

    private Entry entry(String name) throws IOException {
        return entries.computeIfAbsent(AssetName.normal(Objects.requireNonNull(name, "name")), Entry::new);
    }

    private byte[] read(String name) throws IOException {
        try (InputStream input = Objects.requireNonNull(source.open(name), () -> "the source of assets gave null for " + quoted(name))) {
            require(!(input instanceof Sized file) || file.size <= largest, "is larger than the " + largest + " bytes that a file may have here");
            // What says nothing of its size, or something wrong, is read no further than it may be.
            byte[] bytes = input.readNBytes((int) largest + 1);
            require(bytes.length <= largest, "is larger than the " + largest + " bytes that a file may have here");
            require(together.get() + bytes.length <= largestTogether,
                    "makes all files of the scene larger than the " + largestTogether + " bytes that they may have together here");
            together.addAndGet(bytes.length);
            return bytes;
        } catch (IOException e) {
            throw named(name, e);
        }
    }

    /** What a decoder makes of a file, and the digest of all its bytes. */
    private <T> Map.Entry<T, String> decode(String name, Decoder<T> decoder, Source from) throws IOException {
        try (InputStream opened = Objects.requireNonNull(from.open(name), () -> "the source of assets gave null for " + quoted(name))) {
            long size = opened instanceof Sized file ? file.size : Long.MAX_VALUE;
            require(size == Long.MAX_VALUE || size <= largestTogether, "is larger than the " + largestTogether + " bytes that such a file may have here");
            MessageDigest digest = sha256();
            InputStream input = new DigestInputStream(new Limited(opened, largestTogether), digest);
            T made = decoder.decode(name, new BufferedInputStream(input, 1 << 16), size);
            input.transferTo(OutputStream.nullOutputStream());
            return Map.entry(made, HexFormat.of().formatHex(digest.digest()));
        } catch (IOException e) {
            throw named(name, e);
        }
    }

    private static void require(boolean condition, String sentence) throws IOException {
        if (!condition) {
            throw new IOException(sentence);
        }
    }

    private static IOException named(String name, IOException e) {
        return new IOException(quoted(name) + ": " + Objects.requireNonNullElse(e.getMessage(), e.getClass().getSimpleName()), e);
    }

    /** A name as it can be shown, whatever is in it. */
    static String quoted(String name) {
        return '"' + PlainText.of(name, 100) + '"';
    }

    private static <T> T found(@Nullable T wanted, String otherwise) throws IOException {
        if (wanted == null) {
            throw new FileNotFoundException(otherwise);
        }
        return wanted;
    }

    private static String sha256(byte[] bytes) {
        return HexFormat.of().formatHex(sha256().digest(bytes));
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    /** A stream that knows how much is to be read, before anything is. */
    static final class Sized extends FilterInputStream {
        private final long size;

        Sized(InputStream input, long size) {
            super(input);
            this.size = size;
        }
    }

    /** A stream that is refused when it turns out to be too long. */
    private static final class Limited extends FilterInputStream {
        private final long most;
        private long read;

        Limited(InputStream input, long most) {
            super(input);
            this.most = most;
        }

        @Override
        public int read() throws IOException {
            int value = super.read();
            count(value < 0 ? 0 : 1);
            return value;
        }

        @Override
        public int read(byte[] into, int from, int length) throws IOException {
            int count = super.read(into, from, length);
            count(Math.max(0, count));
            return count;
        }

        private void count(int bytes) throws IOException {
            read += bytes;
            require(read <= most, "is larger than the " + most + " bytes that such a file may have here");
        }
    }

    /** One file, read when it is asked for. What could not be read is tried again the next time. */
    private final class Entry {
        private final String name;
        private byte @Nullable [] bytes;
        private boolean isSupplied;
        private volatile @Nullable String digest;
        private @Nullable StoredImage picture;
        private final Map<Decoder<?>, Object> decoded = new HashMap<>();

        Entry(String name) {
            this.name = name;
        }

        synchronized byte[] bytes() throws IOException {
            byte[] known = bytes;
            if (known == null) {
                known = read(name);
                bytes = known;
                digest = sha256(known);
            }
            return known;
        }

        synchronized InputStream open() throws IOException {
            byte[] known = bytes;
            try {
                return known != null && isSupplied ? new ByteArrayInputStream(known) : Objects.requireNonNull(source.open(name), () -> "the source of assets gave null for " + quoted(name));
            } catch (IOException gone) {
                if (known == null) {
                    throw named(name, gone);
                }
                return new ByteArrayInputStream(known);
            }
        }

        synchronized void supply(byte[] content) {
            isSupplied = true;
            if (bytes == content) {
                return;
            }
            bytes = content;
            digest = sha256(content);
        }

        synchronized StoredImage picture() throws IOException {
            StoredImage known = picture;
            if (known == null) {
                byte[] content = bytes();
                try {
                    known = ImageFiles.readStored(content, name);
                } catch (IOException e) {
                    throw named(name, e);
                }
                picture = known;
            }
            return known;
        }

        @SuppressWarnings("unchecked")
        synchronized <T> T decoded(Decoder<T> decoder) throws IOException {
            Object known = decoded.get(decoder);
            if (known == null) {
                // What is here already may have changed where it came from, or was found within another file.
                byte[] content = bytes;
                Map.Entry<T, String> made = decode(name, decoder, content == null ? source : same -> new Sized(new ByteArrayInputStream(content), content.length));
                known = made.getKey();
                digest = made.getValue();
                decoded.put(decoder, known);
            }
            return (T) known;
        }

        Optional<String> digest() {
            return Optional.ofNullable(digest);
        }
    }
}
