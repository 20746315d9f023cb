package cz.paprsek.xml.text;

import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;

/** The bytes of a file with a valid content, to be changed where that changes. */
public final class FileText {
    private final byte[] file;
    private final Encoding encoding;
    private final Source source;
    private final Layout layout;

    /**
     * What a file becomes. Whoever writes it should read the sample first, and find in it what should be there.
     *
     * @param whole all its bytes
     * @param sample the same without the scenes of a database that are as they were
     * @param leftOut the scenes that are not in the sample, by identity
     */
    @SuppressWarnings("ArrayRecordComponent") // Handed over once, and never compared.
    public record Changed(byte[] whole, byte[] sample, Set<Form> leftOut) {}

    /** @throws Unpatchable if the text is in an encoding that is not known here, or not quite in its encoding */
    public FileText(byte[] file) {
        this.file = file;
        encoding = Encoding.of(file);
        source = new Source(encoding.toUtf8(file));
        layout = new Layout(source);
    }

    /**
     * A scene of this file as it is to stand in another: with the comments that belong to it, and of a file of its own with all that is around it.
     *
     * @param number which scene of a database it is, from 0
     * @param old the scene as it is in the file
     * @param now the scene as it should be
     * @throws Unpatchable if the text is not what it is said to be
     */
    public Excerpt excerpt(int number, Form old, Form now) {
        Element root = source.root();
        boolean isAlone = root.name().equals("scene");
        Element scene = isAlone ? root : source.children(root).get(number);
        Patcher patcher = new Patcher(source, layout, Integer.MAX_VALUE);
        patcher.patchElement(scene, old, now);
        int from = isAlone ? scene.start() : layout.startWithComments(scene);
        int to = isAlone ? scene.end() : layout.endWithComments(scene);
        byte[] text = patcher.edits().applied(source.bytes(), from, to);
        return new Excerpt(isAlone ? withAllAround(text) : text, layout.indent(scene), isAlone ? Map.of() : source.declarations(root));
    }

    /** The root element with the comments and instructions outside of it, which stand directly above it then, or behind it on its line. */
    private byte[] withAllAround(byte[] text) {
        StringBuilder all = new StringBuilder();
        Element root = source.root();
        for (int at = source.firstBehindDeclaration(); at < root.start(); at = source.nextToken(source.tokenEnd(at))) {
            all.append(source.text(at, source.tokenEnd(at))).append('\n');
        }
        all.append(new String(text, StandardCharsets.UTF_8));
        for (int at = source.nextToken(root.end()); at < source.bytes().length; at = source.nextToken(source.tokenEnd(at))) {
            all.append(' ').append(source.text(at, source.tokenEnd(at)));
        }
        return all.toString().getBytes(StandardCharsets.UTF_8);
    }

    /** Where its elements begin, by line and column. */
    public Places places() {
        return new Places(source);
    }

    /** The version of XML that it follows. */
    public String version() {
        return source.has("<?xml version=\"1.1\"", 0) || source.has("<?xml version='1.1'", 0) ? "1.1" : "1.0";
    }

    /** How its lines end. */
    public String lineBreak() {
        return layout.lineBreak();
    }

    /**
     * The file for what its content has become.
     *
     * @param old the root element as it is in the file
     * @param now the root element as it should be
     * @param deepest elements at this depth are written anew as a whole if they have changed; the root is at 0
     * @throws Unpatchable if the text is not what it is said to be
     */
    public Changed changed(Form old, Form now, int deepest) {
        Patcher patcher = new Patcher(source, layout, deepest);
        patcher.patchRoot(old, now);
        Set<Form> leftOut = Collections.newSetFromMap(new IdentityHashMap<>());
        if (patcher.edits().isEmpty()) {
            return new Changed(file, file, leftOut);
        }
        byte[] whole = encoding.fromUtf8(patcher.edits().applied(source.bytes()));
        if (patcher.kept().isEmpty()) {
            return new Changed(whole, whole, leftOut);
        }
        Edits sample = patcher.edits().copy();
        patcher.kept().forEach(kept -> {
            sample.remove(kept.element().start(), kept.element().end());
            leftOut.add(kept.form());
        });
        return new Changed(whole, encoding.fromUtf8(sample.applied(source.bytes())), leftOut);
    }
}
