package cz.paprsek.format.ply;

import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.Ints;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.shape.mesh.Triangles;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Colours of faces or of vertices as materials: one for each colour, and a part for each. Those of a triangle's corners are mixed in linear light. If there are more
 * than {@value #MOST}, they are made coarser, until there are not.
 */
final class Colors {
    private static final int MOST = 256;
    private static final double[] LIGHT = IntStream.range(0, 256).mapToDouble(Rgb::linear).toArray();

    private Colors() {}

    /** Gives triangles to the parts of their colours. */
    static final class Parting {
        private final Triangles.Builder builder;
        private final Ints ofFaces;
        private final Ints ofVertices;
        private final int mask;
        private final Map<Integer, String> names = new HashMap<>();

        Parting(Triangles.Builder builder, Ints ofFaces, Ints ofVertices) {
            this.builder = builder;
            this.ofFaces = ofFaces;
            this.ofVertices = ofVertices;
            this.mask = mask(ofFaces.size() > 0 ? ofFaces : ofVertices);
        }

        void triangle(int face, int a, int b, int c) {
            if (ofFaces.size() > face) {
                builder.part(names.computeIfAbsent(ofFaces.get(face) & mask, Colors::name));
            } else if (ofVertices.size() > 0) {
                builder.part(names.computeIfAbsent(mean(ofVertices.get(a), ofVertices.get(b), ofVertices.get(c)) & mask, Colors::name));
            }
            builder.triangle(a, b, c);
        }
    }

    static Model model(Triangles triangles, Ints ofFaces, Ints ofVertices, Convention convention, Notes notes) {
        if (ofFaces.size() == 0 && ofVertices.size() == 0) {
            return Model.of(triangles, convention, notes);
        }
        if (ofFaces.size() == 0) {
            notes.add("", "colours of vertices become one for each triangle");
        }
        Map<String, String> materialOf = new LinkedHashMap<>();
        Map<String, Material> materials = new LinkedHashMap<>();
        for (String name : triangles.parts()) {
            int color = name.length() == 7 ? Integer.parseInt(name.substring(1), 16) : 0xCCCCCC;
            materialOf.put(name, name);
            materials.put(name, Material.color(new Rgb(color >> 16, (color >> 8) & 255, color & 255)));
        }
        return new Model(triangles, materialOf, materials, Map.of(), List.of(), List.of(), convention, notes.toList());
    }

    private static String name(int color) {
        return String.format(Locale.ROOT, "#%06x", color);
    }

    /** Which bits of colours to keep, that there be few enough. */
    private static int mask(Ints colors) {
        int mask = 0xFFFFFF;
        for (int bits = 7; bits >= 2 && different(colors, mask) > MOST / 2; bits--) {
            int channel = 0xFF & (0xFF << (8 - bits));
            mask = channel << 16 | channel << 8 | channel;
        }
        return mask;
    }

    private static int different(Ints colors, int mask) {
        BitSet seen = new BitSet(1 << 24);
        for (int i = 0; i < colors.size(); i++) {
            seen.set(colors.get(i) & mask);
        }
        return seen.cardinality();
    }

    private static int mean(int a, int b, int c) {
        if (a == b && b == c) {
            return a;
        }
        int mixed = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            double light = (LIGHT[(a >> shift) & 255] + LIGHT[(b >> shift) & 255] + LIGHT[(c >> shift) & 255]) / 3;
            mixed = mixed << 8 | (int) Math.rint(Rgb.encoded(light));
        }
        return mixed;
    }
}
