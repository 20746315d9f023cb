package cz.paprsek.shape.mesh;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.tree.Search;

/**
 * A mesh in the world. What is inside of a closed one is what it is wound around more often in one direction than in the other: where shells
 * overlap they are one body, and their inner walls are none. An open one is a surface without an inside.
 */
final class PlacedMesh extends Volume {
    private final Triangles mesh;
    private final Facets facets;
    private final Affine toLocal;
    private final Bounds bounds;
    private final boolean closed;
    /** The numbers of the parts, one for each of the mesh's, in their order. */
    private final MeshPart[] parts;

    PlacedMesh(Triangles mesh, Facets facets, Affine toWorld, MeshPart[] parts) {
        this.mesh = mesh;
        this.facets = facets;
        this.toLocal = toWorld.inverse();
        this.bounds = mesh.bounds().transformed(toWorld);
        this.closed = mesh.isClosed();
        this.parts = parts;
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    @Override
    public double cost() {
        return 20;
    }

    /** Whether the ray starts from this mesh. */
    private boolean isLeftBy(Ray ray) {
        return ray.left >= parts[0].number && ray.left <= parts[parts.length - 1].number;
    }

    private int part(int triangle) {
        return parts[mesh.part(triangle)].number;
    }

    private MeshSearch search(Ray ray) {
        Search<Ray> known = ray.search;
        if (known instanceof MeshSearch search) {
            return search;
        }
        MeshSearch search = new MeshSearch(facets);
        ray.search = search;
        return search;
    }

    /**
     * The nearest triangle, where that is known to be the nearest boundary. Who comes from outside enters through it. Who starts inwards from the surface
     * is wound around once, and leaves through it; who starts outwards can only enter, whatever a bent normal had light go into the body.
     * In all other cases it is counted how often the mesh is wound around where the ray goes.
     */
    @Override
    public void nearest(Ray ray) {
        MeshSearch search = search(ray);
        if (!search.start(facets, toLocal, ray)) {
            return;
        }
        boolean own = isLeftBy(ray);
        if (!closed) {
            if (search.nearest(ray, ray.min, ray.reach, MeshSearch.BOTH, ray.contact, own ? MeshSearch.BOTH : 0)) {
                accept(ray, search, own);
            }
            return;
        }
        int sides = own && !ray.inwards ? MeshSearch.FRONT : MeshSearch.BOTH;
        int passed = own ? ray.inwards ? MeshSearch.FRONT : MeshSearch.BACK : 0;
        if (search.nearest(ray, ray.min, ray.reach, sides, ray.contact, passed)) {
            if (search.nearestIsFront() == (own && ray.inwards)) {
                super.nearest(ray);
            } else {
                accept(ray, search, own);
            }
        }
    }

    private void accept(Ray ray, MeshSearch search, boolean own) {
        ray.accept(own ? Math.max(0, search.nearestT()) : search.nearestT(), part(search.nearestNumber()), search.nearestNumber());
        ray.hint = search.nearestPlace();
    }

    @Override
    public boolean occludes(Ray ray) {
        MeshSearch search = search(ray);
        int sides = closed && isLeftBy(ray) && !ray.inwards ? MeshSearch.FRONT : MeshSearch.BOTH;
        return search.start(facets, toLocal, ray) && search.any(ray, ray.contact, ray.max, sides);
    }

    @Override
    public void crossings(Ray ray, Spans out) {
        if (closed) {
            super.crossings(ray, out);
            return;
        }
        MeshSearch search = search(ray);
        if (search.start(facets, toLocal, ray)) {
            search.gather(ray, ray.min, ray.max, ray.contact, isLeftBy(ray) ? MeshSearch.BOTH : 0);
            for (int i = 0; i < search.size(); i++) {
                out.add(search.t(i), part(search.number(i)), search.number(i));
            }
        }
    }

    /** Counts windings from the beginning of the line. Beyond where the ray reaches nobody looks: a stretch that goes on there is left open. */
    @Override
    public void spans(Ray ray, Spans out) {
        MeshSearch search = search(ray);
        if (!closed || !search.start(facets, toLocal, ray)) {
            return;
        }
        search.gather(ray, Double.NEGATIVE_INFINITY, ray.reach, 0, 0);
        int mark = out.size();
        int windings = 0;
        for (int i = 0; i < search.size(); i++) {
            boolean wasInside = windings > 0;
            windings += search.isFront(i) ? 1 : -1;
            if (wasInside != windings > 0) {
                out.add(search.t(i), part(search.number(i)), search.number(i));
            }
        }
        if (windings > 0) {
            out.add(Double.POSITIVE_INFINITY, out.part(out.size() - 1), out.face(out.size() - 1));
        }
        if (isLeftBy(ray)) {
            out.leaveFrom(mark, ray.inwards);
        }
    }
}
