package cz.paprsek.fx.model.edit;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Text;
import cz.paprsek.text.Numbers;
import java.lang.reflect.RecordComponent;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** One shape of each primitive kind, to begin with: as the attributes of its record say. */
public final class Examples {
    private static final String HALF = "0.5";

    private Examples() {}

    /** One of each kind, of about the given size. */
    public static List<Shape> ofSize(double size) {
        return ElementTable.of(Shape.class).filter(type -> type != Csg.class && !needsFile(type)).map(type -> make(type, size)).toList();
    }

    /** What a file holds nobody can make up. */
    private static boolean needsFile(Class<? extends Record> type) {
        return Described.of(type).stream().anyMatch(one -> one.says().value() == Kind.FILE && one.isRequired());
    }

    private static Shape make(Class<? extends Record> type, double size) {
        Object[] values = Stream.concat(Described.of(type).stream().flatMap(one -> values(one, size)), type == Text.class ? Stream.of(Text.Content.UNREAD) : Stream.of()).toArray();
        try {
            Class<?>[] types = Arrays.stream(type.getRecordComponents()).map(RecordComponent::getType).toArray(Class<?>[]::new);
            return (Shape) type.getConstructor(types).newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("the example at the attributes of " + type + " is none", e);
        }
    }

    /** The values of its components. */
    private static Stream<Object> values(Described one, double size) {
        Attribute says = one.says();
        boolean isAsUsual = says.example().isEmpty() && !one.isRequired();
        String text = !says.example().isEmpty() ? says.example() : isAsUsual ? says.otherwise() : HALF;
        Kind.Form form = says.value().form();
        if (form == Kind.Form.TEXT) {
            return Stream.of(says.value() == Kind.POINTS ? points(text, size) : says.value() == Kind.LETTERS || says.value() == Kind.FONT ? text
                    : says.value() == Kind.EXPRESSION ? text.replaceAll("[xyz]", "($0/" + Numbers.text(size) + ")") : "");
        }
        if (form == Kind.Form.WHOLE) {
            return Stream.of(Integer.valueOf(text));
        }
        // Lengths have no upper bound; angles, shares and exponents do, and are the same at any size.
        double unit = isAsUsual || says.value().most() < Double.POSITIVE_INFINITY ? 1 : size;
        double[] numbers = Arrays.stream(text.split(" ")).mapToDouble(share -> part(unit, Double.parseDouble(share))).toArray();
        return form == Kind.Form.VECTOR ? Stream.of(new Vec3(numbers[0], numbers[1], numbers[2])) : Arrays.stream(numbers).mapToObj(Double::valueOf);
    }

    /** Corners of about the given size. */
    private static String points(String shares, double size) {
        return Arrays.stream(shares.split(" ")).map(share -> Numbers.text(part(size, Double.parseDouble(share)))).collect(Collectors.joining(" "));
    }

    /** A share of a size, without the noise of binary fractions. */
    private static double part(double size, double share) {
        return new BigDecimal(size * share).round(new MathContext(10)).doubleValue();
    }
}
