package cz.paprsek.format.gltf;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Notes;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import java.io.IOException;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Materials as ours. What conducts at least by half is a metal: it mirrors all, in its colour. Everything else scatters its colour and mirrors by Fresnel's equations, unless
 * its roughness is above {@value #MATTE}, where that is hardly seen. What is transmitted is let through, bent if there is a volume, and as through a thin wall if there is none.
 *
 * @source Khronos Group, glTF 2.0 Specification, 2021, §3.9 and appendix B
 */
final class Materials {
    private static final double MATTE = 0.6;
    private static final List<String> UNREAD_PICTURES = List.of("normalTexture", "occlusionTexture", "emissiveTexture");

    private final Tree document;
    private final Images images;
    private final Notes notes;
    private final Map<Integer, String> names = new HashMap<>();
    private final Set<String> taken = new HashSet<>();
    private final Map<String, Material> materials = new LinkedHashMap<>();

    Materials(Tree document, Images images, Notes notes) {
        this.document = document;
        this.images = images;
        this.notes = notes;
    }

    Map<String, Material> all() {
        return materials;
    }

    /** The name of a material, which is then known. */
    String name(int index) throws IOException {
        String known = names.get(index);
        if (known == null) {
            Tree material = document.item("materials", index);
            String own = material.text("name", "").strip();
            String wanted = own.isEmpty() ? "material " + (index + 1) : own;
            known = wanted;
            for (int i = 2; !taken.add(known); i++) {
                known = wanted + " " + i;
            }
            names.put(index, known);
            materials.put(known, material(material));
        }
        return known;
    }

    /** How the places in the picture of a material are to be changed, and which of several are meant. */
    Mapping mapping(int index) throws IOException {
        Tree info = document.item("materials", index).childOrNothing("pbrMetallicRoughness").childOrNothing("baseColorTexture");
        return Mapping.of(info);
    }

    private Material material(Tree tree) throws IOException {
        Tree pbr = tree.childOrNothing("pbrMetallicRoughness");
        double[] base = factors(pbr, "baseColorFactor", 1, 1, 1, 1);
        Rgb color = Rgb.ofLinear(base[0], base[1], base[2]);
        Optional<String> picture = picture(pbr, color);
        Pattern pattern = picture.<Pattern>map(Pattern.Picture::of).orElse(new Pattern.Plain(color));
        UNREAD_PICTURES.stream().filter(tree::has).forEach(name -> notes.add(tree.path(), name + " is not read"));
        if (pbr.has("metallicRoughnessTexture")) {
            notes.add(tree.path(), "metallicRoughnessTexture is not read, only the factors");
        }
        if (tree.extension("KHR_materials_unlit").isPresent()) {
            if (picture.isPresent()) {
                notes.add(tree.path(), "a picture without light is lit");
                return Material.DEFAULT.withPattern(pattern).withDiffusion(1);
            }
            return Material.color(Rgb.BLACK).withDiffusion(0).withEmission(color, 1);
        }
        double opacity = opacity(tree, base[3]);
        boolean isMetal = pbr.share("metallicFactor", 1, 0, 1) >= 0.5 && !pbr.has("metallicRoughnessTexture");
        double roughness = pbr.share("roughnessFactor", 1, 0, 1);
        Material plain = Material.DEFAULT.withPattern(pattern);
        Material finished = isMetal ? plain.withDiffusion(0).withReflection(1).withFresnel(Fresnel.METAL).withRoughness(roughness) : dielectric(tree, plain, opacity, roughness);
        return emission(tree, finished);
    }

    private static double[] factors(Tree owner, String name, double... otherwise) throws FormatFault {
        double[] values = owner.numbers(name, otherwise);
        for (double value : values) {
            if (!(value >= 0 && value <= 1)) {
                throw owner.fault(name, "these must be numbers from 0 to 1");
            }
        }
        return values;
    }

    private double opacity(Tree tree, double alpha) throws FormatFault {
        return switch (tree.text("alphaMode", "OPAQUE")) {
            case "OPAQUE" -> 1;
            case "BLEND" -> alpha;
            case "MASK" -> {
                notes.add(tree.path(), "alphaMode MASK is not read, all is shown");
                yield 1;
            }
            default -> throw tree.fault("alphaMode", "this must be OPAQUE, MASK or BLEND");
        };
    }

    private Material dielectric(Tree tree, Material plain, double opacity, double roughness) throws FormatFault {
        double index = Math.min(100, Math.max(1, tree.extension("KHR_materials_ior").orElse(tree).number("ior", 1.5)));
        Tree transmission = tree.extension("KHR_materials_transmission").orElse(new Tree(tree.path(), Map.of()));
        double transmitted = transmission.share("transmissionFactor", 0, 0, 1);
        boolean mirrors = roughness <= MATTE || transmitted > 0;
        double scattered = (1 - transmitted) * opacity;
        Material lit = plain.withDiffusion(mirrors ? 0.96 * scattered : scattered).withReflection(mirrors ? 1 : 0).withFresnel(mirrors ? Fresnel.TRUE : Fresnel.FALSE)
                .withRoughness(mirrors ? roughness : 0);
        if (transmitted == 0) {
            Material bent = mirrors && index > 1 ? lit.withTransparency(1 - opacity, index) : lit.withTransparency(1 - opacity, 1);
            return opacity < 1 ? bent.withThin(true) : bent;
        }
        Tree volume = tree.extension("KHR_materials_volume").orElse(new Tree(tree.path(), Map.of()));
        boolean isThin = volume.number("thicknessFactor", 0) <= 0;
        // Ambient light counts with the colour, which of what strews nothing serves for nothing else.
        Material glass = (scattered == 0 ? lit.withPattern(new Pattern.Plain(Rgb.BLACK)) : lit).withTransparency(transmitted, index).withThin(isThin);
        return isThin ? glass : attenuated(volume, glass);
    }

    /** There, light is c^(d/D) of what it was; here exp(−(1 − c)·d/D), which comes to the same with another colour and, for dark ones, another distance. */
    private static Material attenuated(Tree volume, Material glass) throws FormatFault {
        double distance = volume.number("attenuationDistance", 0);
        double[] color = factors(volume, "attenuationColor", 1, 1, 1);
        double[] lost = new double[3];
        double most = 1;
        for (int i = 0; i < 3; i++) {
            lost[i] = -StrictMath.log(Math.max(1e-6, color[i]));
            most = Math.max(most, lost[i]);
        }
        return distance > 0 ? glass.withAttenuation(Rgb.ofLinear(1 - lost[0] / most, 1 - lost[1] / most, 1 - lost[2] / most), distance / most) : glass;
    }

    private static Material emission(Tree tree, Material material) throws FormatFault {
        double[] color = factors(tree, "emissiveFactor", 0, 0, 0);
        double strength = tree.extension("KHR_materials_emissive_strength").orElse(tree).number("emissiveStrength", 1);
        return color[0] + color[1] + color[2] > 0 ? material.withEmission(Rgb.ofLinear(color[0], color[1], color[2]), Math.max(0, Math.min(1e12, strength))) : material;
    }

    private Optional<String> picture(Tree pbr, Rgb color) throws IOException {
        Optional<Tree> info = pbr.child("baseColorTexture");
        if (info.isEmpty()) {
            return Optional.empty();
        }
        Optional<String> name = images.ofTexture(info.get().needed("index"));
        if (name.isPresent() && !color.equals(Rgb.WHITE)) {
            notes.add(pbr.path(), "baseColorFactor is not read beside a picture");
        }
        return name;
    }
}
