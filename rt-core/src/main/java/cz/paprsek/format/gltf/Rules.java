package cz.paprsek.format.gltf;

import cz.paprsek.format.model.FormatFault;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What the format demands of the objects of a document, whether they are shown or not: what they must have, of which kind it is, within which limits, and that what it names is there.
 *
 * @source Khronos Group, glTF 2.0 Specification, 2021, appendix A
 */
final class Rules {
    /**
     * By line a kind of objects, and what they may have; with a ! what they must have. Then what it is: {@code text}, {@code flag}, {@code number} or {@code whole} and their
     * limits, {@code numbers} and how many (0 for any), {@code code} or {@code word} and those there are, {@code object} or {@code objects} of a kind, {@code in} or {@code all},
     * the number of something in a list of the document, or several of them, {@code each} an object of such numbers, and {@code eaches} several of these. After {@code with}
     * follows what it makes no sense without.
     */
    private static final String TABLE = """
            document: asset! object asset; extensionsUsed texts; extensionsRequired texts with extensionsUsed; accessors objects accessor; animations objects animation; buffers objects buffer; \
            bufferViews objects view; cameras objects camera; images objects image; materials objects material; meshes objects mesh; nodes objects node; samplers objects sampler; scene in scenes; \
            scenes objects scene; skins objects skin; textures objects texture
            asset: version! text; minVersion text; generator text; copyright text
            accessor: bufferView in bufferViews; byteOffset whole 0 with bufferView; componentType! code 5120 5121 5122 5123 5125 5126; count! whole 1; \
            type! word SCALAR VEC2 VEC3 VEC4 MAT2 MAT3 MAT4; normalized flag; max numbers 0; min numbers 0; sparse object sparse
            sparse: count! whole 1; indices! object where; values! object what
            where: bufferView! in bufferViews; byteOffset whole 0; componentType! code 5121 5123 5125
            what: bufferView! in bufferViews; byteOffset whole 0
            animation: channels! objects channel; samplers! objects course
            channel: sampler! whole 0; target! object target
            target: node in nodes; path! text
            course: input! in accessors; output! in accessors; interpolation word LINEAR STEP CUBICSPLINE
            buffer: byteLength! whole 1; uri text
            view: buffer! in buffers; byteLength! whole 1; byteOffset whole 0; byteStride whole 4 252; target code 34962 34963
            camera: type! text; perspective object perspective; orthographic object orthographic
            perspective: yfov! number 0; znear! number 0; zfar number 0; aspectRatio number 0
            orthographic: xmag! number; ymag! number; zfar! number 0; znear! number 0
            image: uri text; mimeType text; bufferView in bufferViews with mimeType
            material: pbrMetallicRoughness object plain; normalTexture object texel; occlusionTexture object texel; emissiveTexture object texel; emissiveFactor numbers 3; \
            alphaMode word OPAQUE MASK BLEND; alphaCutoff number 0; doubleSided flag
            plain: baseColorFactor numbers 4; baseColorTexture object texel; metallicFactor number 0 1; roughnessFactor number 0 1; metallicRoughnessTexture object texel
            texel: index! in textures; texCoord whole 0; scale number; strength number 0 1
            mesh: primitives! objects primitive; weights numbers 0
            primitive: attributes! each accessors; indices in accessors; material in materials; mode whole 0 6; targets eaches accessors
            node: camera in cameras; children all nodes; skin in skins with mesh; mesh in meshes; matrix numbers 16; rotation numbers 4; scale numbers 3; translation numbers 3; \
            weights numbers 0 with mesh
            sampler: magFilter code 9728 9729; minFilter code 9728 9729 9984 9985 9986 9987; wrapS code 33071 33648 10497; wrapT code 33071 33648 10497
            scene: nodes all nodes
            skin: inverseBindMatrices in accessors; skeleton in nodes; joints! all nodes
            texture: sampler in samplers; source in images
            light: color numbers 3; intensity number 0; range number 0; type! word directional point spot; spot object spot
            spot: innerConeAngle number 0 1.5707964; outerConeAngle number 0 1.5707964
            KHR_lights_punctual of document: lights! objects light
            KHR_lights_punctual of node: light! whole 0
            KHR_materials_anisotropy of material: anisotropyStrength number 0 1; anisotropyRotation number; anisotropyTexture object texel
            KHR_materials_clearcoat of material: clearcoatFactor number 0 1; clearcoatRoughnessFactor number 0 1; clearcoatTexture object texel
            KHR_materials_dispersion of material: dispersion number 0
            KHR_materials_emissive_strength of material: emissiveStrength number 0
            KHR_materials_ior of material: ior number 0
            KHR_materials_iridescence of material: iridescenceFactor number 0 1; iridescenceIor number 1
            KHR_materials_sheen of material: sheenColorFactor numbers 3; sheenRoughnessFactor number 0 1
            KHR_materials_specular of material: specularFactor number 0 1; specularColorFactor numbers 3
            KHR_materials_transmission of material: transmissionFactor number 0 1; transmissionTexture object texel
            KHR_materials_unlit of material:
            KHR_materials_volume of material: thicknessFactor number 0; attenuationDistance number 0; attenuationColor numbers 3
            KHR_materials_pbrSpecularGlossiness of material: glossinessFactor number 0 1
            KHR_texture_transform of texel: offset numbers 2; scale numbers 2; rotation number; texCoord whole 0
            KHR_node_visibility of node: visible flag
            KHR_animation_pointer of target: pointer! text
            EXT_texture_webp of texture: source in images
            KHR_materials_variants of document: variants! objects variant
            KHR_materials_variants of primitive: mappings! objects variants
            variant: name! text
            variants: material! in materials; variants! numbers 0
            KHR_mesh_quantization of nothing:
            """;

    private final Tree document;
    private final Map<String, List<Rule>> kinds = new HashMap<>();
    private final Set<String> extensions = new HashSet<>();
    /** Those that the document says it uses. */
    private final Set<Object> used;

    /** @param more of what it is, such as limits */
    private record Rule(String name, boolean isNeeded, String what, List<String> more, String with) {
        static Rule of(String text) {
            List<String> words = new ArrayList<>(List.of(text.strip().split(" ", -1)));
            int with = words.indexOf("with");
            String other = with < 0 ? "" : words.get(with + 1);
            String name = words.get(0);
            boolean isNeeded = name.endsWith("!");
            return new Rule(isNeeded ? name.substring(0, name.length() - 1) : name, isNeeded, words.get(1), words.subList(2, with < 0 ? words.size() : with), other);
        }

        double limit(int index, double otherwise) {
            return index < more.size() ? Double.parseDouble(more.get(index)) : otherwise;
        }
    }

    private Rules(Tree document) throws FormatFault {
        this.document = document;
        used = new HashSet<>(document.list("extensionsUsed"));
        for (String line : TABLE.lines().toList()) {
            String kind = line.substring(0, line.indexOf(':'));
            List<Rule> rules = new ArrayList<>();
            for (String text : line.substring(line.indexOf(':') + 1).split(";", -1)) {
                if (!text.isBlank()) {
                    rules.add(Rule.of(text));
                }
            }
            kinds.put(kind, rules);
            if (kind.contains(" of ")) {
                extensions.add(kind.substring(0, kind.indexOf(' ')));
            }
        }
    }

    /** @throws FormatFault the first thing that a document has against these rules */
    static void check(Tree document) throws FormatFault {
        new Rules(document).object(document, "document");
    }

    private void object(Tree object, String kind) throws FormatFault {
        object.text("name", "");
        for (Rule rule : kinds.getOrDefault(kind, List.of())) {
            if (object.has(rule.name)) {
                if (!rule.with.isEmpty() && !object.has(rule.with)) {
                    throw object.fault(rule.name, "this needs " + FormatFault.quoted(rule.with) + " beside it");
                }
                member(object, rule);
            } else if (rule.isNeeded) {
                throw object.fault("here must be " + FormatFault.quoted(rule.name));
            }
        }
        extensions(object, kind);
    }

    private void extensions(Tree object, String kind) throws FormatFault {
        Tree all = object.childOrNothing("extensions");
        for (String name : all.names()) {
            Tree extension = all.child(name).orElse(Tree.NOTHING);
            if (!used.contains(name)) {
                throw all.fault(name, "an extension must be in the list \"extensionsUsed\"");
            }
            if (extensions.contains(name) && !kinds.containsKey(name + " of " + kind)) {
                throw all.fault(name, "this extension has no place here");
            }
            object(extension, name + " of " + kind);
        }
    }

    private void member(Tree object, Rule rule) throws FormatFault {
        String name = rule.name;
        switch (rule.what) {
            case "text" -> object.text(name, "");
            case "flag" -> object.flag(name);
            case "number" -> within(object, rule, object.number(name, 0));
            case "whole" -> within(object, rule, object.whole(name, 0));
            case "code" -> among(object, rule, Integer.toString(object.whole(name, 0)));
            case "word" -> among(object, rule, object.text(name, ""));
            case "numbers" -> {
                filled(object, name);
                object.numbers(name, new double[rule.limit(0, 0) > 0 ? (int) rule.limit(0, 0) : object.count(name)]);
            }
            case "texts" -> texts(object, name);
            case "in" -> named(object, name, rule.more.get(0));
            case "all" -> all(object, name, rule.more.get(0));
            case "each" -> each(object.child(name).orElse(Tree.NOTHING), rule.more.get(0));
            case "eaches" -> {
                filled(object, name);
                for (int i = 0; i < object.count(name); i++) {
                    each(object.item(name, i), rule.more.get(0));
                }
            }
            case "object" -> object(object.child(name).orElse(Tree.NOTHING), rule.more.get(0));
            case "objects" -> {
                filled(object, name);
                for (int i = 0; i < object.count(name); i++) {
                    object(object.item(name, i), rule.more.get(0));
                }
            }
            default -> throw new AssertionError(rule.what);
        }
    }

    private static void within(Tree object, Rule rule, double value) throws FormatFault {
        double low = rule.limit(0, Double.NEGATIVE_INFINITY);
        double high = rule.limit(1, Double.POSITIVE_INFINITY);
        if (!(value >= low && value <= high) || Double.isInfinite(value)) {
            String limits = rule.more.isEmpty() ? "finite" : rule.more.size() == 1 ? rule.more.get(0) + " or more" : "from " + rule.more.get(0) + " to " + rule.more.get(1);
            throw object.fault(rule.name, "this must be " + limits + ", but is " + (value == Math.rint(value) && Math.abs(value) < 1e15 ? Long.toString((long) value) : Double.toString(value)));
        }
    }

    private static void among(Tree object, Rule rule, String value) throws FormatFault {
        if (!rule.more.contains(value)) {
            throw object.fault(rule.name, "this must be one of " + String.join(", ", rule.more) + ", but is " + FormatFault.quoted(value));
        }
    }

    private static void filled(Tree object, String name) throws FormatFault {
        if (object.list(name).isEmpty()) {
            throw object.fault(name, "this list must not be empty");
        }
    }

    private static void texts(Tree object, String name) throws FormatFault {
        filled(object, name);
        Set<Object> seen = new HashSet<>();
        for (Object text : object.list(name)) {
            if (!(text instanceof String)) {
                throw object.fault(name, "these must be texts in quotes");
            }
            if (!seen.add(text)) {
                throw object.fault(name, FormatFault.quoted(text.toString()) + " stands here twice");
            }
        }
    }

    private void named(Tree object, String name, String list) throws FormatFault {
        int index = object.whole(name, 0);
        if (index >= document.count(list)) {
            throw object.fault(name, "there is no " + list + "[" + index + "], but " + document.count(list) + " of them");
        }
    }

    private void all(Tree object, String name, String list) throws FormatFault {
        filled(object, name);
        Set<Integer> seen = new HashSet<>();
        for (int index : object.indexes(name, Integer.MAX_VALUE)) {
            if (index >= document.count(list)) {
                throw object.fault(name, "there is no " + list + "[" + index + "], but " + document.count(list) + " of them");
            }
            if (!seen.add(index)) {
                throw object.fault(name, "number " + index + " stands here twice");
            }
        }
    }

    private void each(Tree object, String list) throws FormatFault {
        if (object.names().isEmpty()) {
            throw object.fault("this must not be empty");
        }
        for (String name : object.names()) {
            named(object, name, list);
        }
    }
}
