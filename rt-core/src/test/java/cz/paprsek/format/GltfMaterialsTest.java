package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.model.Model;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.material.Share.ColorChannel;
import cz.paprsek.material.Share.Even;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.mesh.Triangles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A square with pictures on it, as glTF has them: what becomes of each number. */
class GltfMaterialsTest {
    /** Two by two points, 0xAARRGGBB, from the top left by rows. */
    private static final int[] POINTS = {0xFF_FF8000, 0x80_00FF40, 0x40_2040FF, 0x00_808080};

    /** Of the unit square in z = 0: places, and places in pictures with v going down. */
    private static byte[] bytes() {
        ByteBuffer bytes = ByteBuffer.allocate(92).order(ByteOrder.LITTLE_ENDIAN);
        for (float f : new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, /* u, v */ 0, 1, 1, 1, 1, 0, 0, 0}) {
            bytes.putFloat(f);
        }
        for (int i : new int[] {0, 1, 2, 0, 2, 3}) {
            bytes.putShort((short) i);
        }
        return bytes.array();
    }

    private static String data(byte[] bytes) {
        return "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(bytes);
    }

    private static byte[] png(int... points) {
        Image image = Image.ofTransparent(2, 2);
        for (int i = 0; i < 4; i++) {
            double cover = (points[i] >>> 24) / 255.0;
            image.set(i % 2, i / 2, cover * Rgb.linear(points[i] >> 16 & 255), cover * Rgb.linear(points[i] >> 8 & 255), cover * Rgb.linear(points[i] & 255), cover);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            ImageFiles.write(image, out, ImageFormat.PNG);
        } catch (IOException impossible) {
            throw new AssertionError(impossible);
        }
        return out.toByteArray();
    }

    private static String document(String image, String rest) {
        return ("{'asset':{'version':'2.0'},'buffers':[{'byteLength':92,'uri':'" + data(bytes()) + "'}],"
                + "'bufferViews':[{'buffer':0,'byteLength':48},{'buffer':0,'byteOffset':48,'byteLength':32},{'buffer':0,'byteOffset':80,'byteLength':12}],"
                + "'accessors':[{'bufferView':0,'componentType':5126,'count':4,'type':'VEC3'},{'bufferView':1,'componentType':5126,'count':4,'type':'VEC2'},"
                + "{'bufferView':2,'componentType':5123,'count':6,'type':'SCALAR'}],'images':[{" + image + "}],'textures':[{'source':0}],"
                + "'nodes':[{'mesh':0}],'meshes':[{'primitives':[{'attributes':{'POSITION':0,'TEXCOORD_0':1},'indices':2,'material':0}]}]," + rest + "}").replace('\'', '"');
    }

    private static Model model(String material, int... points) throws IOException {
        return Read.text(ForeignFormat.GLTF, document("'uri':'" + data(png(points)).replace("application/octet-stream", "image/png") + "'", "'materials':[{" + material + "}]"));
    }

    private static Material only(Model model) {
        return model.materials().values().iterator().next();
    }

    private static Material material(String material) throws IOException {
        return only(model(material, POINTS));
    }

    /** Points of a picture that was made, as 0xRRGGBB. */
    private static int[] points(Model model, Pattern pattern) throws IOException {
        Image image = ImageFiles.readStored(Objects.requireNonNull(model.pictures().get(((Pattern.Picture) pattern).file())), "x.png").image();
        int[] points = image.toArgb();
        for (int i = 0; i < points.length; i++) {
            points[i] &= 0xFFFFFF;
        }
        return points;
    }

    @Test
    void picturesAreTheSameInTextsBuffersAndFiles() throws IOException {
        byte[] png = png(POINTS);
        String color = "'materials':[{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}]";
        Model embedded = Read.text(ForeignFormat.GLTF, document("'uri':'" + data(png) + "'", color));
        assertThat(only(embedded).files()).containsExactly("x.gltf#0.png");
        assertThat(embedded.pictures().get("x.gltf#0.png")).isEqualTo(png);
        String buffered = document("'bufferView':3", color).replace("],\"accessors\"", ",{\"buffer\":1,\"byteLength\":" + png.length + "}],\"accessors\"")
                .replace("],\"bufferViews\"", ",{\"byteLength\":" + png.length + ",\"uri\":\"" + data(png) + "\"}],\"bufferViews\"");
        assertThat(Read.text(ForeignFormat.GLTF, buffered).pictures().get("x.gltf#0.png")).isEqualTo(png);
        Model beside = Read.bytes(ForeignFormat.GLTF, document("'uri':'a%20b.png'", color).getBytes(StandardCharsets.UTF_8), Map.of("a b.png", png));
        assertThat(only(beside).files()).containsExactly("a b.png");
        for (String elsewhere : List.of("../tex/a%20b.png", "C:\\\\tex\\\\a%20b.png")) {
            Model moved = Read.bytes(ForeignFormat.GLTF, document("'uri':'" + elsewhere + "'", color).getBytes(StandardCharsets.UTF_8), Map.of("a b.png", png));
            assertThat(only(moved).files()).containsExactly("a b.png");
        }
        assertThat(beside.pictures()).isEmpty();
    }

    @Test
    void aFactorTimesAPictureIsAPictureInLinearLight() throws IOException {
        Model model = model("'pbrMetallicRoughness':{'metallicFactor':0,'baseColorFactor':[0.5,0.25,1,1],'baseColorTexture':{'index':0}}", POINTS);
        int[] made = points(model, only(model).pattern());
        for (int i = 0; i < 3; i++) {
            int was = POINTS[i];
            assertThat(Rgb.linear(made[i] >> 16)).isCloseTo(0.5 * Rgb.linear(was >> 16 & 255), within(0.005));
            assertThat(Rgb.linear(made[i] >> 8 & 255)).isCloseTo(0.25 * Rgb.linear(was >> 8 & 255), within(0.005));
            assertThat(made[i] & 255).isEqualTo(was & 255);
        }
    }

    /** Green is the roughness, blue the metal. */
    @Test
    void metalAndRoughnessComeFromAPicture() throws IOException {
        String whole = "'pbrMetallicRoughness':{'metallicRoughnessTexture':{'index':0}}";
        Model metal = model(whole, 0xFF_0040FF, 0xFF_0080FF, 0xFF_FF10FF, 0xFF_0001FF);
        assertThat(only(metal)).satisfies(it -> {
            assertThat(it.fresnel()).isEqualTo(Fresnel.METAL);
            assertThat(it.reflection()).isEqualTo(1);
            assertThat(it.diffusion()).isZero();
            assertThat(it.shares().roughness()).isEqualTo(new ByPattern(ColorChannel.GREEN, Pattern.Picture.of("x.gltf#0.png")));
        });
        Material plastic = only(model(whole, 0xFF_004000, 0xFF_008000, 0xFF_FF1010, 0xFF_000100));
        assertThat(plastic.fresnel()).isEqualTo(Fresnel.TRUE);
        assertThat(plastic.diffusion()).isEqualTo(0.96);
        assertThat(plastic.refractiveIndex()).isEqualTo(1.5);
        Material matte = only(model(whole, 0xFF_00FF00, 0xFF_00A000, 0xFF_FFF010, 0xFF_00C000));
        assertThat(matte.reflection()).as("all of it is rougher than 0.6").isZero();
        assertThat(matte.diffusion()).isEqualTo(1);
    }

    @Test
    void factorsOfRoughnessMakeAPictureOfItsOwn() throws IOException {
        Model model = model("'pbrMetallicRoughness':{'roughnessFactor':0.5,'metallicRoughnessTexture':{'index':0}}", 0xFF_0040FF, 0xFF_0080FF, 0xFF_FF10FF, 0xFF_00FEFF);
        Pattern rough = ((ByPattern) only(model).shares().roughness()).pattern();
        assertThat(points(model, rough)).containsExactly(0x202020, 0x404040, 0x080808, 0x7F7F7F);
    }

    /** Rust on steel: what conducts mirrors, what does not scatters. */
    @Test
    void whatIsHalfMetalMirrorsAndScattersByItsShares() throws IOException {
        Model model = model("'pbrMetallicRoughness':{'metallicRoughnessTexture':{'index':0}}", 0xFF_0000FF, 0xFF_000000, 0xFF_000080, 0xFF_0000FF);
        Material rust = only(model);
        ByPattern diffusion = (ByPattern) rust.shares().diffusion();
        assertThat(List.of(diffusion.channel(), ((ByPattern) rust.shares().reflection()).channel())).containsExactly(ColorChannel.RED, ColorChannel.GREEN);
        assertThat(points(model, diffusion.pattern())).containsExactly(0x00FF00, 0xFF0000, 0x7F8000, 0x00FF00);
    }

    @Test
    void aNormalMapBendsAsMuchAsItsScaleSays() throws IOException {
        Material bumpy = material("'normalTexture':{'index':0,'scale':0.5}");
        assertThat(bumpy.relief()).isInstanceOfSatisfying(Material.NormalMap.class, map -> {
            assertThat(map.file()).isEqualTo("x.gltf#0.png");
            assertThat(map.strength()).isEqualTo(0.5);
        });
    }

    /** Opacities of 1, 128/255, 64/255 and 0. */
    @Test
    void opacityCutsOutOrMixes() throws IOException {
        String color = "'pbrMetallicRoughness':{'metallicFactor':0,'baseColorTexture':{'index':0}}";
        assertThat(material(color).shares().transparency()).as("opaque, whatever the picture says").isEqualTo(new Even());
        Model cut = model(color + ",'alphaMode':'MASK','alphaCutoff':0.4", POINTS);
        assertThat(points(cut, ((ByPattern) only(cut).shares().transparency()).pattern())).containsExactly(0xFF0000, 0xFF0000, 0x0000FF, 0x0000FF);
        Model mixed = model(color + ",'alphaMode':'BLEND'", POINTS);
        assertThat(points(mixed, ((ByPattern) only(mixed).shares().transparency()).pattern())).containsExactly(0xFF0000, 0x80007F, 0x4000BF, 0x0000FF);
        assertThat(only(mixed).thin()).as("what is behind is not bent").isTrue();
        Material even = material("'alphaMode':'BLEND','pbrMetallicRoughness':{'metallicFactor':0,'baseColorFactor':[1,1,1,0.25]}");
        assertThat(even.transparency()).isEqualTo(0.75);
        assertThat(even.diffusion()).isEqualTo(0.25);
    }

    @Test
    void transmissionMayDifferFromPointToPoint() throws IOException {
        Model model = model("'pbrMetallicRoughness':{'metallicFactor':0,'roughnessFactor':0},'extensions':{'KHR_materials_transmission':{'transmissionFactor':0.5,"
                + "'transmissionTexture':{'index':0}},'KHR_materials_volume':{'thicknessFactor':1}}", 0xFF_FF0000, 0xFF_000000, 0xFF_800000, 0xFF_FF00FF);
        assertThat(points(model, ((ByPattern) only(model).shares().transparency()).pattern())).as("96 of 100 parts that are not let through scatter")
                .containsExactly(0x7AFF80, 0xF5FF00, 0xB7FF40, 0x7AFF80);
        assertThat(only(model).thin()).isFalse();
    }

    /** As the extension's own formula has it: translation × rotation × scale. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0, 1, 1", "0.25, 0.5, 0, 2, 3", "0.1, 0.2, 0.5, 2, 0.5"})
    void texturesAreScaledTurnedAndMoved(double offsetU, double offsetV, double rotation, double scaleU, double scaleV) throws IOException {
        Triangles mesh = model("'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'extensions':{'KHR_texture_transform':{'offset':[" + offsetU + "," + offsetV + "],'rotation':"
                + rotation + ",'scale':[" + scaleU + "," + scaleV + "]}}}}", POINTS).triangles();
        for (int i = 0; i < 4; i++) {
            double u = mesh.x(i) * scaleU;
            double v = (1 - mesh.y(i)) * scaleV;
            assertThat((double) mesh.u(i)).isCloseTo(Math.cos(rotation) * u + Math.sin(rotation) * v + offsetU, within(1e-6));
            assertThat(1.0 - mesh.v(i)).isCloseTo(Math.cos(rotation) * v - Math.sin(rotation) * u + offsetV, within(1e-6));
        }
    }

    /** The colour's places are the vertices'; the other picture is laid so that each point of the square has the place in it that the extension says. */
    @Test
    void aPictureThatLiesOtherwiseThanTheColourIsLaidApart() throws IOException {
        Model model = model("'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'extensions':{'KHR_texture_transform':{'offset':[0.25,0.5],'scale':[2,4]}}}},"
                + "'normalTexture':{'index':0,'extensions':{'KHR_texture_transform':{'offset':[0.5,0.125],'scale':[3,5]}}}", POINTS);
        Pattern.Lay lay = ((Material.NormalMap) only(model).relief()).lay();
        for (int i = 0; i < 4; i++) {
            double u = (model.triangles().u(i) - lay.position().x()) / lay.scale().x();
            double v = (model.triangles().v(i) - lay.position().y()) / lay.scale().y();
            assertThat(u).isCloseTo(0.5 + 3 * model.triangles().x(i), within(1e-6));
            assertThat(1 - v).isCloseTo(0.125 + 5 * (1 - model.triangles().y(i)), within(1e-6));
        }
        assertThat(model("'pbrMetallicRoughness':{'baseColorTexture':{'index':0}},'normalTexture':{'index':0,'texCoord':1}", POINTS).notes())
                .containsExactly("textures[0]: a picture lies as that of the colour does, though it is to be turned against it or to take another set of places");
    }

    @Test
    void lightOfItsOwnIsTheMeanOfAPictureTimesItsStrength() throws IOException {
        Material plain = material("'emissiveFactor':[1,0.5,0],'extensions':{'KHR_materials_emissive_strength':{'emissiveStrength':7}}");
        assertThat(plain.emissionStrength()).isEqualTo(7);
        assertThat(plain.emission().linearGreen()).isCloseTo(0.5, within(1e-9));
        Model half = model("'emissiveFactor':[1,1,0],'emissiveTexture':{'index':0}", 0xFF_FF0000, 0xFF_FF0000, 0xFF_000000, 0xFF_000000);
        assertThat(only(half).emission().linearRed()).isCloseTo(0.5, within(1e-6));
        assertThat(only(half).emission().linearGreen()).isZero();
        assertThat(half.notes()).containsExactly("materials[0]: emissiveTexture is read as its mean");
    }

    @Test
    void unlitSurfacesShineAsTheyAre() throws IOException {
        Material unlit = material("'pbrMetallicRoughness':{'baseColorFactor':[0.5,0.25,0,1]},'extensions':{'KHR_materials_unlit':{}}");
        assertThat(unlit.emission().linearRed()).isCloseTo(0.5, within(1e-9));
        assertThat(unlit.diffusion() + unlit.reflection() + unlit.transparency()).isZero();
    }

    /** A place at (1, 2, 3), seen along −z turned by 90° about y: along −x. */
    @Test
    void lightsShineAndCamerasLookAlongTheirNodes() throws IOException {
        String node = "'translation':[1,2,3],'rotation':[0,0.7071067811865476,0,0.7071067811865476]";
        Model model = Read.text(ForeignFormat.GLTF, document("'uri':'x.png'", "'cameras':[{'type':'orthographic','orthographic':{'xmag':4,'ymag':3,'znear':0,'zfar':9}}],"
                + "'extensions':{'KHR_lights_punctual':{'lights':[{'type':'directional','intensity':6.283185307179586},"
                + "{'type':'spot','intensity':6.283185307179586,'spot':{'innerConeAngle':0.5235987755982988,'outerConeAngle':0.7853981633974483}}]}}")
                .replace("\"nodes\":[", ("'nodes':[{" + node + ",'camera':0},{" + node + ",'extensions':{'KHR_lights_punctual':{'light':0}}},{" + node
                        + ",'extensions':{'KHR_lights_punctual':{'light':1}}},").replace('\'', '"')).replace(",\"material\":0", ""));
        assertThat(model.cameras()).singleElement().satisfies(camera -> {
            assertThat(camera.position()).isEqualTo(new Vec3(1, 2, 3));
            assertThat(camera.lens()).isEqualTo(new Lens.Orthographic(6));
            assertThat(camera.forward().minus(new Vec3(-1, 0, 0)).length()).isLessThan(1e-12);
        });
        Light sun = model.lights().get(0);
        assertThat(sun).isInstanceOfSatisfying(SunLight.class, it -> {
            assertThat(it.intensity()).as("lux are π of ours").isCloseTo(2, within(1e-12));
            assertThat(it.direction().minus(new Vec3(-1, 0, 0)).length()).isLessThan(1e-12);
        });
        assertThat(model.lights().get(1)).isInstanceOfSatisfying(SpotLight.class, it -> {
            assertThat(it.innerAngle()).isCloseTo(30, within(1e-9));
            assertThat(it.outerAngle()).isCloseTo(45, within(1e-9));
            assertThat(it.referenceDistance()).isEqualTo(1);
        });
    }

    @Test
    void picturesOfModelsInFoldersAreFoundFromTheScene() throws IOException {
        byte[] png = png(POINTS);
        String json = document("'uri':'deep/a.png'", "'materials':[{'pbrMetallicRoughness':{'baseColorTexture':{'index':0},'metallicRoughnessTexture':{'index':0}},'normalTexture':{'index':0}}]");
        Assets assets = Assets.of(Map.of("models/x.gltf", json.getBytes(StandardCharsets.UTF_8), "models/deep/a.png", png));
        assertThat(MeshFiles.whole("models/x.gltf", assets)).isNotNull();
        Material found = Mesh.of("models/x.gltf").read(MeshFiles.whole("models/x.gltf", assets)).materials().iterator().next();
        assertThat(found.files()).contains("models/deep/a.png").allMatch(name -> name.startsWith("models/"));
    }
}
