package cz.paprsek.xml.write;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The schema's elements of shapes, and the attributes of all records, are made from what stands at the records: {@code -Dpaprsek.schema=write}
 * writes them into the file that is shipped.
 */
class SchemaTest {
    private static final Path FILE = Path.of("src/main/resources/cz/paprsek/xml/scene.xsd");
    private static final Map<String, Class<?>> TYPES = new LinkedHashMap<>();

    static {
        TYPES.put("Render", RenderSettings.class);
        TYPES.put("Camera", Camera.class);
        TYPES.put("PointLight", Light.class);
        TYPES.put("Material", Material.class);
        TYPES.put("Checkerboard", Pattern.Checkerboard.class);
        TYPES.put("Checker", Pattern.Checker.class);
        TYPES.put("Object", Placement.class);
        shapes(Shape.class).forEach(shape -> TYPES.put(shape.getSimpleName(), shape));
    }

    /** All kinds of shape but operations. */
    private static Stream<Class<?>> shapes(Class<?> type) {
        return type.isRecord() ? Stream.<Class<?>>of(type).filter(record -> record != Csg.class)
                : Arrays.stream(type.getPermittedSubclasses()).flatMap(SchemaTest::shapes);
    }

    static Stream<Arguments> attributes() {
        return TYPES.values().stream().flatMap(type -> Described.of(type).stream().map(one -> Arguments.of(type.getSimpleName() + " " + one.name(), type, one)));
    }

    @Test
    void theSchemaSaysWhatTheRecordsSay() throws IOException {
        String shipped = Files.readString(FILE);
        String made = shipped;
        for (Map.Entry<String, Class<?>> type : TYPES.entrySet()) {
            made = withType(made, type.getKey(), type.getValue());
        }
        made = withElements(made, "<xs:group name=\"solid\">\n    <xs:choice>\n", "      <xs:element name=\"union\"", shapes(Solid.class));
        made = withElements(made, "type=\"s:NamedMaterial\"/>\n", "      <xs:group ref=\"s:solid\"/>", shapes(Shape.class).filter(shape -> !Solid.class.isAssignableFrom(shape)));
        if ("write".equals(System.getProperty("paprsek.schema"))) {
            Files.writeString(FILE, made);
        }
        assertThat(shipped).as("write it anew with -Dpaprsek.schema=write").isEqualTo(made);
    }

    private static String withElements(String schema, String before, String after, Stream<Class<?>> shapes) {
        int from = schema.indexOf(before) + before.length();
        StringBuilder lines = new StringBuilder();
        shapes.forEach(shape -> lines.append("      <xs:element name=\"").append(shape.getSimpleName().toLowerCase(Locale.ROOT)).append("\" type=\"s:")
                .append(shape.getSimpleName()).append("\"/>\n"));
        return schema.substring(0, from) + lines + schema.substring(schema.indexOf(after, from));
    }

    /** The schema with the attributes that a record says; a shape that is not there yet is put before the operations. */
    private static String withType(String schema, String name, Class<?> record) {
        String start = "  <xs:complexType name=\"" + name + "\">\n";
        if (!schema.contains(start)) {
            int at = schema.indexOf("  <xs:complexType name=\"Csg\">");
            return withType(schema.substring(0, at) + start + """
                        <xs:annotation><xs:documentation></xs:documentation></xs:annotation>
                        <xs:complexContent><xs:extension base="s:Object">
                          <xs:sequence><xs:element name="material" type="s:Material" minOccurs="0"/></xs:sequence>
                        </xs:extension></xs:complexContent>
                      </xs:complexType>
                    """ + schema.substring(at), name, record);
        }
        int from = schema.indexOf(start);
        int to = schema.indexOf("  </xs:complexType>\n", from);
        String type = schema.substring(from, to);
        Element says = record.getAnnotation(Element.class);
        if (says != null) {
            type = type.replaceFirst("<xs:documentation>.*?</xs:documentation>", Matcher.quoteReplacement("<xs:documentation>" + says.value() + "</xs:documentation>"));
        }
        List<String> made = Described.of(record).stream().map(SchemaTest::line).toList();
        List<String> lines = new ArrayList<>();
        int place = -1;
        for (String line : type.lines().map(text -> text + "\n").toList()) {
            boolean isOurs = Described.of(record).stream().anyMatch(one -> line.startsWith("    <xs:attribute name=\"" + one.name() + "\""));
            boolean isEnd = place < 0 && line.startsWith("    </xs:extension>");
            place = place < 0 && (isOurs || isEnd) ? lines.size() : place;
            if (!isOurs) {
                lines.add(line);
            }
        }
        lines.addAll(place < 0 ? lines.size() : place, made);
        return schema.substring(0, from) + String.join("", lines) + schema.substring(to);
    }

    private static String line(Described one) {
        String otherwise = one.says().otherwise();
        String standard = one.says().value() != Kind.COLOR ? otherwise : otherwise.equals("0 0 0") ? "black" : otherwise.equals("255 255 255") ? "white" : otherwise;
        return "    <xs:attribute name=\"" + one.name() + "\" type=\"s:" + one.says().value().type() + "\"" + (one.isRequired() ? " use=\"required\"" : "")
                + "><xs:annotation><xs:documentation>" + one.says().means() + (one.isRequired() ? "." : "; " + standard + " if not given.")
                + "</xs:documentation></xs:annotation></xs:attribute>\n";
    }

    /** What stands at a record is what its constructor holds to: a number beyond the bounds of its kind is refused, one within is not. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("attributes")
    void theRecordHoldsToTheBoundsOfItsKind(String name, Class<?> type, Described one) throws Exception {
        Kind kind = one.says().value();
        if (one.isNumber() && kind != Kind.FOVY) {
            assertThat(isTaken(type, one, kind.least() - 1)).as("below").isFalse();
            assertThat(isTaken(type, one, Math.max(kind.least(), 0.25))).as("the least, or nearly").isTrue();
            if (Double.isFinite(kind.most())) {
                assertThat(isTaken(type, one, kind.most())).as("the most").isTrue();
                assertThat(isTaken(type, one, kind.most() * 1.001 + 1)).as("above").isFalse();
            }
        }
    }

    private static boolean isTaken(Class<?> type, Described one, double number) throws ReflectiveOperationException {
        RecordComponent[] components = type.getRecordComponents();
        Object[] values = new Object[components.length];
        for (int i = 0; i < values.length; i++) {
            Class<?> component = components[i].getType();
            values[i] = components[i].getName().equals(one.component().getName()) ? (component == int.class ? (Object) (int) number : (Object) number)
                    : component == double.class ? (Object) (type == Cone.class || !one.name().equals("major-radius") ? 1.0 : 0.25)
                    : component == int.class ? (Object) 1
                    : component == Vec3.class ? new Vec3(1, 1, 1)
                    : component == String.class ? ""
                    : component == Pattern.class ? Material.DEFAULT.pattern()
                    : component == Camera.Aim.class ? new Camera.Direction(Vec3.X)
                    : Rgb.WHITE;
        }
        try {
            type.getDeclaredConstructor(Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new)).newInstance(values);
            return true;
        } catch (InvocationTargetException refused) {
            assertThat(refused.getCause()).isInstanceOf(IllegalArgumentException.class);
            return false;
        }
    }

    /** The defaults that records have in code are those that stand at their components. */
    @ParameterizedTest
    @MethodSource("defaults")
    void theDefaultIsWhatIsSaid(Record standard) {
        for (Described one : Described.of(standard.getClass())) {
            if (!one.isRequired()) {
                String value = one.value(standard) instanceof Vec3 vector ? XmlText.text(vector) : XmlText.text(one.number(standard));
                assertThat(one.says().value() == Kind.SCALE ? value.substring(0, value.indexOf(' ')) : value).as(one.name()).isEqualTo(one.says().otherwise());
            }
        }
    }

    static Stream<Record> defaults() {
        return Stream.of(Material.DEFAULT, RenderSettings.DEFAULT, Camera.DEFAULT, Placement.NONE);
    }
}
