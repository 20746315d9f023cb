package cz.paprsek.format.openscad;

import cz.paprsek.format.model.FormatFault;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/**
 * One thing in the tree.
 *
 * @param modifier {@code % # * !}, or a blank
 * @param arguments by name; those without one by their number, from 0
 */
record Node(String name, char modifier, Map<String, Value> arguments, List<Node> children, long line) {

    FormatFault fault(String sentence) {
        return FormatFault.line(line, sentence);
    }

    double number(String argument, double otherwise) throws FormatFault {
        Value value = arguments.get(argument);
        if (value == null || value instanceof Value.Undefined) {
            return otherwise;
        }
        if (value instanceof Value.Num number && Math.abs(number.number()) <= 1e30) {
            return number.number();
        }
        throw fault(name + " " + argument + " must be a finite number");
    }

    boolean flag(String argument) {
        return arguments.get(argument) instanceof Value.Flag flag && flag.isTrue();
    }

    String text(String argument) {
        return arguments.get(argument) instanceof Value.Text text ? text.text() : "";
    }

    /** A list of numbers, or one number as often as there are to be. */
    double[] numbers(String argument, int count, double otherwise) throws FormatFault {
        Value value = arguments.get(argument);
        double[] numbers = new double[count];
        if (value == null || value instanceof Value.Num || value instanceof Value.Undefined) {
            Arrays.fill(numbers, number(argument, otherwise));
            return numbers;
        }
        return vector(value, count, argument);
    }

    /** The first of a list's numbers. */
    double[] vector(Value value, int count, String argument) throws FormatFault {
        double[] numbers = new double[count];
        if (!(value instanceof Value.Vec vector) || vector.values().size() < count) {
            throw fault(name + " " + argument + " must be " + count + " numbers in [ ]");
        }
        for (int i = 0; i < count; i++) {
            if (!(vector.values().get(i) instanceof Value.Num number) || !(Math.abs(number.number()) <= 1e30)) {
                throw fault(name + " " + argument + " must be finite numbers");
            }
            numbers[i] = number.number();
        }
        return numbers;
    }

    List<Value> list(String argument) throws FormatFault {
        Value value = arguments.get(argument);
        if (value == null || value instanceof Value.Undefined) {
            return List.of();
        }
        if (value instanceof Value.Vec vector) {
            return vector.values();
        }
        throw fault(name + " " + argument + " must be a list in [ ]");
    }

    /** A list of whole numbers below a limit. */
    int[] indexes(Value value, int limit, String argument) throws FormatFault {
        if (!(value instanceof Value.Vec vector)) {
            throw fault(name + " " + argument + " must be lists in [ ]");
        }
        int[] indexes = new int[vector.values().size()];
        for (int i = 0; i < indexes.length; i++) {
            if (!(vector.values().get(i) instanceof Value.Num number) || !(number.number() >= 0 && number.number() < limit)) {
                throw fault(name + " " + argument + " must be numbers of points, from 0 to " + (limit - 1));
            }
            indexes[i] = (int) number.number();
        }
        return indexes;
    }
}
