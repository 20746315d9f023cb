package cz.paprsek.sheet;

import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The light of one ray, to be reckoned: what is given, then line by line what is to be found, each from numbers that stand above it. What needs more than a pocket
 * calculator (lights with a size, rough surfaces, what substances absorb) is given.
 */
final class RayExercise {
    private final Outline outline;
    private final Words words;
    private final Map<String, LinearRgb> found;
    private final List<Line> lines = new ArrayList<>();
    private LinearRgb sum = LinearRgb.BLACK;
    /** What adds up to that, and what it is called. */
    private final List<LinearRgb> terms = new ArrayList<>();
    private final List<String> names = new ArrayList<>();

    /** @param found light of the rays, by name, that exercises before this one are about, as reckoned there */
    RayExercise(Outline outline, Words words, Map<String, LinearRgb> found) {
        this.outline = outline;
        this.words = words;
        this.found = found;
        TracedRay ray = outline.ray();
        ray.encounter().ifPresentOrElse(this::met, () -> {
            sum = Pocket.of(ray.light());
            given(words.of("name.light-of", outline.name()), Pocket.text(sum));
        });
    }

    String name() {
        return outline.name();
    }

    String headline() {
        return outline.headline(words);
    }

    List<Line> lines() {
        return lines;
    }

    /** What comes out. */
    LinearRgb light() {
        return sum;
    }

    private void met(Encounter met) {
        TracedRay ray = outline.ray();
        Vec3 o = Pocket.of(ray.origin());
        Vec3 d = Pocket.of(ray.direction());
        double t = Pocket.of(met.place().distance());
        Vec3 n = Pocket.of(met.place().towardsViewer());
        LinearRgb color = Pocket.of(met.color());
        LinearRgb ambient = Pocket.of(met.ambientLight());
        LinearRgb own = Pocket.of(met.emitted());
        given("o", Pocket.text(o));
        given("d", Pocket.text(d));
        given("t", Pocket.text(t));
        given("N", Pocket.text(n));
        given("C", Pocket.text(color));
        given("A", Pocket.text(ambient));
        given(words.of("name.material"), material(met.material()));
        if (!own.equals(LinearRgb.BLACK)) {
            given(words.of("name.emission"), Pocket.text(own));
        }
        met.lights().forEach(term -> given(term));
        Vec3 p = Pocket.of(o.plus(d.times(t)));
        find("P = o + t·d", Pocket.text(o) + " + " + Pocket.text(t) + "·" + Pocket.text(d), Pocket.text(p));
        double c = Pocket.of(-d.dot(n));
        find("c = −d·N", "", Pocket.text(c));
        Vec3 r = Pocket.of(d.plus(n.times(2 * c)));
        if (met.material().specular() > 0 || met.reflected().isPresent()) {
            find("R = d + 2c·N", Pocket.text(d) + " + " + Pocket.text(2 * c) + "·" + Pocket.text(n), Pocket.text(r));
        }
        add(words.of("name.ambient"), "A·C", Pocket.text(ambient) + "·" + Pocket.text(color), Pocket.of(ambient.times(color)));
        if (!own.equals(LinearRgb.BLACK)) {
            add(words.of("name.emission"), own);
        }
        met.lights().forEach(term -> light(term, met.material(), color, p, n, r));
        met.refraction().ifPresent(this::bend);
        met.reflected().ifPresent(child -> followed(child, "R", met, "kR"));
        met.refracted().ifPresent(child -> followed(child, "T", met, "kT"));
        sum = Pocket.of(sum);
        String light = words.of("name.light-of", outline.name()) + " = ";
        find((ray.absorbed().isPresent() ? "" : light) + "Σ", String.join(" + ", names) + " = " + terms.stream().map(Pocket::text).collect(Collectors.joining(" + ")), Pocket.text(sum));
        ray.absorbed().map(by -> Pocket.of(by.left())).ifPresent(left -> {
            given("τ", Pocket.text(left));
            LinearRgb all = sum;
            sum = Pocket.of(all.times(left));
            find(light + "τ·Σ", Pocket.text(left) + "·" + Pocket.text(all), Pocket.text(sum));
        });
    }

    private String material(Material material) {
        return "kD " + Pocket.text(material.diffusion()) + ", kS " + Pocket.text(material.specular()) + ", n " + Pocket.text(material.shininess())
                + ", kR " + Pocket.text(material.reflection()) + ", kT " + Pocket.text(material.transparency());
    }

    /** Whether it is a light that can be reckoned with: one ray, nothing absorbed or strewn. */
    private static boolean isPlain(LightTerm term) {
        return term.rays().size() == 1 && term.ray().absorptions().isEmpty() && term.ray().strewn().isEmpty();
    }

    private void given(LightTerm term) {
        String name = words.of("name.light", term.label());
        ShadowRay ray = term.ray();
        if (!isPlain(term)) {
            given(name, Pocket.text(term.added()));
            return;
        }
        given(name, ray.target().map(at -> "Q = " + Pocket.text(at)).orElseGet(() -> "L = " + Pocket.text(ray.direction())) + ", I = " + Pocket.text(ray.intensity())
                + ", V = " + Pocket.text(ray.visibility()) + (ray.isSent() && ray.visibility() == 0 ? words.of("in-shadow") : ""));
    }

    private void light(LightTerm term, Material material, LinearRgb color, Vec3 p, Vec3 n, Vec3 r) {
        String name = words.of("name.light", term.label());
        ShadowRay ray = term.ray();
        if (!isPlain(term)) {
            add(name, Pocket.of(term.added()));
            return;
        }
        // A light that stands in the point, as far as four decimals tell, has no direction by them.
        Vec3 l = ray.target().map(at -> Pocket.of(at).minus(p)).filter(way -> !way.equals(Vec3.ZERO)).map(way -> Pocket.of(way.normalized())).orElseGet(() -> Pocket.of(ray.direction()));
        if (ray.target().isPresent()) {
            find(name + ": L = (Q − P)/|Q − P|", "", Pocket.text(l));
        }
        double facing = Pocket.of(n.dot(l));
        find("N·L", Pocket.text(n) + "·" + Pocket.text(l), Pocket.text(facing));
        double visible = Pocket.of(ray.visibility());
        if (visible == 0 || facing <= 0) {
            add(name, shines(material), "", LinearRgb.BLACK);
            return;
        }
        double diffuse = Pocket.of(material.diffusion() * facing);
        find("D = kD·(N·L)", Pocket.text(material.diffusion()) + "·" + Pocket.text(facing), Pocket.text(diffuse));
        double highlight = 0;
        if (material.specular() > 0) {
            double aligned = Pocket.of(r.dot(l));
            find("R·L", Pocket.text(r) + "·" + Pocket.text(l), Pocket.text(aligned));
            highlight = aligned > 0 ? Pocket.of(material.specular() * StrictMath.pow(aligned, material.shininess())) : 0;
            find("S = kS·max(0, R·L)ⁿ", Pocket.text(material.specular()) + "·max(0, " + Pocket.text(aligned) + ")^" + Pocket.text(material.shininess()), Pocket.text(highlight));
        }
        LinearRgb intensity = Pocket.of(ray.intensity());
        LinearRgb white = new LinearRgb(highlight, highlight, highlight);
        String reflected = Pocket.text(diffuse) + "·" + Pocket.text(color);
        add(name, shines(material), Pocket.text(visible) + "·" + Pocket.text(intensity) + "·" + (material.specular() > 0 ? "(" + reflected + " + " + Pocket.text(highlight) + ")" : reflected),
                Pocket.of(intensity.times(visible).times(color.times(diffuse).plus(white))));
    }

    private static String shines(Material material) {
        return material.specular() > 0 ? "V·I·(D·C + S)" : "V·I·D·C";
    }

    private void bend(Encounter.Refraction refraction) {
        double from = Pocket.of(refraction.from());
        double to = Pocket.of(refraction.to());
        double ratio = Pocket.of(from / to);
        given("n₁, n₂", Pocket.text(from) + ", " + Pocket.text(to));
        find("η = n₁/n₂", Pocket.text(from) + "/" + Pocket.text(to), Pocket.text(ratio));
        double before = Pocket.of(refraction.angleBeforeDegrees());
        find("θ₁ = arccos c", "", Pocket.text(before) + "°");
        double sine = Pocket.of(ratio * StrictMath.sin(Math.toRadians(before)));
        find("sin θ₂ = η·sin θ₁", Pocket.text(ratio) + "·sin " + Pocket.text(before) + "°", Pocket.text(sine));
        find("θ₂ = arcsin(sin θ₂)", "", refraction.isTotal() ? Pocket.text(sine) + words.of("no-angle") : Pocket.text(Math.toDegrees(StrictMath.asin(Math.min(1, sine)))) + "°");
    }

    private void followed(TracedRay child, String letter, Encounter met, String share) {
        String name = outline.name() + letter;
        LinearRgb weight = Pocket.of(child.weight());
        boolean isPlain = met.material().fresnel() == Fresnel.FALSE && met.facet().isEmpty() && met.refraction().map(bend -> !bend.isTotal()).orElse(true);
        if (!isPlain) {
            given(words.of("sheet.weight", name), Pocket.text(weight));
        }
        Optional<LinearRgb> known = Optional.ofNullable(found.get(name));
        LinearRgb light = known.orElse(Pocket.of(child.light()));
        if (known.isEmpty()) {
            given(words.of("name.light-of", name), Pocket.text(light));
        }
        add(name, (isPlain ? share : words.of("sheet.weight-letter")) + " · " + words.of("name.light-of", name), (isPlain ? Pocket.text(weight.red()) : Pocket.text(weight)) + "·" + Pocket.text(light),
                Pocket.of(light.times(weight)));
    }

    private void add(String name, String formula, String numbers, LinearRgb term) {
        find(name + ": " + formula, numbers, Pocket.text(term));
        add(name, term);
    }

    private void add(String name, LinearRgb term) {
        names.add(name);
        terms.add(term);
        sum = sum.plus(term);
    }

    private void given(String what, String value) {
        lines.add(new Line(what, "", value, true));
    }

    private void find(String formula, String numbers, String result) {
        lines.add(new Line(formula, numbers, result, false));
    }
}
