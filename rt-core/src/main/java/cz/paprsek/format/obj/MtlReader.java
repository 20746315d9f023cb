package cz.paprsek.format.obj;

import cz.paprsek.format.model.Companions;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.model.TextLines;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Reads materials (MTL). Colours are taken as linear light, as Blender writes them; what is said of reflections (illum 3 to 9) and of metal and roughness (Pm, Pr) is
 * taken along, but for pictures only that of the colour.
 *
 * @source Wavefront Technologies, MTL Material Format, version 4.2
 */
final class MtlReader {
    private final TextLines lines;
    private final Companions companions;
    private final Notes notes;
    private final Map<String, Material> materials = new LinkedHashMap<>();
    private String name = "";
    private Draft draft = new Draft();

    private MtlReader(TextLines lines, Companions companions, Notes notes) {
        this.lines = lines;
        this.companions = companions;
        this.notes = notes;
    }

    /** What a material says so far. */
    private static final class Draft {
        private Rgb color = Rgb.grey(204);
        private String picture = "";
        private double specular;
        private double shininess = 30;
        private double opacity = 1;
        private double index = 1;
        private Rgb emission = Rgb.BLACK;
        private double emissionStrength = 1;
        private double metal;
        private double roughness;
        private int illumination = 2;

        Material finished() {
            Pattern pattern = picture.isEmpty() ? new Pattern.Plain(color) : Pattern.Picture.of(picture);
            boolean isMetal = metal >= 0.5;
            boolean mirrors = illumination >= 3 && illumination <= 9 && illumination != 4;
            double mirrored = isMetal ? 1 : mirrors ? specular : 0;
            Material plain = Material.DEFAULT.withPattern(pattern).withDiffusion(isMetal ? 0 : opacity).withReflection(opacity < 1 && index > 1 ? 1 : mirrored)
                    .withTransparency(1 - opacity, opacity < 1 ? index : 1).withFresnel(isMetal ? Fresnel.METAL : opacity < 1 && index > 1 ? Fresnel.TRUE : Fresnel.FALSE)
                    .withEmission(emission, emissionStrength);
            return plain.withHighlight(isMetal ? 0 : specular, shininess).withRoughness(roughness);
        }
    }

    static Map<String, Material> read(String file, Companions companions, Notes notes) throws IOException {
        ByteBuffer content = companions.bytes(file);
        byte[] bytes = new byte[content.remaining()];
        content.get(bytes);
        return new MtlReader(new TextLines(new ByteArrayInputStream(bytes), true), companions, notes).read();
    }

    private Map<String, Material> read() throws IOException {
        while (lines.next()) {
            if (lines.word() && lines.letter(0) != '#') {
                line();
            }
        }
        finish();
        return materials;
    }

    private void line() throws IOException {
        if (lines.is("newmtl")) {
            finish();
            name = lines.rest();
            draft = new Draft();
        } else if (lines.is("kd")) {
            draft.color = color();
        } else if (lines.is("ks")) {
            Rgb strength = color();
            draft.specular = Math.max(strength.linearRed(), Math.max(strength.linearGreen(), strength.linearBlue()));
        } else if (lines.is("ke")) {
            emission();
        } else if (lines.is("ns")) {
            draft.shininess = Math.min(1e6, Math.max(0, lines.nextNumber("the exponent Ns")));
        } else if (lines.is("d")) {
            draft.opacity = share("the opacity d");
        } else if (lines.is("tr")) {
            draft.opacity = 1 - share("the transparency Tr");
        } else if (lines.is("ni")) {
            double index = lines.nextNumber("the refractive index Ni");
            draft.index = index > 0 ? Math.min(100, index) : 1;
        } else if (lines.is("illum")) {
            draft.illumination = (int) Math.min(99, lines.nextNumber("the illumination model"));
        } else if (lines.is("pm")) {
            draft.metal = share("the metallic share Pm");
        } else if (lines.is("pr")) {
            draft.roughness = share("the roughness Pr");
        } else if (lines.is("map_kd")) {
            picture();
        } else if (!lines.is("ka") && !lines.is("tf")) {
            notes.add("", "materials say " + FormatFault.quoted(lines.text()) + ", which is not understood");
        }
    }

    private void finish() {
        if (!name.isEmpty()) {
            materials.put(name, draft.finished());
        }
    }

    private double share(String what) throws IOException {
        return Math.min(1, Math.max(0, lines.nextNumber(what)));
    }

    /** One number for grey, or three. */
    private double[] light() throws IOException {
        if (lines.word() && (lines.is("spectral") || lines.is("xyz"))) {
            throw lines.fault("a colour must be three numbers, but is " + FormatFault.quoted(lines.text()));
        }
        double red = lines.number("red");
        double green = lines.word() ? lines.number("green") : red;
        return new double[] {Math.max(0, red), Math.max(0, green), Math.max(0, lines.word() ? lines.number("blue") : red)};
    }

    private Rgb color() throws IOException {
        double[] light = light();
        return Rgb.ofLinear(Math.min(1, light[0]), Math.min(1, light[1]), Math.min(1, light[2]));
    }

    private void emission() throws IOException {
        double[] light = light();
        double strength = Math.min(1e12, Math.max(light[0], Math.max(light[1], light[2])));
        if (strength > 0) {
            double most = Math.max(1, strength);
            draft.emission = Rgb.ofLinear(Math.min(1, light[0] / most), Math.min(1, light[1] / most), Math.min(1, light[2] / most));
            draft.emissionStrength = most;
        }
    }

    /** The name of a file comes last, after options each of which begins with a dash and has one or more words. */
    private void picture() {
        String rest = lines.rest();
        if (rest.startsWith("-")) {
            notes.add("", "options of pictures are not read");
            rest = rest.substring(rest.lastIndexOf(' ') + 1);
        }
        draft.picture = companions.picture(rest.replace('\\', '/').replaceFirst("^(\\./)+", ""));
    }
}
