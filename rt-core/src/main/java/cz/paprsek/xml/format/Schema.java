package cz.paprsek.xml.format;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * Writes the schema from what stands at the records: which elements there are, in which others, and with which attributes. A kind of light, shape
 * or pattern is in it by being permitted where it belongs.
 */
final class Schema {
    private static final String OPERATION = "Csg";

    private final SchemaText text = new SchemaText();
    private final boolean hasFormulas;

    private Schema(boolean hasFormulas) {
        this.hasFormulas = hasFormulas;
    }

    static String text(boolean hasFormulas) {
        return new Schema(hasFormulas).write();
    }

    /** What is an element, but no record. */
    @Element("A colour of light.")
    private record Colored(@Attribute(value = Kind.COLOR, means = "sRGB, 0-255") Rgb color) {}

    @Element("A material that objects refer to by name.")
    private record NamedMaterial(@Attribute(value = Kind.NAME, means = "Unique among the materials") String name) {}

    @Element("What all objects and operands have in common.")
    private record Common(
            @Attribute(value = Kind.NAME, means = "Unique among its siblings", otherwise = Attribute.NOTHING) String name,
            Placement placement,
            Placement.Pivot pivot,
            @Attribute(value = Kind.FLAG, means = "Whether it is left out of pictures, as if it were not there", otherwise = "false") boolean hidden,
            @Attribute(value = Kind.NAME, means = "The name of a material. Without one, an operand takes that of its operation", otherwise = Attribute.NOTHING)
            MaterialSource material) {}

    private String write() {
        text.open("schema", "xmlns:xs", "http://www.w3.org/2001/XMLSchema", "xmlns:s", SceneFormat.NAMESPACE,
                "targetNamespace", SceneFormat.NAMESPACE, "elementFormDefault", "qualified", "blockDefault", "#all");
        text.documentation("The scene file of Paprsek, a ray tracer. Right-handed world, y up, lengths in scene units, angles in degrees. "
                + "Each documentation of a simple type completes the sentence \"must be ...\".");
        new SimpleTypes(text, enumerations()).write();
        if (hasFormulas) {
            MadeTypes.simple(text);
        }
        solids();
        roots();
        scene();
        Stream.of(RenderSettings.class, Camera.class).forEach(this::leaf);
        ElementTable.of(Light.class).forEach(this::leaf);
        leaf("Colored", Colored.class);
        text.open("complexType", "name", "Sky").documentation(ElementTable.means(Sky.class));
        Stream.of(Sky.Gradient.class, Sky.Picture.class).flatMap(kind -> Described.of(kind).stream()).forEach(one -> attribute(one, false));
        text.close("complexType");
        materials();
        bodies();
        animations();
        if (hasFormulas) {
            MadeTypes.elements(text, shapes(Shape.class).filter(shape -> !Solid.class.isAssignableFrom(shape)).map(shape -> new String[] {ElementTable.name(shape), type(shape)}).toList());
        }
        return text.close("schema").toString();
    }

    /** All enumerations of words that attributes have. */
    private static Stream<Class<?>> enumerations() {
        Stream<Class<?>> records = Stream.of(Stream.of(RenderSettings.class, Camera.class, Animation.class, Animation.Key.class, Material.class, Share.ByPattern.class), ElementTable.of(Light.class), ElementTable.of(Pattern.class),
                ElementTable.of(Shape.class)).flatMap(some -> some);
        return records.flatMap(record -> Described.of(record).stream()).filter(one -> one.says().value() == Kind.WORD).<Class<?>>map(Described::type).distinct();
    }

    private void solids() {
        text.open("group", "name", "solid").open("choice");
        shapes(Solid.class).forEach(this::element);
        for (Csg.Operation operation : Csg.Operation.values()) {
            text.leaf("element", "name", operation.name().toLowerCase(Locale.ROOT), "type", "s:" + OPERATION);
        }
        if (hasFormulas) {
            MadeTypes.BODIES.forEach((name, type) -> text.leaf("element", "name", name, "type", "s:" + type));
        }
        text.close("choice").close("group");
    }

    /** All kinds of shape but operations. */
    private static Stream<Class<? extends Record>> shapes(Class<?> type) {
        return ElementTable.of(type).filter(shape -> shape != Csg.class);
    }

    private void roots() {
        text.leaf("element", "name", "scene", "type", "s:Scene");
        text.open("element", "name", "database").documentation("Any number of scenes in one file.");
        text.open("complexType").open("sequence").leaf("element", "ref", "s:scene", "minOccurs", "0", "maxOccurs", "unbounded");
        text.close("sequence").close("complexType").close("element");
    }

    private void scene() {
        text.open("complexType", "name", "Scene").documentation(ElementTable.means(Scene.class));
        text.open("choice", "minOccurs", "0", "maxOccurs", "unbounded");
        for (Described one : Described.elements(Scene.class)) {
            text.open("element", "name", one.name(), "type", "s:" + (one.says().value() == Kind.COLOR ? "Colored" : SimpleTypes.name(one)));
            text.documentation(one.says().means() + (one.isOptional() ? "." : "; " + standard(one) + " if not given.")).close("element");
        }
        if (hasFormulas) {
            MadeTypes.OF_SCENE.forEach((name, type) -> text.leaf("element", "name", name, "type", "s:" + type));
        }
        element(RenderSettings.class);
        text.leaf("element", "name", "sky", "type", "s:Sky");
        element(Camera.class);
        ElementTable.of(Light.class).forEach(this::element);
        text.leaf("element", "name", "material", "type", "s:NamedMaterial");
        shapes(Shape.class).filter(shape -> !Solid.class.isAssignableFrom(shape)).forEach(this::element);
        element(Animation.class);
        text.leaf("group", "ref", "s:solid").close("choice");
        attributes(Scene.class);
        text.close("complexType");
    }

    private void materials() {
        text.open("group", "name", "pattern").open("choice");
        ElementTable.of(Pattern.class).forEach(this::element);
        text.close("choice").close("group");
        text.open("complexType", "name", "Material").documentation(ElementTable.means(Material.class)).open("choice", "minOccurs", "0", "maxOccurs", "unbounded");
        text.leaf("group", "ref", "s:pattern");
        Stream.of(Material.Shares.class.getRecordComponents()).forEach(share -> text.leaf("element", "name", Described.name(share), "type", "s:Share"));
        ElementTable.of(Material.Relief.class).forEach(this::element);
        text.close("choice");
        attributes(Material.class);
        text.close("complexType");
        extension("NamedMaterial", NamedMaterial.class, "Material", () -> {});
        around("Share", "A share of light, or the roughness, by a pattern: what that has at each point, in place of the attribute of the same name.", Share.ByPattern.class);
        around(type(Material.Bump.class), ElementTable.means(Material.Bump.class), Material.Bump.class);
        leaf(Material.NormalMap.class);
        ElementTable.of(Pattern.class).forEach(this::pattern);
        leaf(Pattern.Stop.class);
    }

    /** The type of an element with one pattern inside. */
    private void around(String type, String means, Class<? extends Record> record) {
        text.open("complexType", "name", type).documentation(means).open("sequence").leaf("group", "ref", "s:pattern").close("sequence");
        Described.of(record).forEach(one -> attribute(one, one.isRequired()));
        text.close("complexType");
    }

    private void pattern(Class<? extends Record> record) {
        text.open("complexType", "name", type(record)).documentation(ElementTable.means(record));
        if (Arrays.stream(record.getRecordComponents()).anyMatch(component -> component.getType() == Pattern.Colors.class)) {
            text.open("sequence").leaf("element", "name", ElementTable.name(Pattern.Stop.class), "type", "s:" + type(Pattern.Stop.class),
                    "minOccurs", "0", "maxOccurs", "unbounded").close("sequence");
        }
        attributes(record);
        text.close("complexType");
    }

    private void bodies() {
        leaf("Object", Common.class);
        shapes(Shape.class).forEach(shape -> extension(type(shape), shape, "Object", () -> inside(() -> {})));
        extension(OPERATION, Csg.class, "Object", () -> inside(() -> text.leaf("group", "ref", "s:solid", "maxOccurs", "unbounded")));
    }

    private void animations() {
        text.open("complexType", "name", type(Animation.class)).documentation(ElementTable.means(Animation.class));
        text.open("sequence").leaf("element", "name", ElementTable.name(Animation.Key.class), "type", "s:" + type(Animation.Key.class), "maxOccurs", "unbounded").close("sequence");
        attributes(Animation.class);
        text.close("complexType");
        leaf(Animation.Key.class);
    }

    private void inside(Runnable more) {
        text.open("sequence").leaf("element", "name", "material", "type", "s:Material", "minOccurs", "0");
        more.run();
        text.close("sequence");
    }

    private void element(Class<? extends Record> record) {
        text.leaf("element", "name", ElementTable.name(record), "type", "s:" + type(record));
    }

    /** {@code PointLight} for {@code point-light}. */
    private static String type(Class<?> record) {
        StringBuilder type = new StringBuilder();
        Arrays.stream(ElementTable.name(record).split("-")).forEach(word -> type.append(word.substring(0, 1).toUpperCase(Locale.ROOT)).append(word.substring(1)));
        return type.toString();
    }

    private void leaf(Class<? extends Record> record) {
        leaf(type(record), record);
    }

    /** The type of an element with attributes only. */
    private void leaf(String type, Class<? extends Record> record) {
        text.open("complexType", "name", type).documentation(ElementTable.means(record));
        attributes(record);
        text.close("complexType");
    }

    private void extension(String type, Class<? extends Record> record, String base, Runnable content) {
        text.open("complexType", "name", type).documentation(ElementTable.means(record)).open("complexContent").open("extension", "base", "s:" + base);
        content.run();
        attributes(record);
        text.close("extension").close("complexContent").close("complexType");
    }

    private void attributes(Class<? extends Record> record) {
        // One of several kinds need not be there at all.
        Described.inline(record).forEach(one -> attribute(one, one.isRequired() && one.within().isEmpty()));
    }

    private void attribute(Described one, boolean mustBeThere) {
        List<String> use = mustBeThere ? List.of("use", "required") : List.of();
        String type = SimpleTypes.name(one) + (hasFormulas && MadeTypes.takesFormulas(one.says().value()) ? MadeTypes.OR_FORMULA : "");
        text.open("attribute", Stream.concat(Stream.of("name", one.name(), "type", "s:" + type), use.stream()).toArray(String[]::new));
        text.documentation(one.says().means() + (one.isRequired() || one.isOptional() ? "." : "; " + standard(one) + " if not given."));
        text.close("attribute");
    }

    private static String standard(Described one) {
        String otherwise = one.says().otherwise();
        return one.says().value() != Kind.COLOR ? otherwise : otherwise.equals("0 0 0") ? "black" : otherwise.equals("255 255 255") ? "white" : otherwise;
    }
}
