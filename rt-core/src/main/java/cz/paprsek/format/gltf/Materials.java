package cz.paprsek.format.gltf;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Notes;
import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Material.Shares;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.material.Share.ColorChannel;
import cz.paprsek.material.Share.Even;
import java.io.IOException;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Materials as ours, by their {@link Finish}. What is transmitted is let through, bent if there is a volume, and as through a thin wall if there is none. What is cut out or mixed
 * with what is behind it lets that through unbent. Where our shares come of several pictures or of a factor, pictures of our own are made.
 *
 * @source Khronos Group, glTF 2.0 Specification, 2021, §3.9 and appendix B
 */
final class Materials {
    private final Tree document;
    private final Images images;
    private final Notes notes;
    private final Map<Integer, String> names = new HashMap<>();
    private final Map<Integer, Slots> slots = new HashMap<>();
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
            materials.put(known, material(material, slots(index), String.valueOf(index)));
        }
        return known;
    }

    /** How the places in the pictures of a material are to be changed, and which of several are meant. */
    Mapping mapping(int index) throws IOException {
        return slots(index).mapping();
    }

    private Slots slots(int index) throws IOException {
        Slots known = slots.get(index);
        if (known == null) {
            known = Slots.of(document.item("materials", index), document, images, notes);
            slots.put(index, known);
        }
        return known;
    }

    /** @param number of the material, for the names of pictures that are made for it */
    private Material material(Tree tree, Slots pictures, String number) throws IOException {
        Tree pbr = tree.childOrNothing("pbrMetallicRoughness");
        double[] base = factors(pbr, "baseColorFactor", 1, 1, 1, 1);
        Rgb color = Rgb.ofLinear(base[0], base[1], base[2]);
        Pattern pattern = pictures.color().isPresent() ? pictures.picture(tinted(pictures.color().get(), base, number), notes) : new Pattern.Plain(color);
        Material relief = relief(tree, Material.DEFAULT.withPattern(pattern), pictures);
        if (tree.extension("KHR_materials_unlit").isPresent()) {
            if (pictures.color().isPresent()) {
                notes.add(tree.path(), "a picture without light is lit");
                return relief.withDiffusion(1);
            }
            return Material.color(Rgb.BLACK).withDiffusion(0).withEmission(color, 1);
        }
        Tree transmission = tree.extension("KHR_materials_transmission").orElse(Tree.NOTHING);
        Channel cover = cover(tree, base[3], pictures);
        Channel rough = channel(pictures.metal(), Channel.GREEN, pbr.share("roughnessFactor", 1, 0, 1));
        Finish finish = new Finish(cover, channel(pictures.metal(), Channel.BLUE, pbr.share("metallicFactor", 1, 0, 1)), rough,
                channel(pictures.transmission(), Channel.RED, transmission.share("transmissionFactor", 0, 0, 1)));
        boolean isGlass = !finish.isMetal() && transmission.number("transmissionFactor", 0) > 0;
        Tree volume = isGlass ? tree.extension("KHR_materials_volume").orElse(Tree.NOTHING) : Tree.NOTHING;
        boolean isThin = finish.isSeenThrough() && volume.number("thicknessFactor", 0) <= 0;
        Material even = relief.withDiffusion(finish.diffusion()).withReflection(finish.reflection()).withTransparency(finish.transparency(), index(tree, finish))
                .withFresnel(finish.isMetal() ? Fresnel.METAL : finish.mirrors() ? Fresnel.TRUE : Fresnel.FALSE).withRoughness(finish.mirrors() ? rough.most() : 0).withThin(isThin);
        if (finish.isEven() && finish.diffusion() == 0 && !finish.isMetal()) {
            // Clear glass has no colour of its own that light from everywhere could show.
            if (base[0] * base[1] * base[2] < 1 || pictures.color().isPresent()) {
                notes.add(tree.path(), "what is let through takes the attenuationColor only, not the colour of the surface");
            }
            even = even.withPattern(new Pattern.Plain(Rgb.BLACK));
        }
        Material finished = even.withShares(shares(even, finish, rough, pictures, number));
        return emission(tree, isThin || !isGlass ? finished : attenuated(volume, finished), pictures);
    }

    private static double index(Tree tree, Finish finish) throws FormatFault {
        double index = tree.extension("KHR_materials_ior").orElse(Tree.NOTHING).number("ior", 1.5);
        return finish.isMetal() || !finish.mirrors() ? 1 : Math.min(100, Math.max(1, index));
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

    private Channel channel(Optional<Slot> slot, int shift, double factor) throws IOException {
        return slot.isEmpty() || factor == 0 ? Channel.of(factor) : Channel.of(decoded(slot.get(), false), shift, factor);
    }

    private Image decoded(Slot slot, boolean withOpacity) throws IOException {
        return images.decoded(slot.texture(), slot.file(), withOpacity);
    }

    /** How much of what is behind it a surface covers. */
    private Channel cover(Tree tree, double alpha, Slots pictures) throws IOException {
        String mode = tree.text("alphaMode", "OPAQUE");
        Channel all = mode.equals("OPAQUE") ? Channel.of(1) : pictures.color().isEmpty() ? Channel.of(alpha) : Channel.of(decoded(pictures.color().get(), true), Channel.ALPHA, alpha);
        return switch (mode) {
            case "OPAQUE", "BLEND" -> all;
            case "MASK" -> all.cut(tree.number("alphaCutoff", 0.5));
            default -> throw tree.fault("alphaMode", "this must be OPAQUE, MASK or BLEND");
        };
    }

    /** A picture times a colour, in linear light. */
    private Slot tinted(Slot slot, double[] color, String number) throws IOException {
        if (color[0] == 1 && color[1] == 1 && color[2] == 1) {
            return slot;
        }
        Image picture = decoded(slot, false);
        Image tinted = Image.ofEightBit(picture.width(), picture.height());
        for (int y = 0; y < picture.height(); y++) {
            for (int x = 0; x < picture.width(); x++) {
                tinted.set(x, y, picture.red(x, y) * color[0], picture.green(x, y) * color[1], picture.blue(x, y) * color[2]);
            }
        }
        return slot.with(images.made("color-" + number, tinted));
    }

    private Material relief(Tree tree, Material material, Slots pictures) throws IOException {
        if (pictures.normal().isEmpty()) {
            return material;
        }
        Slot slot = pictures.normal().get();
        double strength = tree.childOrNothing("normalTexture").number("scale", 1);
        return material.withRelief(new Material.NormalMap(slot.file(), strength, slot.filter(), Pattern.Mapping.UV, pictures.lay(slot, notes)));
    }

    private Shares shares(Material even, Finish finish, Channel roughness, Slots pictures, String number) throws IOException {
        Share same = new Even();
        Share rough = even.roughness() == 0 || roughness.isEven() ? same : rough(roughness, pictures, number);
        if (finish.isEven()) {
            return new Shares(same, same, same, same, rough);
        }
        Slot from = pictures.metal().or(pictures::color).or(pictures::transmission).orElseThrow();
        Pattern picture = pictures.picture(from.with(images.made("shares-" + number, finish.shares())), notes);
        return new Shares(new ByPattern(ColorChannel.RED, picture), same, new ByPattern(ColorChannel.GREEN, picture), new ByPattern(ColorChannel.BLUE, picture), rough);
    }

    private Share rough(Channel roughness, Slots pictures, String number) throws IOException {
        Slot slot = pictures.metal().orElseThrow();
        Slot own = roughness.factor() == 1 ? slot : slot.with(images.made("roughness-" + number, Finish.picture(roughness)));
        return new ByPattern(ColorChannel.GREEN, pictures.picture(own, notes));
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

    /** Light that differs from point to point shines everywhere as its mean does. */
    private Material emission(Tree tree, Material material, Slots pictures) throws IOException {
        double[] color = factors(tree, "emissiveFactor", 0, 0, 0);
        double strength = Math.max(0, Math.min(1e12, tree.extension("KHR_materials_emissive_strength").orElse(Tree.NOTHING).number("emissiveStrength", 1)));
        if (tree.has("emissiveTexture")) {
            notes.add(tree.path(), "emissiveTexture is read as its mean");
            double[] mean = pictures.emission().isEmpty() ? new double[3] : mean(decoded(pictures.emission().get(), false));
            for (int i = 0; i < 3; i++) {
                color[i] *= mean[i];
            }
        }
        return color[0] + color[1] + color[2] > 0 ? material.withEmission(Rgb.ofLinear(color[0], color[1], color[2]), strength) : material;
    }

    private static double[] mean(Image image) {
        double[] sum = new double[3];
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                sum[0] += image.red(x, y);
                sum[1] += image.green(x, y);
                sum[2] += image.blue(x, y);
            }
        }
        double count = (double) image.width() * image.height();
        return new double[] {sum[0] / count, sum[1] / count, sum[2] / count};
    }
}
