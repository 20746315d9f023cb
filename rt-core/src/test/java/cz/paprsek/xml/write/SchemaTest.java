package cz.paprsek.xml.write;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.attribute.Kind;
import cz.paprsek.attribute.Range;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Text;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.StringReader;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.math.BigDecimal;
import java.util.Arrays;
import java.util.stream.Stream;
import javax.xml.XMLConstants;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.SchemaFactory;
import javax.xml.validation.Validator;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.xml.sax.SAXException;

/** What is said at the records is what schema and constructors hold to. */
class SchemaTest {
    private static final String NAMESPACE = "urn:paprsek:scene:1";

    /** All that are elements, and what has attributes without being one. */
    private static Stream<Class<?>> records() {
        return Stream.of(Stream.of(RenderSettings.class, Camera.class, Lens.Perspective.class, Lens.Orthographic.class, Lens.Fisheye.class, Material.class, Placement.class, Pattern.Stop.class, Pattern.TwoColors.class, Pattern.Lay.class, Sky.Gradient.class, Sky.Picture.class), ElementTable.of(Light.class), ElementTable.of(Pattern.class),
                ElementTable.of(Shape.class).filter(type -> type != Csg.class)).flatMap(some -> some);
    }

    static Stream<Arguments> attributes() {
        return records().flatMap(type -> Described.of(type).stream().map(one -> Arguments.of(type.getSimpleName() + " " + one.name(), type, one)));
    }

    /** Every type that a kind of number is written as takes its bounds, if they belong to it, and nothing beyond. */
    @ParameterizedTest
    @EnumSource(Kind.class)
    void theSchemaHoldsToTheBoundsOfAKind(Kind kind) throws SAXException {
        // Intensities share their type with all that is not negative: the record alone knows their greatest.
        if ((kind.form() == Kind.Form.NUMBER || kind.form() == Kind.Form.WHOLE) && kind != Kind.INTENSITY) {
            boolean isWhole = kind.form() == Kind.Form.WHOLE;
            Range range = kind.range();
            assertThat(isTaken(kind, "Infinity")).isFalse();
            assertThat(isTaken(kind, "INF")).isFalse();
            assertThat(isTaken(kind, "2.5")).isEqualTo(!isWhole && range.least() < 2.5 && range.most() > 2.5);
            if (Double.isFinite(range.least())) {
                assertThat(isTaken(kind, text(range.least()))).as("the least").isEqualTo(range.takesLeast());
                assertThat(isTaken(kind, isWhole || range.least() < 0 ? text(range.least() - 1) : "-1e-300")).as("below").isFalse();
            }
            if (Double.isFinite(range.most())) {
                assertThat(isTaken(kind, text(range.most()))).as("the most").isEqualTo(range.takesMost());
                assertThat(isTaken(kind, text(range.most() + 1))).as("above").isFalse();
            }
        }
    }

    private static boolean isTaken(Kind kind, String value) throws SAXException {
        String schema = SceneFiles.schema().replace("</xs:schema>", "<xs:element name=\"probe\" type=\"s:" + kind.type() + "\"/></xs:schema>");
        Validator validator = SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI).newSchema(new StreamSource(new StringReader(schema))).newValidator();
        try {
            validator.validate(new StreamSource(new StringReader("<probe xmlns=\"" + NAMESPACE + "\">" + value + "</probe>")));
            return true;
        } catch (SAXException refused) {
            return false;
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String text(double value) {
        return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
    }

    @ParameterizedTest
    @ValueSource(strings = {"red", "RED", "Red", "#f80", "#FF8000", "255 0 0.5"})
    void everyFormOfAColourIsTaken(String color) throws SAXException {
        assertThat(isTaken(Kind.COLOR, color)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "16", "03", "64", "1000000", "1..1", "2..8", "16..16", "64..1000000", " 2..8 "})
    void samplesAreANumberOrTwo(String samples) throws SAXException {
        assertThat(isTaken(Kind.SAMPLES, samples)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "1000001", "2..1000001", "2..10000000", "0..4", "2..", "..2", "2...4", "2 4", "2.5", ""})
    void whatIsNoNumberOfSamplesIsRefused(String samples) throws SAXException {
        assertThat(isTaken(Kind.SAMPLES, samples)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"rad", "#ff80", "256 0 0", "0 0", "0 0 0 0", "-1 0 0", "NaN 0 0", ""})
    void whatIsNoColourIsRefused(String color) throws SAXException {
        assertThat(isTaken(Kind.COLOR, color)).isFalse();
    }

    /** What stands at a record is what its constructor holds to: a number beyond the bounds of its kind is refused, one within is not. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("attributes")
    void theRecordHoldsToTheBoundsOfItsKind(String name, Class<?> type, Described one) throws Exception {
        Kind kind = one.says().value();
        // The angles of a cone depend on each other.
        if (one.isNumber() && kind != Kind.FOVY && kind != Kind.CONE_ANGLE) {
            assertThat(isTaken(type, one, kind.least() - 1)).as("below").isFalse();
            assertThat(isTaken(type, one, Math.max(kind.least(), 0.25))).as("the least, or nearly").isTrue();
            if (Double.isFinite(kind.most())) {
                assertThat(isTaken(type, one, kind.most())).as("the most").isEqualTo(kind.range().takesMost());
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
                    : type == RenderSettings.class ? components[i].getAccessor().invoke(RenderSettings.DEFAULT)
                    : component == double.class ? (Object) (type == Cone.class || !one.name().equals("major-radius") ? 1.0 : 0.25)
                    : component == int.class ? (Object) 4
                    : component == boolean.class ? (Object) true
                    : component == AreaLight.Form.class ? new AreaLight.Radius(1)
                    : component == Vec3.class ? components[i].getName().equals("min") ? new Vec3(-1, -1, -1) : new Vec3(1, 1, 1)
                    : components[i].getName().equals("points") ? "0 0 1 0 0 1"
                    : components[i].getName().equals("path") ? ""
                    : component == String.class ? "name"
                    : component.isEnum() ? component.getEnumConstants()[0]
                    : component == Pattern.Lay.class ? Pattern.Lay.NONE
                    : component == Pattern.Colors.class ? Pattern.Colors.DEFAULT
                    : component == Pattern.class ? Material.DEFAULT.pattern()
                    : component == Camera.Aim.class ? new Camera.Direction(Vec3.X)
                    : component == Material.Shares.class ? Material.Shares.EVEN
                    : component == Material.Relief.class ? Material.Relief.FLAT
                    : component == Mesh.Content.class ? Mesh.Content.UNREAD
                    : component == Text.Content.class ? Text.Content.UNREAD
                    : components[i].getName().equals("expression") ? "x"
                    : component == Lens.class ? Lens.Perspective.DEFAULT
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
            if (!one.isRequired() && !one.isOptional()) {
                String value = SceneWriter.text(one, one.value(standard));
                assertThat(value).as(one.name()).isEqualTo(one.says().otherwise());
            }
        }
    }

    static Stream<Record> defaults() {
        return Stream.of(Material.DEFAULT, RenderSettings.DEFAULT, Camera.DEFAULT, Lens.Perspective.DEFAULT, Lens.Fisheye.DEFAULT, Placement.NONE,
                Light.at(1, 2, 3), SpotLight.from(Vec3.X, Vec3.ZERO), AreaLight.disc(Vec3.X, 2), SphereLight.of(Vec3.X, 2), SunLight.along(0, -1, 0));
    }
}
