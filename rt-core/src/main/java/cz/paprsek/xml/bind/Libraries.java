package cz.paprsek.xml.bind;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;

/** The libraries that reading thoroughly needs, and reading a good file does not: they may be missing. */
final class Libraries {
    /** A class, by which it is told whether the library is there, and its name. */
    private static final Map<String, String> NEEDED = new LinkedHashMap<>();

    static {
        NEEDED.put("jakarta.xml.bind.JAXBContext", "jakarta.xml.bind-api");
        NEEDED.put("jakarta.activation.DataHandler", "jakarta.activation-api");
        NEEDED.put("org.glassfish.jaxb.core.v2.Messages", "jaxb-core");
        NEEDED.put("com.sun.istack.SAXParseException2", "istack-commons-runtime");
        NEEDED.put("org.glassfish.jaxb.runtime.v2.ContextFactory", "jaxb-runtime");
    }

    private Libraries() {}

    /** @throws IOException if one is missing, with a line that says which */
    static void require(String file) throws IOException {
        try {
            Binding.prepare();
        } catch (LinkageError incomplete) {
            for (Map.Entry<String, String> one : NEEDED.entrySet()) {
                if (!isThere(one.getKey())) {
                    throw new IOException(file + ": something is wrong with this file, or unusual; to tell what, the library " + one.getValue()
                            + " (JAXB) is needed, which is missing on the class path", incomplete);
                }
            }
            throw incomplete;
        }
    }

    private static boolean isThere(String name) {
        try {
            Class.forName(name, false, Libraries.class.getClassLoader());
            return true;
        } catch (ClassNotFoundException | LinkageError missing) {
            return false;
        }
    }
}
