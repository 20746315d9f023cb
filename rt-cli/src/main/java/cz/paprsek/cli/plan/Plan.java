package cz.paprsek.cli.plan;

import cz.paprsek.cli.shard.Again;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * What is to be done by many machines.
 *
 * @param name of the scene's file
 * @param render words of the command line that renders it, from the scene's file on, without its share
 * @param shards how many shares there are
 * @param parallel how many of them are worked on at once
 * @param cpus processors of each
 * @param memory of each, in MiB
 * @param parts directory of the parts
 * @param picture file to be written in the end
 */
public record Plan(String name, List<String> render, int shards, int parallel, int cpus, int memory, String parts, String picture) {
    /** What Java itself takes beside its heap, at least, in MiB. */
    private static final int BESIDE = 256;
    private static final int LONGEST_LABEL = 40;

    public Plan {
        render = List.copyOf(render);
    }

    /** The words that render a share, for a shell. */
    String renderLine(String program, String shard) {
        List<String> words = new ArrayList<>(List.of(program, "render"));
        render.forEach(word -> words.add(Again.quoted(word)));
        words.addAll(List.of("--threads", Integer.toString(cpus), "--shard", shard, "-o", Again.quoted(parts)));
        return String.join(" ", words);
    }

    /** The words that put the picture together. */
    String mergeLine(String program) {
        return program + " merge " + Again.quoted(parts) + " -o " + Again.quoted(picture);
    }

    /** For Java, on so many processors: without being told, it may begin helpers for all that the machine has, each share for itself. */
    String javaOptions(int processors) {
        return "-Xmx" + heap() + "m -XX:ActiveProcessorCount=" + processors;
    }

    /** For Java's heap, in MiB: three quarters of what there is, or all but what Java takes itself. */
    private int heap() {
        return Math.max(64, Math.min(memory * 3 / 4, memory - BESIDE));
    }

    /** The name as all engines take it: small letters, digits and hyphens. */
    public String label() {
        String plain = Normalizer.normalize(name, Normalizer.Form.NFD).toLowerCase(Locale.ROOT).replaceAll("\\p{M}", "").replaceAll("[^a-z0-9]+", " ").strip();
        String label = plain.chars().limit(LONGEST_LABEL).mapToObj(Character::toString).collect(Collectors.joining()).strip().replace(' ', '-');
        return label.isEmpty() ? "scene" : label;
    }
}
