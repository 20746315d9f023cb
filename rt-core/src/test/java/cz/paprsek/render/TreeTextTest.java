package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.drawing.TreeDrawing;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.render.explain.text.Step;
import cz.paprsek.render.explain.text.TreeJson;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import cz.paprsek.words.Words;
import java.io.StringReader;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.xml.sax.InputSource;

class TreeTextTest {
    /** The eye looks at a ball of glass before a wall with a hole. */
    private static Scene glassBall() {
        return Scene.EMPTY.withSettings(new RenderSettings(1, 1, 3, 1))
                .withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)))
                .withBackground(Rgb.WHITE)
                .plus(Light.at(0, 0, 9).named("lamp"))
                .plus(SceneObject.of(new Sphere(1)).named("ball").madeOf(Material.color(Rgb.WHITE).withDiffusion(0.1).withHighlight(0.5, 20)
                        .withReflection(0.05).withTransparency(0.8, 1.5)))
                .plus(SceneObject.of(Csg.difference(Operand.of(new Block(new Vec3(-3, -3, -4), new Vec3(3, 3, -3))),
                        Operand.of(new Sphere(0.5)).at(0, 0, -3).named("hole"))).named("wall"));
    }

    private static String text(Scene scene, double smallestShare) {
        return String.join("\n", TreeText.lines(RenderScene.of(scene).explain(0, 0), smallestShare, Decoration.NONE));
    }

    static Stream<Light> inTheHit() {
        Vec3 near = new Vec3(1e-170, -1e-170, 1e-170);
        return Stream.of(Light.at(0, 0, 0), Light.at(near.x(), near.y(), near.z()), Light.at(0, 0, 0).withReferenceDistance(2), SpotLight.from(near, new Vec3(0, 0, -1)),
                SpotLight.from(Vec3.ZERO, new Vec3(0, 0, 1)));
    }

    /** A light in the very point that is seen sheds nothing there; the way to it has no direction. */
    @ParameterizedTest
    @MethodSource("inTheHit")
    void aLightInTheHitIsSaidToBeThere(Light light) {
        Material matt = Material.color(Rgb.WHITE).withHighlight(0.5, 20);
        for (Material material : List.of(matt, matt.withReflection(0.5).withRoughness(0.3))) {
            Scene scene = Scene.EMPTY.withSettings(new RenderSettings(1, 1, 3, 1)).withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)))
                    .plus(light.named("lamp")).plus(SceneObject.of(new Rectangle(-1, -1, 1, 1)).madeOf(material));
            assertThat(text(scene, 0.1)).contains("the light stands in this point itself: nothing");
            assertThat(RenderScene.of(scene).explain(0, 0).light().red()).isZero();
        }
    }

    @Test
    void aTreeReadsLikeAWorkedExercise() {
        assertThat(text(glassBall(), 0.1).replaceAll(" +", " ").replaceAll("(?m)^ | $", "")).startsWith("""
                E from the eye, hits sphere "ball" 100 %
                │ ray o = (0, 0, 5)
                │ d = (0, 0, −1)
                │ medium outside of all solids, refractive index 1
                │ hits sphere "ball", from outside
                │ distance t = 4
                │ point P = o + t·d = (0, 0, 5) + 4·(0, 0, −1) = (0, 0, 1)
                │ normal N = (0, 0, 1)
                │ angle cos θ₁ = −d·N = −(0, 0, −1)·(0, 0, 1) = 1, θ₁ = 0°
                │ material kD 0.1, kS 0.5, n 20, kR 0.05, kT 0.8, refractive index 1.5
                │ colour C = (1, 1, 1)
                │ ambient A·C = (0, 0, 0)·(1, 1, 1) = (0, 0, 0)
                │ light "lamp" L, towards (0, 0, 9) = (0, 0, 1)
                │ N·L = (0, 0, 1)·(0, 0, 1) = 1
                │ V = 1, nothing is in the way
                │ diffuse D = kD·N·L = 0.1·1 = 0.1
                │ R·L = (0, 0, 1)·(0, 0, 1) = 1
                │ highlight S = kS·max(0, R·L)ⁿ = 0.5·1²⁰ = 0.5
                │ V·I·(D·C + S) = 1·(1, 1, 1)·(0.1·C + 0.5) = (0.6, 0.6, 0.6)
                │ reflection R = d + 2·cos θ₁·N = d + 2·N = (0, 0, 1)
                │ kR · light of ER = 0.05·(1, 1, 1) = (0.05, 0.05, 0.05)
                │ refraction η = n₁/n₂ = 1 / 1.5 = 0.6667
                │ sin θ₂ = η·sin θ₁ = 0.6667 · sin 0° = 0, θ₂ = 0°
                │ T = η·d + (η·cos θ₁ − cos θ₂)·N = 0.6667·d + (0.6667 − 1)·N = (0, 0, −1)
                │ kT · light of ET = 0.8·(0.89, 0.89, 0.89) = (0.712, 0.712, 0.712)
                │ + light "lamp" = (0.6, 0.6, 0.6)
                │ + mirrored, from ER = (0.05, 0.05, 0.05)
                │ + shining through, from ET = (0.712, 0.712, 0.712)
                │ light of E = (1.36, 1.36, 1.36)
                │
                ├─ER reflected, sees the background 5 %
                │ too small a share to be shown
                │
                └─ET refracted, hits sphere "ball" from inside 80 %
                │ ray o = (0, 0, 1)
                │ d = (0, 0, −1)
                │ medium sphere "ball", refractive index 1.5
                │ hits sphere "ball", from inside
                │ distance t = 2
                │ point P = o + t·d = (0, 0, 1) + 2·(0, 0, −1) = (0, 0, −1)
                │ normal N, turned round = (0, 0, 1)
                │ angle cos θ₁ = −d·N = −(0, 0, −1)·(0, 0, 1) = 1, θ₁ = 0°
                │ material kD 0.1, kS 0.5, n 20, kR 0.05, kT 0.8, refractive index 1.5
                │ colour C = (1, 1, 1)
                │ ambient A·C = (0, 0, 0)·(1, 1, 1) = (0, 0, 0)
                │ light "lamp" L, towards (0, 0, 9) = (0, 0, 1)
                │ N·L = (0, 0, 1)·(0, 0, 1) = 1
                │ through sphere "ball" at 2, kT 0.8
                │ V = 0.8
                """);
    }

    @Test
    void aTreeIsToldInCzechWithTheSameFiguresToo() {
        Pixel pixel = RenderScene.of(glassBall()).explain(0, 0);
        List<String> czech = TreeText.lines(pixel, 0, Decoration.NONE, Words.in(Locale.forLanguageTag("cs-CZ")));
        assertThat(czech).hasSameSizeAs(TreeText.lines(pixel, 0, Decoration.NONE));
        assertThat(String.join("\n", czech)).contains("E  z oka, dopadne na: koule \"ball\"  100 %", "N, otočená", "index lomu 1,5",
                        "rozdíl \"wall\" › koule \"hole\", stěna otvoru, zvenku", "světlo paprsku ETT")
                .doesNotContain("sphere", "light", "hits", "{").doesNotContainPattern("[0-9]\\.[0-9]");
    }

    @Test
    void bothLanguagesSayTheSame() {
        ResourceBundle english = bundle(Locale.ENGLISH);
        ResourceBundle czech = bundle(Locale.forLanguageTag("cs"));
        assertThat(czech.keySet()).isEqualTo(english.keySet());
        for (String key : english.keySet()) {
            assertThat(places(czech.getString(key))).as(key).isEqualTo(places(english.getString(key)));
        }
    }

    private static ResourceBundle bundle(Locale locale) {
        return ResourceBundle.getBundle("cz.paprsek.words.words", locale,
                ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));
    }

    private static List<String> places(String text) {
        return Stream.of("{0}", "{1}", "{2}").filter(text::contains).toList();
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void everyKindAndFaceHasAWord(Shape shape) {
        Words czech = Words.in(Locale.forLanguageTag("cs"));
        assertThat(czech.of("kind." + shape.kind())).isNotBlank();
        TracedRay ray = RenderScene.of(glassBall().withObjects(List.of(SceneObject.of(shape).rotated(20, 30, 0)))).explain(0, 0).rays().get(0);
        assertThat(ray.encounter()).isPresent();
        assertThat(Outline.of(ray).steps(czech)).extracting(Step::name).contains("normála");
    }

    static Stream<Shape> kinds() {
        Sphere ball = new Sphere(1);
        return Stream.of(ball, new Block(new Vec3(-1, -1, -1), new Vec3(1, 1, 1)), new Cylinder(1, 1), new Cone(1, 0.5, 1), new Torus(1, 0.99),
                new Ellipsoid(new Vec3(1, 2, 1)), new Plane(), new Rectangle(-1, -1, 1, 1), new Disc(1), Csg.union(ball, ball),
                Csg.intersection(ball, ball), Csg.difference(ball, new Sphere(0.5)));
    }

    @Test
    void aHoleIsNamedByItsPath() {
        assertThat(text(glassBall(), 0)).contains("difference \"wall\" › sphere \"hole\", the wall of a hole, from outside");
    }

    @Test
    void theEndOfTheDepthIsTold() {
        assertThat(text(glassBall(), 0)).contains("level 3 is the last: what would be mirrored or shine through is black");
    }

    @Test
    void severalRaysOfAPixelFollowEachOther() {
        Scene scene = glassBall();
        assertThat(text(scene.withSettings(scene.settings().withSamples(2)), 0))
                .startsWith("ray 1 of 4\nE  from the eye").contains("\nray 4 of 4\n")
                .containsPattern("\npixel 0, 0: the average of 4 rays = \\(.*\\), in sRGB \\d+ \\d+ \\d+$");
    }

    @Test
    void jsonHasTheWholeTree() {
        Pixel pixel = RenderScene.of(glassBall()).explain(0, 0);
        String json = TreeJson.of(pixel).toString();
        assertThat(json).startsWith("{\"column\":0,\"row\":0,\"light\":[")
                .contains("\"surface\":{\"path\":[0],\"names\":[\"sphere \\\"ball\\\"\"]}")
                .contains("\"refraction\":{\"n1\":1,\"n2\":1.5,\"angle-degrees\":0,\"angle-beyond-degrees\":0,"
                        + "\"critical-angle-degrees\":null,\"total\":false}");
        assertThat(List.of(json.split("\"kind\":", -1))).hasSize(1 + rays(pixel.rays()));
    }

    @Test
    void everySampleSaysWhereInThePixelItGoes() {
        Scene scene = Scenes.empty().withCamera(Camera.looking(new Vec3(0, 0, 5), Vec3.Z.negated()).withFovy(90)).withSettings(new RenderSettings(8, 4, 3, 2));
        assertThat(TreeJson.of(RenderScene.of(scene).explain(5, 1)).toString()).contains("\"in-pixel\":[0.25,0.25]", "\"in-pixel\":[0.75,0.25]", "\"in-pixel\":[0.25,0.75]");
        Pixel pixel = RenderScene.of(scene).explain(scene.settings().withSamples(3, 3).withFilter(RenderSettings.PixelFilter.MITCHELL), 5, 1);
        assertThat(TreeText.sample(pixel, 0, Words.ENGLISH)).matches("ray 1 of 9  \\(.*, .*\\)  \\(0, 0, 0\\) · .*");
        for (int i = 0; i < pixel.rays().size(); i++) {
            // At distance 1 the picture is 4 wide and 2 high.
            Vec3 way = new Vec3((5 + pixel.places().get(i).x()) / 2 - 2, 1 - (1 + pixel.places().get(i).y()) / 2, -1).normalized();
            assertThat(pixel.rays().get(i).direction().minus(way).length()).as("ray %d", i).isCloseTo(0, within(1e-12));
        }
        assertThat(pixel.places()).as("wide filters reach beyond").anyMatch(place -> place.x() < 0 || place.x() > 1);
    }

    @Test
    void aDrawingHasEveryRayInThreeProjections() throws Exception {
        Scene scene = glassBall();
        Pixel pixel = RenderScene.of(scene).explain(0, 0);
        String svg = TreeDrawing.svg(scene, pixel.rays().get(0), 0, Words.ENGLISH);
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(svg)));
        for (String word : List.of(">Front (x, y)<", ">Top (x, z)<", ">Right (z, y)<")) {
            assertThat(svg).contains(word);
        }
        assertThat(svg.split(">ETT<", -1)).as("a ray's name in each view").hasSize(4);
        assertThat(TreeDrawing.svg(scene, pixel.rays().get(0), 0.9, Words.ENGLISH)).doesNotContain(">ETT<");
        Scene nothing = Scenes.empty();
        assertThat(TreeDrawing.svg(nothing, RenderScene.of(nothing).explain(0, 0).rays().get(0), 0, Words.ENGLISH)).contains(">E<");
    }

    @ParameterizedTest
    @CsvSource({"en, looked for by 5 shadow rays, their mean, 'right, up of its middle', all rays meet in, ray , ' of 4, whose light is nearest'",
            "cs, hledáno stínovými paprsky (počet: 5), jejich průměr, 'vpravo, nahoru od středu', všechny paprsky se protnou v, paprsek , ' z 4, jehož světlo je bodu nejblíž'"})
    void lensSizedLightsAndSamplesAreToldInBothLanguages(Locale language, String shadows, String mean, String lens, String focus, String ray, String nearest) {
        Scene scene = Scenes.empty().withCamera(Camera.lookingAt(new Vec3(0, 0, 5), Vec3.ZERO).withLens(Lens.Perspective.DEFAULT.withAperture(0.1)))
                .withLights(List.of(SphereLight.of(new Vec3(2, 3, 4), 0.5).withSamples(5))).plus(SceneObject.of(new Sphere(1)));
        Pixel pixel = RenderScene.of(scene).explain(scene.settings().withSamples(2, 2), 16, 12);
        List<String> typical = TreeText.lines(pixel, 0.01, Decoration.NONE, Words.in(language));
        assertThat(String.join("\n", typical)).containsOnlyOnce(shadows).containsOnlyOnce(mean).containsOnlyOnce(lens).containsOnlyOnce(focus)
                .contains(ray.strip() + " " + (pixel.typical() + 1) + nearest);
        assertThat(typical).filteredOn(line -> line.matches("\\s+\\d: .*")).as("a line for each shadow ray").hasSize(5);
        assertThat(typical).filteredOn(line -> line.matches(".* · 0[.,]25 .*")).as("a line for each sample").hasSize(4);
        String all = String.join("\n", TreeText.lines(pixel, 0, Decoration.NONE, Words.in(language)));
        assertThat(all.split(Pattern.quote(shadows), -1)).hasSize(5);
        assertThat(all).doesNotContain(nearest);
    }

    private static int rays(List<TracedRay> rays) {
        return rays.stream().mapToInt(ray -> 1 + rays(ray.children())).sum();
    }
}
