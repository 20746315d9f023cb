package cz.paprsek.cli.process;

import java.util.LinkedHashMap;
import java.util.Map;

/** How a command ended, as a number for scripts. Of several, the greatest counts. */
public final class ExitCode {
    public static final int DONE = 0;
    public static final int FAILED = 1;
    public static final int WRONG_USAGE = 2;
    public static final int BAD_SCENE = 3;
    /** Of a picture that several machines make: render them, then merge again. */
    public static final int PARTS_LACKING = 4;
    /** 128 and the number of the signal, as shells have it. */
    public static final int INTERRUPTED = 130;

    private ExitCode() {}

    /** The codes explained, for the help. */
    public static Map<String, String> explained() {
        Map<String, String> codes = new LinkedHashMap<>();
        codes.put(" 0", "done");
        codes.put(" 1", "reading, rendering or writing failed, or pictures differ");
        codes.put(" 2", "wrong usage");
        codes.put(" 3", "a scene or picture file is missing or not valid");
        codes.put(" 4", "parts of a picture are missing, damaged or of another");
        codes.put("130", "interrupted");
        return codes;
    }
}
