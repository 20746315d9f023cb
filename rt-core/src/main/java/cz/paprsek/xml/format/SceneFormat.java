package cz.paprsek.xml.format;

import cz.paprsek.attribute.Kind;

/** The limits of scene files, and their schema. */
public final class SceneFormat {
    public static final String NAMESPACE = "urn:paprsek:scene:1";

    /**
     * How deep elements may be nested in a file: far deeper than anybody builds, and safe for every recursion in the program. The hungriest is
     * the comparison of two scenes, which fills a stack of 1 MB at 570 levels.
     */
    public static final int DEEPEST = 250;

    /** In characters, as in the schema. */
    public static final int LONGEST_DESCRIPTION = (int) Kind.FREE_TEXT.most();

    private SceneFormat() {}

    /** The schema of files without formulas, repetition and the like, an XSD, made of what stands at the records. */
    public static String schema() {
        return Schema.text(false);
    }

    /** The schema of all files: the same with formulas in place of numbers and colours, and the elements that are written out. */
    public static String schemaWithFormulas() {
        return Schema.text(true);
    }

    /**
     * Whether a character may stand in a text as itself.
     *
     * @source W3C Extensible Markup Language 1.0, section 2.2
     */
    public static boolean isAllowed(int c) {
        return c == '\n' || (c >= ' ' && c <= 0xd7ff) || (c >= 0xe000 && c <= 0xfffd) || c >= 0x10000;
    }
}
