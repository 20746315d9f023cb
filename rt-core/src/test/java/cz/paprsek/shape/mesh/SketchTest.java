package cz.paprsek.shape.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Meshes are drawn by few lines, which are where all edges would be. */
class SketchTest {
    /** As coarse as the lines may be at all, of the size 2. */
    private static final double WITHIN = 2.0 / 700;

    private record Piece(Vec3 from, Vec3 to) {
        double distance(Vec3 p) {
            Vec3 way = to.minus(from);
            double square = way.dot(way);
            double t = square > 0 ? Math.max(0, Math.min(1, p.minus(from).dot(way) / square)) : 0;
            return p.minus(from).minus(way.times(t)).length();
        }
    }

    private static List<Piece> pieces(Triangles mesh, Vec3 along) {
        List<Piece> pieces = new ArrayList<>();
        for (List<Vec3> line : mesh.outline(along, false)) {
            for (int i = 1; i < line.size(); i++) {
                pieces.add(new Piece(line.get(i - 1), line.get(i)));
            }
        }
        return pieces;
    }

    @Test
    void aBallOfManyTrianglesIsDrawnByItsRimAlone() {
        Triangles ball = Meshes.ball(1, 200);
        Vec3 along = new Vec3(1, 2, 3).normalized();
        List<Piece> pieces = pieces(ball, along);
        assertThat(pieces).hasSizeLessThan(2000).allSatisfy(piece -> assertThat(Math.abs(piece.from().dot(along))).isLessThan(0.02));
        Vec3 right = along.cross(Vec3.Y).normalized();
        Vec3 up = along.cross(right);
        for (int i = 0; i < 360; i++) {
            Vec3 onRim = right.times(Math.cos(Math.toRadians(i))).plus(up.times(Math.sin(Math.toRadians(i))));
            assertThat(pieces).anyMatch(piece -> piece.distance(onRim) < 0.02);
        }
    }

    /** Within a cell of the grid of what it is, by fewer pieces, whose ends need not be vertices. */
    @Test
    void whatIsBeingTurnedIsDrawnRoughly() {
        Triangles ball = Meshes.ball(1, 200);
        Vec3 along = new Vec3(1, 2, 3).normalized();
        List<Vec3> rough = ball.outline(along, true).stream().flatMap(List::stream).toList();
        assertThat(rough).hasSizeBetween(30, pieces(ball, along).size()).allSatisfy(p -> {
            assertThat(p.length()).isBetween(0.95, 1.01);
            assertThat(Math.abs(p.dot(along))).isLessThan(0.15);
        });
        Triangles few = Meshes.ball(1, 20);
        assertThat(few.outline(along, true)).as("few triangles are drawn as they are").isSameAs(few.outline(along, false));
    }

    /** As told by going over all edges one by one: the ends of those that are drawn are near lines, and lines lead from one to another. */
    @Test
    void theLinesAreThoseThatAllEdgesTogetherWouldMake() {
        SplittableRandom random = new SplittableRandom(1);
        for (Triangles mesh : List.of(Meshes.torus(0.7, 0.3, 90, 40), Meshes.without(Meshes.ball(1, 20), 100), Meshes.cube(1), Meshes.apart(Meshes.torus(0.7, 0.3, 30, 20)))) {
            Map<Piece, List<Vec3>> normals = normals(mesh);
            for (int n = 0; n < 12; n++) {
                Vec3 along = n == 0 ? Vec3.Z : new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
                List<Piece> pieces = pieces(mesh, along);
                List<Vec3> ends = new ArrayList<>();
                normals.forEach((edge, beside) -> {
                    if (beside.size() != 2 || beside.get(0).dot(beside.get(1)) < 0.766 || (beside.get(0).dot(along) > 0) != (beside.get(1).dot(along) > 0)) {
                        ends.add(edge.from());
                        ends.add(edge.to());
                    }
                });
                assertThat(pieces.size()).isBetween(1, ends.size() / 2);
                assertThat(ends).allSatisfy(end -> assertThat(pieces).anyMatch(piece -> piece.distance(end) < WITHIN));
                assertThat(ends).containsAll(pieces.stream().map(Piece::from).toList());
            }
        }
    }

    /** The normals of the triangles at each edge. */
    private static Map<Piece, List<Vec3>> normals(Triangles mesh) {
        Map<Piece, List<Vec3>> all = new HashMap<>();
        for (int t = 0; t < mesh.count(); t++) {
            Vec3 a = mesh.place(mesh.corner(t, 0));
            Vec3 n = mesh.place(mesh.corner(t, 1)).minus(a).cross(mesh.place(mesh.corner(t, 2)).minus(a)).normalized();
            for (int k = 0; k < 3; k++) {
                Vec3 from = mesh.place(mesh.corner(t, k));
                Vec3 to = mesh.place(mesh.corner(t, (k + 1) % 3));
                boolean isFirst = from.x() < to.x() || (from.x() == to.x() && (from.y() < to.y() || (from.y() == to.y() && from.z() < to.z())));
                all.computeIfAbsent(isFirst ? new Piece(from, to) : new Piece(to, from), missing -> new ArrayList<>()).add(n);
            }
        }
        return all;
    }

    /** Who drags a mesh asks again in every frame; what has too many edges to be told apart is drawn by some of them. */
    @Test
    void whatWasDrawnIsKeptAndNeverTooMuch() {
        SplittableRandom random = new SplittableRandom(2);
        Triangles.Builder rubble = Triangles.builder();
        for (int i = 0; i < 20_000; i++) {
            int v = rubble.vertex(random.nextDouble(), random.nextDouble(), random.nextDouble());
            rubble.vertex(rubble.vertexCount() * 1e-5, random.nextDouble(), random.nextDouble());
            rubble.vertex(random.nextDouble(), random.nextDouble(), random.nextDouble());
            rubble.triangle(v, v + 1, v + 2);
        }
        Triangles mesh = rubble.build();
        assertThat(pieces(mesh, Vec3.X).size()).isBetween(500, 3 * 1200);
        assertThat(mesh.outline(Vec3.X, false)).isSameAs(mesh.outline(new Vec3(1, 0, 0), false));
    }
}
