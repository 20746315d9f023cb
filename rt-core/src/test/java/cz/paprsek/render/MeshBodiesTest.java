package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import cz.paprsek.shape.mesh.Meshes;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.xml.SceneFiles;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Ball, ring and block of triangles, alone and as operands, beside the same bodies in closed form. */
class MeshBodiesTest {
    private static final Mesh BALL = Mesh.of(Meshes.ball(0.8, 160).smoothed(30));
    private static final Mesh RING = Mesh.of(Meshes.torus(0.7, 0.3, 300, 150).smoothed(30));
    private static final Mesh CUBE = Mesh.of(Meshes.cube(0.6));

    static Stream<Arguments> bodies() {
        UnaryOperator<Solid> alone = solid -> solid;
        UnaryOperator<Solid> minus = solid -> Csg.difference(Operand.of(solid), Operand.of(new Block(new Vec3(-2, -2, 0.1), new Vec3(0.2, 2, 2))),
                Operand.of(new Cylinder(0.25, 4)).at(0.5, -2, 0.2));
        UnaryOperator<Solid> from = solid -> Csg.difference(Operand.of(new Block(new Vec3(-1, -0.2, -1), new Vec3(1, 0.5, 1))), Operand.of(solid).at(0.1, 0.2, 0.5));
        UnaryOperator<Solid> plus = solid -> Csg.union(Operand.of(solid), Operand.of(new Sphere(0.5)).at(0.6, 0.3, 0.2));
        UnaryOperator<Solid> common = solid -> Csg.intersection(Operand.of(Csg.union(Operand.of(solid), Operand.of(new Sphere(0.3)).at(0, 0.9, 0))),
                Operand.of(new Sphere(0.85)).at(0.1, 0.1, 0.1));
        return Stream.of(Map.entry("alone", alone), Map.entry("minus", minus), Map.entry("from", from), Map.entry("plus", plus), Map.entry("common", common))
                .flatMap(how -> Stream.of(Arguments.of("ball " + how.getKey(), how.getValue().apply(BALL), how.getValue().apply(new Sphere(0.8))),
                        Arguments.of("ring " + how.getKey(), how.getValue().apply(RING), how.getValue().apply(new Torus(0.7, 0.3))),
                        Arguments.of("block " + how.getKey(), how.getValue().apply(CUBE), how.getValue().apply(new Block(new Vec3(-0.6, -0.6, -0.6), new Vec3(0.6, 0.6, 0.6))))));
    }

    /** The fields of the meshes are 1° and less; so much may normals be off, and a pixel of a silhouette here and there. */
    @ParameterizedTest
    @MethodSource("bodies")
    void silhouettesAndNormalsAreThoseOfTheClosedForm(String name, Solid mesh, Solid exact) {
        int[] ours = picture(mesh, Material.color(200, 200, 200), RenderMode.NORMALS);
        int[] theirs = picture(exact, Material.color(200, 200, 200), RenderMode.NORMALS);
        int apart = 0;
        for (int i = 0; i < ours.length; i++) {
            int most = 0;
            for (int shift = 0; shift <= 16; shift += 8) {
                most = Math.max(most, Math.abs((ours[i] >> shift & 255) - (theirs[i] >> shift & 255)));
            }
            apart += most > 3 ? 1 : 0;
        }
        assertThat(apart).as(name).isLessThanOrEqualTo(ours.length / 500);
        assertThat(Arrays.stream(ours).distinct().count()).as("something is seen").isGreaterThan(2);
    }

    private static int[] picture(Solid solid, Material material, RenderMode mode) {
        Scene scene = scene(solid, material);
        return Renderer.render(RenderScene.of(scene), RenderOptions.of(scene).withMode(mode), RenderMonitor.NONE).image().toArgb();
    }

    private static Scene scene(Solid solid, Material material) {
        return Scene.EMPTY.withSettings(new RenderSettings(160, 120, 8, 1)).withCamera(Camera.lookingAt(new Vec3(1.3, 2.1, 3.4), Vec3.ZERO).withFovy(38))
                .withLights(List.of(Light.at(4, 6, 5))).withObjects(List.of(SceneObject.of(solid).rotated(10, 20, 5).madeOf(material)));
    }

    /** The border of light and shadow runs as on a round ball, not along the sides of the fields, which are 9° here. */
    @Test
    void lightFadesOnACoarseBallAsOnARoundOne() {
        Image coarse = lit(Mesh.of(Meshes.ball(0.8, 20).smoothed(40)));
        Image round = lit(new Sphere(0.8));
        int apart = 0;
        int seen = 0;
        for (int y = 0; y < 120; y++) {
            for (int x = 0; x < 160; x++) {
                boolean isInside = Math.hypot(x - 79.5, y - 59.5) < 30;
                seen += isInside && round.red(x, y) > 0 ? 1 : 0;
                apart += isInside && Math.abs(coarse.red(x, y) - round.red(x, y)) > 0.02 ? 1 : 0;
            }
        }
        assertThat(seen).isGreaterThan(1000);
        assertThat(apart).isLessThanOrEqualTo(10);
    }

    private static Image lit(Solid solid) {
        Scene scene = scene(solid, Material.color(255, 255, 255).withDiffusion(1)).withLights(List.of(SunLight.along(-1, -0.2, 0.1)));
        return Renderer.render(scene);
    }

    /** A cube has no tessellation to forgive: light goes through one of triangles as through a block. */
    @Test
    void aCubeOfGlassIsABlockOfGlass() {
        Material glass = Material.color(240, 255, 240).withDiffusion(0).withReflection(1).withTransparency(1, 1.5).withFresnel(Material.Fresnel.TRUE);
        int[] ours = picture(CUBE, glass, RenderMode.SHADED);
        int[] theirs = picture(new Block(new Vec3(-0.6, -0.6, -0.6), new Vec3(0.6, 0.6, 0.6)), glass, RenderMode.SHADED);
        int different = 0;
        for (int i = 0; i < ours.length; i++) {
            different += ours[i] == theirs[i] ? 0 : 1;
        }
        assertThat(different).isLessThanOrEqualTo(20);
    }

    /** Halves that reach into each other are one body: without walls inside, on which glass would show. */
    @Test
    void twoCubesThatOverlapAreOneBodyOfGlass() {
        Material glass = Material.color(240, 255, 240).withDiffusion(0).withReflection(0.1).withTransparency(0.9, 1.5);
        int[] two = picture(Mesh.of(Meshes.both(Meshes.cube(0.4), Meshes.cube(0.4), 0.5, false)), glass, RenderMode.SHADED);
        int[] union = picture(Csg.union(Operand.of(new Block(new Vec3(-0.4, -0.4, -0.4), new Vec3(0.4, 0.4, 0.4))),
                Operand.of(new Block(new Vec3(-0.4, -0.4, -0.4), new Vec3(0.4, 0.4, 0.4))).at(0.5, 0, 0)), glass, RenderMode.SHADED);
        int different = 0;
        for (int i = 0; i < two.length; i++) {
            different += two[i] == union[i] ? 0 : 1;
        }
        assertThat(different).isLessThanOrEqualTo(40);
    }

    @Test
    void anOpenMeshIsSeenButNoOperand() {
        Triangles cube = Meshes.cube(0.5);
        Mesh open = Mesh.of(Meshes.without(cube, 3));
        assertThat(open.hasInside()).isFalse();
        assertThat(Arrays.stream(picture(open, Material.color(200, 200, 200), RenderMode.SHADED)).distinct().count()).isGreaterThan(2);
        assertThatThrownBy(() -> RenderScene.of(scene(Csg.difference(new Sphere(1), open), Material.DEFAULT)))
                .hasMessage("the mesh made in code has no inside, so <difference> cannot use it: 3 of its edges are open");
    }

    @Test
    void filesAreReadFromTheScenesAssetsAndOpenOnesRefusedThere() throws Exception {
        StringBuilder obj = new StringBuilder("o top\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
        Assets assets = Assets.of(Map.of("a.obj", obj.toString().getBytes(StandardCharsets.UTF_8),
                "b.obj", obj.substring(0, obj.length() - 8).getBytes(StandardCharsets.UTF_8)));
        String xml = """
                <scene xmlns="urn:paprsek:scene:1"><camera position="0 0 5" target="0 0 0"/>
                  <union><sphere radius="1"/><mesh file="%s"/></union></scene>""";
        assertThat(scene(xml, "a.obj", assets).scene().objects()).hasSize(1);
        assertThatThrownBy(() -> scene(xml, "b.obj", assets)).hasMessage("the mesh \"b.obj\" has no inside, so <union> cannot use it: 3 of its edges are open");
        assertThatThrownBy(() -> scene(xml, "c.obj", assets)).hasMessage("\"c.obj\": there is no file of this name");
        assertThatThrownBy(() -> scene(xml, "a.obj\" part=\"lid", assets)).hasMessageContaining("there is no part \"lid\" in \"a.obj\"");
    }

    private static RenderScene scene(String xml, String file, Assets assets) throws Exception {
        return RenderScene.of(SceneFiles.parse(xml.formatted(file)), assets, RenderMonitor.NONE);
    }

    @Test
    void explainingTellsTheTriangleAndWhereInIt() {
        Scene scene = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 0, 5), Vec3.ZERO)).withSettings(new RenderSettings(3, 3, 2, 1))
                .plus(SceneObject.of(Mesh.of(Meshes.cube(1))));
        Encounter met = RenderScene.of(scene).explain(1, 1).rays().get(0).encounter().orElseThrow();
        Encounter.Triangle triangle = met.place().triangle().orElseThrow();
        assertThat(triangle.shares().x() + triangle.shares().y() + triangle.shares().z()).isEqualTo(1);
        assertThat(met.place().normal()).isEqualTo(Vec3.Z);
    }

    @Test
    void everyThreadCountGivesTheSameBytes() {
        Scene scene = scene(Csg.difference(RING, new Sphere(0.75)), Material.color(200, 120, 90).withReflection(0.3));
        int[] one = Renderer.render(RenderScene.of(scene), RenderOptions.of(scene).withThreads(1), RenderMonitor.NONE).image().toArgb();
        int[] three = Renderer.render(RenderScene.of(scene), RenderOptions.of(scene).withThreads(3), RenderMonitor.NONE).image().toArgb();
        assertThat(three).isEqualTo(one);
    }
}
