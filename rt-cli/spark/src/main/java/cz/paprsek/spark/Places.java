package cz.paprsek.spark;

import cz.paprsek.cli.shard.Span;
import cz.paprsek.resume.SceneDigest;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.UUID;
import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.ChecksumFileSystem;
import org.apache.hadoop.fs.FSDataInputStream;
import org.apache.hadoop.fs.FileSystem;
import org.apache.hadoop.fs.Path;

/**
 * Where pictures go, and parts until they are whole, in a file system that Hadoop knows. A file appears there as a whole or not at all, as far as that system can rename.
 *
 * @param picture name of the picture, with {@value #FRAME} for the number of a frame
 * @param parts name of the folder for what is under way
 * @param settings of Hadoop, as the driver has them
 */
record Places(String picture, String parts, Map<String, String> settings) implements Serializable {
    static final String FRAME = "{frame}";
    private static final long serialVersionUID = 1;
    private static final int DIGITS = 16;

    /**
     * Those of a film, or a picture.
     *
     * @param output what the user gave
     * @param name of the scene, if the output is a directory
     * @param what the same if the scene is, how it is rendered, and how pictures are written
     */
    static Places of(String output, Span span, String name, String ending, String what, Configuration hadoop) {
        String file = output.endsWith("/") ? output + name + "." + ending : output;
        int slash = file.lastIndexOf('/');
        int dot = file.lastIndexOf('.') > slash ? file.lastIndexOf('.') : file.length();
        String numbered = span.isStill() || file.contains(FRAME) ? file : file.substring(0, dot) + "-" + FRAME + file.substring(dot);
        TreeMap<String, String> settings = new TreeMap<>();
        hadoop.forEach(entry -> settings.put(entry.getKey(), entry.getValue()));
        // What is under way is another's if pictures have other names, or there are others of them: who is done first removes it.
        String key = SceneDigest.ofText(what + "\n" + numbered + "\n" + span.first() + "-" + span.last()).substring(0, DIGITS);
        return new Places(numbered, file.substring(0, slash + 1) + "_paprsek-" + key, settings);
    }

    private FileSystem system() throws IOException {
        Configuration hadoop = new Configuration(false);
        settings.forEach(hadoop::set);
        FileSystem system = new Path(picture.replace(FRAME, "0")).getFileSystem(hadoop);
        // A local file system would have a file of checksums beside each; parts have digests of their own.
        return system instanceof ChecksumFileSystem checked ? checked.getRawFileSystem() : system;
    }

    /** What cannot be written should not come out an hour later. */
    void prepare() throws IOException {
        if (!system().mkdirs(new Path(parts))) {
            throw new IOException(parts + " cannot be made");
        }
    }

    /** Where a part of a frame is. */
    private Path part(int frame, String name) {
        return new Path(folder(frame), name);
    }

    private Path folder(int frame) {
        return new Path(parts, String.format(Locale.ROOT, "frame-%06d", frame));
    }

    private Path mark(int frame) {
        return new Path(parts, String.format(Locale.ROOT, "frame-%06d.done", frame));
    }

    /** Fetches a part; false if there is none. */
    boolean fetch(int frame, String name, java.nio.file.Path to) throws IOException {
        try {
            system().copyToLocalFile(false, part(frame, name), new Path(to.toUri()), true);
            return true;
        } catch (FileNotFoundException none) {
            return false;
        }
    }

    /** Puts a part where it can be fetched. */
    void keep(int frame, String name, java.nio.file.Path from) throws IOException {
        put(from, part(frame, name));
    }

    /**
     * A frame is whole: its picture takes its place, and its parts are deleted.
     *
     * @param number of the frame, as it stands in the name
     */
    void finish(int frame, String number, java.nio.file.Path made) throws IOException {
        Path file = new Path(picture.replace(FRAME, number));
        put(made, file);
        java.nio.file.Path mark = Files.writeString(made.resolveSibling(made.getFileName() + ".done"), Files.size(made) + " " + file);
        put(mark, mark(frame));
        system().delete(folder(frame), true);
    }

    /** Whether the picture of a frame is there, and nobody has replaced it by a shorter or longer one. */
    boolean isFinished(int frame) throws IOException {
        FileSystem system = system();
        try (FSDataInputStream mark = system.open(mark(frame))) {
            String[] words = new String(mark.readAllBytes(), StandardCharsets.UTF_8).split(" ", 2);
            return words.length == 2 && words[0].equals(String.valueOf(system.getFileStatus(new Path(words[1])).getLen()));
        } catch (FileNotFoundException none) {
            return false;
        }
    }

    /** All is done. */
    void clear() throws IOException {
        system().delete(new Path(parts), true);
    }

    private void put(java.nio.file.Path from, Path to) throws IOException {
        FileSystem system = system();
        Path beside = new Path(to.getParent(), "_" + to.getName() + "." + UUID.randomUUID() + ".tmp");
        try {
            system.copyFromLocalFile(false, true, new Path(from.toUri()), beside);
            // Not every file system replaces one by another; who comes second brings the same bytes.
            system.delete(to, false);
            if (!system.rename(beside, to) && !system.exists(to)) {
                throw new IOException(to + " cannot be written");
            }
        } finally {
            system.delete(beside, false);
        }
    }
}
