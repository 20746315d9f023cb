package cz.paprsek.fx.model.property;

/**
 * Small sums as people type them into number fields: {@code 1/3}, {@code 2*(0.5+1)}, {@code sqrt(2)}, {@code 180/pi}. A decimal point may be
 * a comma. Only arithmetic: nothing that is typed can do anything else, and its length is limited.
 */
public final class Expression {
    private static final int LONGEST = 200;

    private final String text;
    private int at;

    private Expression(String text) {
        this.text = text.strip().replace(',', '.').replace('−', '-').replace('×', '*').replace('·', '*').replace('÷', '/');
    }

    /** @throws IllegalArgumentException with what is wrong, if the text is no sum or its value no finite number */
    public static double value(String text) {
        if (text.length() > LONGEST) {
            throw new IllegalArgumentException("a number or a small sum must have at most " + LONGEST + " characters");
        }
        Expression expression = new Expression(text);
        double value = expression.sum();
        if (expression.at < expression.text.length()) {
            throw expression.unexpected();
        }
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("\"" + text.strip() + "\" has no finite value");
        }
        return value;
    }

    private double sum() {
        double value = product();
        while (true) {
            if (accept('+')) {
                value += product();
            } else if (accept('-')) {
                value -= product();
            } else {
                return value;
            }
        }
    }

    private double product() {
        double value = signed();
        while (true) {
            if (accept('*')) {
                value *= signed();
            } else if (accept('/')) {
                value /= signed();
            } else {
                return value;
            }
        }
    }

    private double signed() {
        return accept('-') ? -signed() : accept('+') ? signed() : power();
    }

    private double power() {
        double base = operand();
        return accept('^') ? StrictMath.pow(base, signed()) : base;
    }

    private double operand() {
        if (accept('(')) {
            return closed();
        }
        int start = at;
        while (at < text.length() && Character.isLetter(text.charAt(at))) {
            at++;
        }
        return start < at ? named(text.substring(start, at)) : number();
    }

    private double named(String word) {
        return switch (word) {
            case "pi", "π" -> Math.PI;
            case "sqrt" -> StrictMath.sqrt(argument());
            case "sin" -> StrictMath.sin(Math.toRadians(argument()));
            case "cos" -> StrictMath.cos(Math.toRadians(argument()));
            case "tan" -> StrictMath.tan(Math.toRadians(argument()));
            default -> throw new IllegalArgumentException("\"" + word + "\" is not a number, nor pi, sqrt, sin, cos or tan");
        };
    }

    private double argument() {
        if (!accept('(')) {
            throw unexpected();
        }
        return closed();
    }

    private double closed() {
        double value = sum();
        if (!accept(')')) {
            throw unexpected();
        }
        return value;
    }

    private double number() {
        int start = at;
        digits();
        if (at < text.length() && (text.charAt(at) == 'e' || text.charAt(at) == 'E')) {
            at++;
            if (at < text.length() && (text.charAt(at) == '-' || text.charAt(at) == '+')) {
                at++;
            }
            digits();
        }
        try {
            double value = Double.parseDouble(text.substring(start, at));
            accept('°');
            return value;
        } catch (NumberFormatException e) {
            at = start;
            throw unexpected();
        }
    }

    private void digits() {
        while (at < text.length() && (Character.isDigit(text.charAt(at)) || text.charAt(at) == '.')) {
            at++;
        }
    }

    private boolean accept(char c) {
        skipBlanks();
        if (at < text.length() && text.charAt(at) == c) {
            at++;
            skipBlanks();
            return true;
        }
        return false;
    }

    private void skipBlanks() {
        while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
            at++;
        }
    }

    private IllegalArgumentException unexpected() {
        String where = at < text.length() ? "\"" + text.substring(at) + "\" was not expected" : text.isEmpty() ? "nothing is there" : "more was expected";
        return new IllegalArgumentException("a number or a small sum such as 1/3 must stand here, but " + where);
    }
}
