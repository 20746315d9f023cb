package cz.paprsek.cli.process;

/** What is said where memory does not suffice. */
public final class Memory {
    private static final long MIB = 1L << 20;
    private static final long GIB = 1L << 30;
    /** What the program itself takes, and room for the collector to work in. */
    private static final long BESIDES = 256 * MIB;

    private Memory() {}

    /** The most that Java lets this process use. */
    public static long allowed() {
        return Runtime.getRuntime().maxMemory();
    }

    /**
     * What takes the memory, and how to give more.
     *
     * @param user what takes it, as in "the picture of 9x9 pixels"
     * @param bytes about how many it takes; 0 if nobody knows
     */
    public static String sentence(String user, long bytes) {
        long enough = Math.max(2 * allowed(), bytes + bytes / 4 + BESIDES);
        long gigabytes = (enough + GIB - 1) / GIB;
        return "not enough memory" + (user.isEmpty() ? "" : ": " + user + " takes " + (bytes > 0 ? "about " + shown(bytes) : "more")) + (user.isEmpty() ? "; " : ", but ")
                + "Java may use " + shown(allowed()) + "; give it more with PAPRSEK_JAVA_OPTIONS=-Xmx" + gigabytes + "g, or java -Xmx" + gigabytes + "g -jar";
    }

    private static String shown(long bytes) {
        // Made before each picture, in case: a formatter would take a hundredth of a second of a process just started.
        long tenths = Math.round(10.0 * bytes / GIB);
        return bytes < GIB ? (bytes + MIB - 1) / MIB + " MB" : tenths / 10 + "." + tenths % 10 + " GB";
    }
}
