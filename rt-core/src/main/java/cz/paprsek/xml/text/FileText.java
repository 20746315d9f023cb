package cz.paprsek.xml.text;

import java.util.Collections;
import java.util.IdentityHashMap;
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
