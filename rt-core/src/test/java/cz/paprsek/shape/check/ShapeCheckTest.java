package cz.paprsek.shape.check;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.CustomShape;
import cz.paprsek.shape.CustomSolid;
import cz.paprsek.shape.Examples;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import java.util.Collection;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** What is asked of shapes that are made in code: our own pass, and each kind of mistake is found. */
class ShapeCheckTest {
    static Collection<Shape> ours() {
        return Examples.ALL.values();
    }

    @ParameterizedTest
    @MethodSource("ours")
    void ourOwnShapesAreWithoutFault(Shape shape) {
        assertThat(ShapeCheck.problems(shape)).isEmpty();
    }

    @Test
    void aSolidAndAFigureMadeInCodeAreWithoutFault() {
        assertThat(ShapeCheck.problems(new Ball())).isEmpty();
        assertThat(ShapeCheck.problems(new Sheet())).isEmpty();
        assertThat(ShapeCheck.problems(Csg.difference(new Ball(), new Sphere(0.5)))).isEmpty();
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                Arguments.of("is met by hardly any", new Ball() {
                    @Override
                    public Bounds bounds() {
                        return Bounds.around(Vec3.ZERO, new Vec3(90, 90, 90));
                    }
                }),
                Arguments.of("is crossed outside its bounds", new Ball() {
                    @Override
                    public Bounds bounds() {
                        return Bounds.around(Vec3.ZERO, new Vec3(1, 0.9, 1));
                    }
                }),
                Arguments.of("all crossings of the whole line must be told", new Ball() {
                    @Override
                    void cross(Line line, double enter, double leave) {
                        if (enter > 0) {
                            super.cross(line, enter, leave);
                        }
                    }
                }),
                Arguments.of("must be in rising order", new Ball() {
                    @Override
                    void cross(Line line, double enter, double leave) {
                        super.cross(line, leave, enter);
                    }
                }),
                Arguments.of("says that a line crosses it at NaN", new Ball() {
                    @Override
                    void cross(Line line, double enter, double leave) {
                        super.cross(line, enter, Double.NaN);
                    }
                }),
                Arguments.of("must be left as often as it is entered", new Ball() {
                    @Override
                    void cross(Line line, double enter, double leave) {
                        line.cross(enter);
                    }
                }),
                Arguments.of("a direction of length 1 was expected", new Ball() {
                    @Override
                    void cross(Line line, double enter, double leave) {
                        throw new IllegalArgumentException("a direction of length 1 was expected");
                    }
                }),
                Arguments.of("holds a point seen one way and not another", new Ball() {
                    @Override
                    void cross(Line line, double enter, double leave) {
                        double middle = (enter + leave) / 2;
                        double k = Math.abs(line.dx) > Math.abs(line.dy) ? 1 : 0.8;
                        super.cross(line, middle + k * (enter - middle), middle + k * (leave - middle));
                    }
                }),
                Arguments.of("has a normal that is no direction", new Ball() {
                    @Override
                    public void normal(int face, Hit hit) {
                        hit.normal(0, 0, 0);
                    }
                }),
                Arguments.of("has a normal that looks inwards", new Ball() {
                    @Override
                    public void normal(int face, Hit hit) {
                        hit.normal(-hit.px, -hit.py, -hit.pz);
                    }
                }),
                Arguments.of("has a normal that is not at right angles to it", new Ball() {
                    @Override
                    public void normal(int face, Hit hit) {
                        hit.normal(hit.px, 1.1 * hit.py, hit.pz);
                    }
                }),
                Arguments.of("a tangent that does not lie along it", new Ball() {
                    @Override
                    public void map(int face, Hit hit) {
                        hit.map(hit.px, hit.py, 1, 0, 0);
                    }
                }));
    }

    @ParameterizedTest
    @MethodSource("mistakes")
    void aMistakeIsFoundAndSaid(String sentence, CustomShape mistaken) {
        assertThat(ShapeCheck.problems(mistaken)).anyMatch(problem -> problem.contains(sentence));
    }

    /** The unit ball, without a formula of ours. */
    private static class Ball implements CustomSolid {
        @Override
        public String kind() {
            return "own ball";
        }

        @Override
        public Bounds bounds() {
            return Bounds.around(Vec3.ZERO, Vec3.ONE);
        }

        @Override
        public final void cross(Line line) {
            double dd = line.dx * line.dx + line.dy * line.dy + line.dz * line.dz;
            double middle = -(line.ox * line.dx + line.oy * line.dy + line.oz * line.dz) / dd;
            double x = line.ox + middle * line.dx;
            double y = line.oy + middle * line.dy;
            double z = line.oz + middle * line.dz;
            double half = Math.sqrt((1 - x * x - y * y - z * z) / dd);
            if (half > 0) {
                cross(line, middle - half, middle + half);
            }
        }

        void cross(Line line, double enter, double leave) {
            line.cross(enter);
            line.cross(leave);
        }

        @Override
        public void normal(int face, Hit hit) {
            hit.normal(hit.px, hit.py, hit.pz);
        }
    }

    /** A piece of the curved sheet y = x², from −1 to 1 in x and z: a line crosses it twice at most. */
    private static final class Sheet implements CustomShape {
        @Override
        public Bounds bounds() {
            return new Bounds(-1, 0, -1, 1, 1, 1);
        }

        @Override
        public void cross(Line line) {
            double a = line.dx * line.dx;
            double b = line.ox * line.dx - line.dy / 2;
            double c = line.ox * line.ox - line.oy;
            double root = Math.sqrt(b * b - a * c);
            double q = -(b + Math.copySign(root, b));
            hold(line, q / a);
            hold(line, c / q);
        }

        private static void hold(Line line, double t) {
            if (Math.abs(line.ox + t * line.dx) <= 1 && Math.abs(line.oz + t * line.dz) <= 1) {
                line.cross(t);
            }
        }

        @Override
        public void normal(int face, Hit hit) {
            hit.normal(-2 * hit.px, 1, 0);
        }

        @Override
        public void map(int face, Hit hit) {
            hit.map((1 + hit.px) / 2, (1 - hit.pz) / 2, 1, 2 * hit.px, 0);
        }
    }
}
