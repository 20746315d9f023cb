package cz.paprsek.fx.view.shell;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.WeakChangeListener;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.control.ButtonBase;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import org.jspecify.annotations.Nullable;

/**
 * In which order the keyboard goes through the regions of a window: Tab leads on at the end of one, F6 at once, to where one was last. Sees to
 * it that the keyboard is never by accident on something that acts: where what had it is gone, it goes home.
 */
public final class FocusOrder {
    private final List<Supplier<Node>> regions;
    private final Runnable home;
    private final Map<Node, Node> last = new LinkedHashMap<>();
    /** Held here, and so by the root, for the scene, which outlives the root, holds it weakly. */
    private ChangeListener<Node> onFocus = (focus, was, is) -> {};

    /**
     * @param regions in order; asked anew each time, as another node may have taken the place of one
     * @param home gives the keyboard to where it is at home
     */
    public FocusOrder(List<Supplier<Node>> regions, Runnable home) {
        this.regions = List.copyOf(regions);
        this.home = home;
    }

    /** Makes the keys work in a node and all within it. */
    public void reach(Parent root) {
        root.addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
        root.sceneProperty().addListener((property, old, now) -> {
            if (now != null) {
                onFocus = (focus, was, is) -> moved(now, was, is);
                now.focusOwnerProperty().addListener(new WeakChangeListener<>(onFocus));
            }
        });
    }

    private void moved(Scene scene, @Nullable Node was, @Nullable Node is) {
        if (is == null) {
            return;
        }
        boolean isLost = was == null || was.getScene() != scene || !isSeen(was);
        if (isLost && (is instanceof ButtonBase || is instanceof AddPalette)) {
            home.run();
            return;
        }
        now().stream().filter(region -> isWithin(region, is)).forEach(region -> last.put(region, is));
    }

    private void pressed(KeyEvent event) {
        boolean isTab = event.getCode() == KeyCode.TAB && !event.isShortcutDown() && !event.isAltDown();
        boolean isF6 = event.getCode() == KeyCode.F6 && !event.isShortcutDown() && !event.isAltDown();
        if ((!isTab && !isF6) || !(event.getTarget() instanceof Node at)) {
            return;
        }
        List<Node> order = now();
        last.keySet().retainAll(order);
        Optional<Node> region = order.stream().filter(each -> isWithin(each, at)).findFirst();
        if (isTab && region.isPresent()) {
            List<Node> stops = stops(region.get());
            int edge = event.isShiftDown() ? 0 : stops.size() - 1;
            if (stops.isEmpty() || stops.indexOf(at) != edge) {
                return;
            }
        } else if (isTab) {
            return;
        }
        next(order, region, event.isShiftDown() ? -1 : 1, isF6).ifPresent(Node::requestFocus);
        event.consume();
    }

    private Optional<Node> next(List<Node> order, Optional<Node> from, int step, boolean isF6) {
        int start = from.map(order::indexOf).orElse(step > 0 ? -1 : order.size());
        for (int i = 1; i <= order.size(); i++) {
            Node region = order.get(Math.floorMod(start + step * i, order.size()));
            List<Node> stops = stops(region);
            if (!stops.isEmpty()) {
                Node first = stops.get(step > 0 || isF6 ? 0 : stops.size() - 1);
                Node before = last.getOrDefault(region, first);
                return Optional.of(isF6 && stops.contains(before) ? before : first);
            }
        }
        return Optional.empty();
    }

    private List<Node> now() {
        return regions.stream().map(Supplier::get).toList();
    }

    /** What the keyboard stops at within a node, in order. */
    private static List<Node> stops(Node node) {
        List<Node> found = new ArrayList<>();
        collect(node, found);
        return found;
    }

    private static void collect(Node node, List<Node> found) {
        if (!node.isVisible() || node.isDisabled()) {
            return;
        }
        if (node.isFocusTraversable()) {
            found.add(node);
        }
        if (node instanceof Parent parent) {
            parent.getChildrenUnmodifiable().forEach(child -> collect(child, found));
        }
    }

    private static boolean isSeen(Node node) {
        return node.isVisible() && !node.isDisabled() && (node.getParent() == null || isSeen(node.getParent()));
    }

    private static boolean isWithin(Node region, Node node) {
        for (Node at = node; at != null; at = at.getParent()) {
            if (at == region) {
                return true;
            }
        }
        return false;
    }
}
