package cz.paprsek.formula;

import cz.paprsek.math.Angles;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * What can be done with numbers in a formula. Angles are in degrees; what is true is 1, what is not 0, and everything but 0 counts as true. The same
 * bits on every machine: only the four operations, the square root and {@link StrictMath}.
 */
public enum Function {
    NEGATE("-", 1) {
        @Override
        public double of(double a, double b, double c) {
            return -a;
        }
    },
    PLUS("+", 2) {
        @Override
        public double of(double a, double b, double c) {
            return a + b;
        }
    },
    MINUS("-", 2) {
        @Override
        public double of(double a, double b, double c) {
            return a - b;
        }
    },
    TIMES("*", 2) {
        @Override
        public double of(double a, double b, double c) {
            return a * b;
        }
    },
    DIVIDE("/", 2) {
        @Override
        public double of(double a, double b, double c) {
            return a / b;
        }
    },
    /** With the sign of what is divided, as in most languages. */
    REMAINDER("%", 2) {
        @Override
        public double of(double a, double b, double c) {
            return a % b;
        }
    },
    POWER("^", 2) {
        @Override
        public double of(double a, double b, double c) {
            return b == 2 ? a * a : StrictMath.pow(a, b);
        }
    },
    LESS("<", 2) {
        @Override
        public double of(double a, double b, double c) {
            return truth(a < b);
        }
    },
    AT_MOST("<=", 2) {
        @Override
        public double of(double a, double b, double c) {
            return truth(a <= b);
        }
    },
    GREATER(">", 2) {
        @Override
        public double of(double a, double b, double c) {
            return truth(a > b);
        }
    },
    AT_LEAST(">=", 2) {
        @Override
        public double of(double a, double b, double c) {
            return truth(a >= b);
        }
    },
    EQUAL("==", 2) {
        @Override
        public double of(double a, double b, double c) {
            return truth(a == b);
        }
    },
    UNEQUAL("!=", 2) {
        @Override
        public double of(double a, double b, double c) {
            return truth(a != b);
        }
    },
    AND("and", 2) {
        @Override
        public double of(double a, double b, double c) {
            return truth(a != 0 && b != 0);
        }
    },
    OR("or", 2) {
        @Override
        public double of(double a, double b, double c) {
            return truth(a != 0 || b != 0);
        }
    },
    NOT("not", 1) {
        @Override
        public double of(double a, double b, double c) {
            return truth(a == 0);
        }
    },
    /** The second of three if the first is true, else the third: {@code a ? b : c}. */
    IF("?", 3) {
        @Override
        public double of(double a, double b, double c) {
            return a != 0 ? b : c;
        }
    },
    SIN("sin", 1) {
        @Override
        public double of(double a, double b, double c) {
            return Angles.sin(a);
        }
    },
    COS("cos", 1) {
        @Override
        public double of(double a, double b, double c) {
            return Angles.cos(a);
        }
    },
    TAN("tan", 1) {
        @Override
        public double of(double a, double b, double c) {
            return Angles.sin(a) / Angles.cos(a);
        }
    },
    ASIN("asin", 1) {
        @Override
        public double of(double a, double b, double c) {
            return degrees(StrictMath.asin(a));
        }
    },
    ACOS("acos", 1) {
        @Override
        public double of(double a, double b, double c) {
            return degrees(StrictMath.acos(a));
        }
    },
    ATAN("atan", 1) {
        @Override
        public double of(double a, double b, double c) {
            return degrees(StrictMath.atan(a));
        }
    },
    ATAN2("atan2", 2) {
        @Override
        public double of(double a, double b, double c) {
            return degrees(StrictMath.atan2(a, b));
        }
    },
    SQRT("sqrt", 1) {
        @Override
        public double of(double a, double b, double c) {
            return Math.sqrt(a);
        }
    },
    CBRT("cbrt", 1) {
        @Override
        public double of(double a, double b, double c) {
            return StrictMath.cbrt(a);
        }
    },
    EXP("exp", 1) {
        @Override
        public double of(double a, double b, double c) {
            return StrictMath.exp(a);
        }
    },
    /** The natural logarithm. */
    LN("ln", 1) {
        @Override
        public double of(double a, double b, double c) {
            return StrictMath.log(a);
        }
    },
    LOG10("log10", 1) {
        @Override
        public double of(double a, double b, double c) {
            return StrictMath.log10(a);
        }
    },
    ABS("abs", 1) {
        @Override
        public double of(double a, double b, double c) {
            return Math.abs(a);
        }
    },
    /** −1, 0 or 1. */
    SIGN("sign", 1) {
        @Override
        public double of(double a, double b, double c) {
            return Math.signum(a);
        }
    },
    FLOOR("floor", 1) {
        @Override
        public double of(double a, double b, double c) {
            return Math.floor(a);
        }
    },
    CEIL("ceil", 1) {
        @Override
        public double of(double a, double b, double c) {
            return Math.ceil(a);
        }
    },
    /** Halves go up. */
    ROUND("round", 1) {
        @Override
        public double of(double a, double b, double c) {
            return Math.floor(a + 0.5);
        }
    },
    /** Of any number of terms, here one after the other. */
    MIN("min", 2) {
        @Override
        public double of(double a, double b, double c) {
            return Math.min(a, b);
        }
    },
    /** Of any number of terms, here one after the other. */
    MAX("max", 2) {
        @Override
        public double of(double a, double b, double c) {
            return Math.max(a, b);
        }
    },
    /** What is left of the first by steps of the second, never negative if the second is not. */
    MOD("mod", 2) {
        @Override
        public double of(double a, double b, double c) {
            double rest = a % b;
            return rest != 0 && rest < 0 != b < 0 ? rest + b : rest;
        }
    },
    /** The length of the diagonal. */
    HYPOT("hypot", 2) {
        @Override
        public double of(double a, double b, double c) {
            return StrictMath.hypot(a, b);
        }
    },
    /** The first, not below the second nor above the third. */
    CLAMP("clamp", 3) {
        @Override
        public double of(double a, double b, double c) {
            return Math.max(b, Math.min(c, a));
        }
    },
    /** From the first to the second as the third goes from 0 to 1. */
    MIX("mix", 3) {
        @Override
        public double of(double a, double b, double c) {
            return a + (b - a) * c;
        }
    },
    /** A number from 0 up to 1 that looks random, the same for the same one or two numbers. */
    RAND("rand", 2) {
        @Override
        public double of(double a, double b, double c) {
            return (mixed(mixed(Double.doubleToLongBits(a + 0.0)) + Double.doubleToLongBits(b + 0.0)) >>> 11) * 0x1p-53;
        }

        /** @source Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, OOPSLA 2014 */
        private long mixed(long seed) {
            long z = seed + 0x9e3779b97f4a7c15L;
            z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
            z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
            return z ^ (z >>> 31);
        }
    };

    private final String word;
    private final int terms;

    Function(String word, int terms) {
        this.word = word;
        this.terms = terms;
    }

    /** What it comes to, which may be no finite number; of those that take fewer terms, the others do not matter. */
    public abstract double of(double a, double b, double c);

    /** How it is written. */
    public String word() {
        return word;
    }

    /** How many terms it takes, 1 to 3. */
    public int terms() {
        return terms;
    }

    /** Whether it is written with parentheses behind it, and not between its terms. */
    public boolean isCalled() {
        return Character.isLetter(word.charAt(0)) && this != AND && this != OR && this != NOT;
    }

    static Optional<Function> called(String word) {
        return Arrays.stream(values()).filter(one -> one.isCalled() && one.word.equals(word)).findFirst();
    }

    /** The names of all that are called. */
    public static List<String> words() {
        List<String> words = new ArrayList<>();
        Arrays.stream(values()).filter(Function::isCalled).forEach(one -> words.add(one.word));
        return words;
    }

    private static double truth(boolean is) {
        return is ? 1 : 0;
    }

    private static double degrees(double radians) {
        return radians * 180 / Math.PI;
    }
}
