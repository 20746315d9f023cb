package cz.paprsek.format.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What is in a file but not understood, or not taken along: each kind once, with where it is first met and how often. */
public final class Notes {
    private static final int MOST = 50;

    private final Map<String, Met> kinds = new LinkedHashMap<>();
    private final List<String> missing = new ArrayList<>();

    private record Met(String place, long times) {}

    /** @param what as in "texture maps of roughness are not read" */
    public void add(String place, String what) {
        if (kinds.size() < MOST || kinds.containsKey(what)) {
            kinds.merge(what, new Met(place, 1), (old, more) -> new Met(old.place, old.times + 1));
        }
    }

    /** What cannot be read of that which should be beside the file. */
    public void missing(long line, String what) {
        if (missing.size() < MOST && !missing.contains(what)) {
            missing.add(what);
        }
        line(line, what);
    }

    /** What is missing beside the file, in sentences. */
    public List<String> missing() {
        return List.copyOf(missing);
    }

    public void line(long line, String what) {
        add("line " + line, what);
    }

    public List<String> toList() {
        List<String> sentences = new ArrayList<>();
        kinds.forEach((what, met) -> sentences.add((met.place.isEmpty() ? "" : met.place + ": ") + what + (met.times > 1 ? " (" + met.times + " times)" : "")));
        return List.copyOf(sentences);
    }
}
