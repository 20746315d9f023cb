package cz.paprsek.shape.mesh;

import java.lang.ref.SoftReference;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;

/** What has been found out about a mesh: each looked for when it is first asked for, and always the same. */
final class Findings {
    private volatile @Nullable Shells shells;
    /** What it was last sewn to, and with which share of its diagonal. */
    private @Nullable Sewn sewn;
    private double sewnWith;
    /** Made when the mesh is first placed. */
    private @Nullable Facets facets;
    /** Made when it is first drawn, and kept while there is memory. */
    private SoftReference<Sketch> sketch = new SoftReference<>(null);

    /** What is known of the edges so far. */
    @Nullable Shells shells() {
        return shells;
    }

    /** What is known of the edges of a mesh of the same triangles, which is true of this one if none of them was to be turned. */
    void take(@Nullable Shells known) {
        shells = known != null && known.isOriented() ? known : null;
    }

    Shells shells(Triangles mesh) {
        Shells known = shells;
        if (known == null) {
            known = Shells.of(mesh.places(), mesh.corners(), mesh.bounds());
            shells = known;
        }
        return known;
    }

    synchronized Sewn sewn(Triangles mesh, double share) {
        Sewn known = sewn;
        if (known == null || sewnWith != share) {
            known = Seams.sewn(mesh, shells(mesh), share);
            sewn = known;
            sewnWith = share;
        }
        return known;
    }

    synchronized Facets facets(Triangles mesh, BooleanSupplier stop) {
        Facets known = facets;
        if (known == null) {
            known = new Facets(mesh, stop);
            facets = known;
        }
        return known;
    }

    synchronized Sketch sketch(Triangles mesh) {
        Sketch known = sketch.get();
        if (known == null) {
            known = Sketch.of(mesh);
            sketch = new SoftReference<>(known);
        }
        return known;
    }
}
