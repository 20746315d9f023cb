package cz.paprsek.xml;

/** What the reading of a file asks and tells its caller as it goes on, from the calling thread. Both methods must return quickly. */
public interface ReadMonitor {
    /** Never cancels, and listens to nothing. */
    ReadMonitor NONE = new ReadMonitor() {};

    /** Whether to stop; asked often. Once true, it should stay true. */
    default boolean cancelled() {
        return false;
    }

    /**
     * So much has been read. A file with problems is read twice: the second time, it begins from 0.
     *
     * @param bytes from the beginning
     * @param total the size of the file in bytes, 0 if it is not known, as that of a pipe
     */
    default void read(long bytes, long total) {}
}
