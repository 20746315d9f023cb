package cz.paprsek.shape.mesh;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;

/**
 * Triangles that share their corners, in flat arrays: what readers of files make and a mesh is made of. Immutable.
 *
 * <p>Vertices and triangles have numbers from 0 on. A vertex has a place (scene units, the space of the file), and may have a normal and a
 * place u, v in a picture. Where normals or pictures break off at an edge, several vertices lie in one place; what is said of edges
 * ({@link #openEdges}, {@link #oriented}) goes by places. Corners run counter-clockwise as seen from outside. Triangles
 * may belong to parts with names, in any order: each part may get a material of its own.
 */
public final class Triangles {
    private final double[] places;
    private final int[] corners;
    /** Three for each vertex, or none at all. */
    private final float[] normals;
    /** Two for each vertex, or none at all. */
    private final float[] map;
    /** Three for each vertex, or none at all. */
    private final float[] colors;
    private final List<String> partNames;
    /** For each triangle; or empty, and all belong to the first. */
    private final int[] partNumbers;
    private final Bounds bounds;
    private final Findings found = new Findings();

    /** Takes over arrays that nobody else knows. */
    Triangles(double[] places, int[] corners, float[] normals, float[] map, float[] colors, List<String> partNames, int[] partNumbers) {
        this.places = places;
        this.corners = corners;
        this.normals = normals;
        this.map = map;
        this.colors = colors;
        this.partNames = List.copyOf(partNames);
        this.partNumbers = partNumbers;
        this.bounds = TriangleCheck.check(places, corners, normals, map, colors, this.partNames, partNumbers);
    }

    /**
     * Triangles without normals, pictures and parts. The arrays are copied.
     *
     * @param places x y z of each vertex
     * @param corners the numbers of the three vertices of each triangle
     * @throws IllegalArgumentException if there is no triangle, a place is no {@linkplain cz.paprsek.math.Require#coordinate coordinate}, or a corner is no vertex
     */
    public static Triangles of(double[] places, int[] corners) {
        return new Triangles(places.clone(), corners.clone(), new float[0], new float[0], new float[0], List.of(""), new int[0]);
    }

    /** To be made vertex by vertex, without copying what has been made: for readers of files. */
    public static Builder builder() {
        return new Builder();
    }

    /**
     * The same with other normals.
     *
     * @param perVertex x y z for each vertex, of any length; 0 0 0 where none is known, and that of the triangle stands for it. Empty for none at all. Copied
     */
    public Triangles withNormals(float[] perVertex) {
        return new Triangles(places, corners, perVertex.clone(), map, colors, partNames, partNumbers).knowing(found.shells());
    }

    /**
     * The same with another map.
     *
     * @param perVertex u v for each vertex, 0 0 being the lower left corner of the picture; empty for none. Copied
     */
    public Triangles withMap(float[] perVertex) {
        return new Triangles(places, corners, normals, perVertex.clone(), colors, partNames, partNumbers).knowing(found.shells());
    }

    /**
     * The same with other colours.
     *
     * @param perVertex red, green and blue of each vertex, linear light, 0 or above: what the colour of the material there is multiplied by; empty for none. Copied
     */
    public Triangles withColors(float[] perVertex) {
        return new Triangles(places, corners, normals, map, perVertex.clone(), partNames, partNumbers).knowing(found.shells());
    }

    /**
     * The same in other parts.
     *
     * @param names of the parts, each of its own; a mesh without parts has one, of which the name is empty
     * @param perTriangle the number of its part for each triangle; empty if all belong to the first. Copied
     */
    public Triangles withParts(List<String> names, int[] perTriangle) {
        return new Triangles(places, corners, normals, map, colors, names, perTriangle.clone()).knowing(found.shells());
    }

    private Triangles knowing(@Nullable Shells known) {
        found.take(known);
        return this;
    }

    /** How many vertices there are. */
    public int vertexCount() {
        return places.length / 3;
    }

    /** How many triangles there are, at least one. */
    public int count() {
        return corners.length / 3;
    }

    /** The number of the vertex at a corner of a triangle: 0, 1 or 2. */
    public int corner(int triangle, int k) {
        return corners[3 * triangle + k];
    }

    public double x(int vertex) {
        return places[3 * vertex];
    }

    public double y(int vertex) {
        return places[3 * vertex + 1];
    }

    public double z(int vertex) {
        return places[3 * vertex + 2];
    }

    /** The place of a vertex. */
    public Vec3 place(int vertex) {
        return new Vec3(x(vertex), y(vertex), z(vertex));
    }

    public boolean hasNormals() {
        return normals.length > 0;
    }

    /** The normal of a vertex as it was given, of any length; {@link Vec3#ZERO} if none is known. */
    public Vec3 normal(int vertex) {
        return hasNormals() ? new Vec3(normals[3 * vertex], normals[3 * vertex + 1], normals[3 * vertex + 2]) : Vec3.ZERO;
    }

    public boolean hasMap() {
        return map.length > 0;
    }

    /** How far to the right in its picture a vertex lies; 0 if there is no map. */
    public float u(int vertex) {
        return hasMap() ? map[2 * vertex] : 0;
    }

    /** How far up in its picture a vertex lies; 0 if there is no map. */
    public float v(int vertex) {
        return hasMap() ? map[2 * vertex + 1] : 0;
    }

    public boolean hasColors() {
        return colors.length > 0;
    }

    /** What the colour of the material is multiplied by at a vertex, linear light; 1 1 1 if there are no colours. */
    public Vec3 color(int vertex) {
        return hasColors() ? new Vec3(colors[3 * vertex], colors[3 * vertex + 1], colors[3 * vertex + 2]) : Vec3.ONE;
    }

    /** The names of the parts, at least one; empty is the name of what has none. */
    public List<String> parts() {
        return partNames;
    }

    /** The number of the part that a triangle belongs to. */
    public int part(int triangle) {
        return partNumbers.length == 0 ? 0 : partNumbers[triangle];
    }

    /** The box around all vertices that triangles have. */
    public Bounds bounds() {
        return bounds;
    }

    /** How large all triangles are together, in square scene units. */
    public double area() {
        return Measures.area(places, corners);
    }

    /**
     * The space within, in cubic scene units, if it is {@linkplain #isClosed closed}: below 0 if it is inside out, and what is wound around
     * twice counts twice. By the divergence theorem, a sixth of the sum of a·(b × c).
     */
    public double volume() {
        return Measures.sixfoldVolume(places, corners, bounds) / 6;
    }

    /**
     * How many edges are open: those which, with all triangles turned as they best fit, are not passed in one direction as often as in the other. A
     * mesh without any has an inside.
     */
    public int openEdges() {
        return found.shells(this).openEdges();
    }

    /** Whether it has an inside: no {@linkplain #openEdges edge is open}. */
    public boolean isClosed() {
        return openEdges() == 0;
    }

    /**
     * The same with all triangles turned so that neighbours fit, and the inside is inside: a shell that was turned inside out in a file is put right,
     * unless it lies within another one, which it then makes hollow. Itself if there is nothing to do.
     */
    public Triangles oriented() {
        Shells known = found.shells(this);
        return known.isOriented() ? this : Moved.turned(this, known.turned()).knowing(new Shells(known.openEdges(), new BitSet(), known.rim()));
    }

    /**
     * The same with its seams closed: on {@linkplain #openEdges open edges}, places become one that are no further apart than a share of the diagonal of its box, as those
     * are that programs reckon twice and round. Vertices keep their normals and maps. Itself if no edge less is open then.
     *
     * @param share 0–1; 0 for places that are the very same
     */
    public Triangles sewn(double share) {
        return found.sewn(this, Require.within("weld", share, 0, 1)).mesh();
    }

    /** How many places {@link #sewn} moves to others next to them. */
    public int placesSewn(double share) {
        return found.sewn(this, share).places();
    }

    /** How many sides of triangles at open edges are so short that {@link #sewn} could make one place of their ends, and does not. */
    public int shortSides(double share) {
        return found.sewn(this, share).kept();
    }

    /**
     * The same with normals made anew, so that it looks smooth but for edges at which triangles are bent by more than an angle.
     *
     * @param angleDegrees 0–180
     */
    public Triangles smoothed(double angleDegrees) {
        return Smoothing.of(this, Require.within("smooth-angle", angleDegrees, 0, 180)).knowing(found.shells());
    }

    /** Only the triangles of one part, with all vertices they need. */
    public Triangles onlyPart(int part) {
        Objects.checkIndex(part, partNames.size());
        return Parted.only(this, part);
    }

    /** The same in another space: places and normals moved, turned and stretched; corners turned round if the map mirrors. */
    public Triangles transformed(Affine toOther) {
        return Moved.into(toOther, this);
    }

    /**
     * The lines that draw it as seen along a direction: its rim, its sharp edges, and those between what looks here and what looks away. Not all, if there are too many to be seen apart.
     *
     * @param rough for a mesh that is being turned, of which every picture is another one: many triangles are drawn as if they were few
     */
    public List<List<Vec3>> outline(Vec3 along, boolean rough) {
        Objects.requireNonNull(along, "along");
        Sketch sketch = found.sketch(this);
        return (rough ? sketch.rough() : sketch).lines(along);
    }

    /**
     * Made ready for rays, as {@code cz.paprsek.shape.Mesh} asks: the triangles go into a tree once, wherever they are placed.
     *
     * @param parts where its parts are registered, in their order
     */
    public Volume place(Affine toWorld, IntFunction<Parts> parts) {
        Facets known = found.facets(this, parts.apply(0)::isCancelled);
        Affine toLocal = toWorld.inverse();
        MeshPart[] placed = new MeshPart[partNames.size()];
        for (int i = 0; i < placed.length; i++) {
            placed[i] = parts.apply(i).add(number -> new MeshPart(number, this, known, toLocal));
        }
        return new PlacedMesh(this, known, toWorld, placed);
    }

    /** The raw numbers, for who meets rays with them; not to be changed. */
    double[] places() {
        return places;
    }

    int[] corners() {
        return corners;
    }

    float[] normals() {
        return normals;
    }

    float[] map() {
        return map;
    }

    float[] colors() {
        return colors;
    }

    int[] partNumbers() {
        return partNumbers;
    }

    /** Whether it has the same vertices and triangles, in the same order. */
    @Override
    public boolean equals(@Nullable Object other) {
        return this == other || (other instanceof Triangles o && Arrays.equals(corners, o.corners) && Arrays.equals(places, o.places)
                && Arrays.equals(normals, o.normals) && Arrays.equals(map, o.map) && Arrays.equals(colors, o.colors) && partNames.equals(o.partNames) && Arrays.equals(partNumbers, o.partNumbers));
    }

    /** By counts and size alone: there may be millions of vertices. */
    @Override
    public int hashCode() {
        return Objects.hash(places.length, corners.length, normals.length, map.length, bounds);
    }

    @Override
    public String toString() {
        return count() + " triangles";
    }

    /**
     * Makes {@link Triangles} vertex by vertex, in growing arrays that are handed over in the end. For one thread, and to be used once.
     * Numbers are checked by {@link #build}; who reads a file and wants to say where in it they are wrong checks them before.
     */
    public static final class Builder extends TriangleBuilder {
        Builder() {}

        @Override
        Builder self() {
            return this;
        }
    }
}
