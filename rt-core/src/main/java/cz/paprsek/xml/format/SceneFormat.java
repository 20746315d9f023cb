package cz.paprsek.xml.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Objects;

/** The limits of scene files, and their schema. */
public final class SceneFormat {
    public static final String NAMESPACE = "urn:paprsek:scene:1";

    /**
     * How deep elements may be nested in a file: far deeper than anybody builds, and safe for every recursion in the program. The hungriest is
     * the comparison of two scenes, which fills a stack of 1 MB at 570 levels.
     */
    public static final int DEEPEST = 250;

    /** In characters, as in the schema. */
    public static final int LONGEST_DESCRIPTION = 100_000;

    private SceneFormat() {}

    /** The schema, an XSD. */
    public static String schema() {
        try (InputStream input = Objects.requireNonNull(SceneFormat.class.getResourceAsStream("/cz/paprsek/xml/scene.xsd"), "scene.xsd is missing")) {
            return new String(input.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException("the schema in the program's own jar cannot be read", e);
        }
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
