package cz.paprsek.material;

import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Pattern.Lay;
import cz.paprsek.material.Pattern.Stop;
import cz.paprsek.material.Pattern.Stops;
import cz.paprsek.math.Vec3;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Materials that every scene knows by name, unless it has one of its own of that name. Bodies are taken to be about 1 across. Where the numbers come
 * from stands in {@code docs/materials.md}.
 */
final class ReadyMaterials {
    private static final Map<String, Material> ALL = new ReadyMaterials().all();

    private final Map<String, Material> made = new LinkedHashMap<>();

    private ReadyMaterials() {}

    /** All of them by name: glass and stones, metals, what is coated or matte, patterns. Cannot be changed. */
    static Map<String, Material> byName() {
        return ALL;
    }

    private Map<String, Material> all() {
        Material glass = clear(1.52);
        put("glass", glass.withAttenuation(Rgb.ofLinear(0.93, 0.98, 0.95), 1));
        put("frosted-glass", glass.withRoughness(0.4));
        put("water", clear(1.333).withAttenuation(Rgb.ofLinear(0.66, 0.94, 0.99), 1));
        put("ice", clear(1.31).withRoughness(0.15).withAttenuation(Rgb.ofLinear(0.8, 0.95, 1), 1));
        put("diamond", clear(2.417));
        put("ruby", clear(1.77).withAttenuation(Rgb.ofLinear(0.8, 0.01, 0.05), 0.1));
        put("sapphire", clear(1.77).withAttenuation(Rgb.ofLinear(0.02, 0.1, 0.85), 0.1));
        put("emerald", clear(1.58).withAttenuation(Rgb.ofLinear(0.03, 0.75, 0.2), 0.1));
        put("amber", clear(1.54).withAttenuation(Rgb.ofLinear(0.95, 0.4, 0.01), 0.1));
        put("bubble", clear(1.33).withThin(true));

        metal("gold", 1, 0.782, 0.344, 0.05);
        metal("silver", 0.972, 0.960, 0.915, 0.05);
        metal("copper", 0.955, 0.638, 0.538, 0.1);
        metal("brass", 0.910, 0.778, 0.423, 0.1);
        metal("chrome", 0.549, 0.556, 0.554, 0);
        metal("aluminium", 0.913, 0.922, 0.924, 0.35);
        metal("steel", 0.562, 0.565, 0.578, 0.25);
        metal("iron", 0.562, 0.565, 0.578, 0.55);
        metal("titanium", 0.542, 0.497, 0.449, 0.3);
        put("mirror", Material.color(Rgb.BLACK).withDiffusion(0).withReflection(0.95));

        coated("porcelain", new Rgb(244, 242, 236), 0);
        coated("plastic", new Rgb(214, 48, 40), 0.2);
        coated("lacquer", new Rgb(24, 20, 22), 0);
        coated("jade", new Rgb(74, 150, 104), 0.25);
        coated("pearl", new Rgb(240, 230, 222), 0.3);
        put("wax", Material.color(246, 226, 180).withDiffusion(0.85).withHighlight(0.12, 12));
        put("rubber", Material.color(58, 58, 62).withDiffusion(0.85).withHighlight(0.06, 8));
        // Seen straight on hardly anything is mirrored, at its rim nearly all.
        put("velvet", Material.color(112, 14, 40).withDiffusion(0.6).withReflection(0.4).withTransparency(0, 1.2).withFresnel(Fresnel.TRUE).withRoughness(0.8));
        put("terracotta", Material.color(196, 104, 72).withDiffusion(0.85));
        put("plaster", Material.color(240, 238, 232).withDiffusion(0.9));
        put("neon", Material.color(Rgb.BLACK).withDiffusion(0).withEmission(new Rgb(255, 96, 60), 1.6));

        Lay half = Lay.scaled(0.5);
        polished("marble", new Pattern.Marble(1.2, 1.6, 6, 3, Stops.of(
                new Stop(0, new Rgb(246, 244, 240)), new Stop(0.6, new Rgb(226, 224, 222)), new Stop(0.85, new Rgb(150, 150, 156)), new Stop(1, new Rgb(96, 98, 108))),
                half.withRotation(new Vec3(0, 25, 35))), 0);
        polished("granite", new Pattern.Granite(8, 5, Stops.of(
                new Stop(0, new Rgb(40, 36, 36)), new Stop(0.25, new Rgb(128, 96, 90)), new Stop(0.5, new Rgb(190, 160, 150)), new Stop(1, new Rgb(236, 226, 220))),
                Lay.scaled(0.25)), 0.1);
        polished("wood", new Pattern.Wood(7, 0.5, 3, 2, Stops.of(
                new Stop(0, new Rgb(206, 150, 92)), new Stop(0.7, new Rgb(176, 112, 62)), new Stop(1, new Rgb(118, 68, 36))),
                half.withPosition(new Vec3(0.3, 0, 0.9)).withRotation(new Vec3(84, 0, 6))), 0.35);
        return Collections.unmodifiableMap(made);
    }

    private void put(String name, Material material) {
        made.put(name, material);
    }

    /** Black, because ambient light counts with the colour, whatever the diffusion: any other makes it milky. */
    private static Material clear(double index) {
        return Material.color(Rgb.BLACK).withDiffusion(0).withReflection(1).withTransparency(1, index).withFresnel(Fresnel.TRUE);
    }

    /** @param red of light that is mirrored straight on, the share in linear light */
    private void metal(String name, double red, double green, double blue, double roughness) {
        put(name, Material.color(Rgb.ofLinear(red, green, blue)).withDiffusion(0).withReflection(1).withFresnel(Fresnel.METAL).withRoughness(roughness));
    }

    private void coated(String name, Rgb color, double roughness) {
        polished(name, new Pattern.Plain(color), roughness);
    }

    /** Of 0.4 a share of 0.1 is mirrored straight on: 4 %, as by any lacquer of an index of 1.5, and no more than there is when grazed. */
    private void polished(String name, Pattern pattern, double roughness) {
        put(name, Material.DEFAULT.withPattern(pattern).withDiffusion(0.6).withReflection(0.4).withTransparency(0, 1.925).withFresnel(Fresnel.TRUE)
                .withRoughness(roughness));
    }
}
