package cz.paprsek.render.glow;

import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Search;
import cz.paprsek.tree.Tree;

/** Lights that are seen, so many that they are looked for in a tree; with scratch of one worker. */
final class ManyGlows extends Glows {
    private final Tree tree;
    private final Finder finder;

    ManyGlows(Glows same, GlowTree tree) {
        super(same);
        this.tree = tree.tree;
        this.finder = new Finder(tree.ordered, same.firstPart);
    }

    @Override
    public void nearest(Ray ray) {
        tree.nearest(finder, ray, tree.whole(), ray.reach);
    }

    @Override
    public boolean occludes(Ray ray, int lamp) {
        finder.lamp = lamp;
        return tree.any(finder, ray, tree.whole());
    }

    private static final class Finder extends Search<Ray> {
        private final Glow[] ordered;
        private final int firstPart;
        private int lamp;
        private double back;

        Finder(Glow[] ordered, int firstPart) {
            this.ordered = ordered;
            this.firstPart = firstPart;
        }

        @Override
        protected void aim(Ray ray) {
            ray.needReciprocals();
            // Trees measure from where a line starts, and know nothing of what lies behind.
            back = ray.min < 0 ? ray.min : 0;
            along(ray.ox + back * ray.dx, ray.oy + back * ray.dy, ray.oz + back * ray.dz, ray.rx, ray.ry, ray.rz, ray.min - back, ray.reach - back);
        }

        @Override
        protected double meet(Ray ray, int first, int end) {
            for (int i = first; i < end; i++) {
                ordered[i].nearest(ray, firstPart);
            }
            return ray.max + ray.touch(ray.max) - back;
        }

        @Override
        protected boolean stopsAt(Ray ray, int first, int end) {
            for (int i = first; i < end; i++) {
                if (ordered[i].lamp != lamp && ordered[i].surface.occludes(ray)) {
                    return true;
                }
            }
            return false;
        }
    }
}
