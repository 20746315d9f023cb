package cz.paprsek.fx.view.shell;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.geometry.Orientation;
import javafx.scene.Node;
import javafx.scene.control.SplitPane;
import javafx.scene.layout.StackPane;

/** Four views, two by two with dividers to drag; each can be made to fill the whole. */
public final class PaneGrid extends StackPane {
    private final List<TitledView> views;
    private final SplitPane upper = new SplitPane();
    private final SplitPane lower = new SplitPane();
    private final SplitPane whole = new SplitPane(upper, lower);
    private final ReadOnlyObjectWrapper<Optional<TitledView>> maximized = new ReadOnlyObjectWrapper<>(Optional.empty());

    /** @param views top left, top right, bottom left, bottom right */
    public PaneGrid(List<TitledView> views) {
        this.views = new ArrayList<>(views);
        setId("pane-grid");
        whole.setOrientation(Orientation.VERTICAL);
        whole.setDividerPositions(0.5);
        upper.setDividerPositions(0.5);
        lower.setDividerPositions(0.5);
        // Both rows are divided at the same place, as one cross.
        upper.getItems().setAll(this.views.get(0), this.views.get(1));
        lower.getItems().setAll(this.views.get(2), this.views.get(3));
        upper.getDividers().get(0).positionProperty().bindBidirectional(lower.getDividers().get(0).positionProperty());
        for (TitledView view : this.views) {
            view.setOnMaximize(() -> toggle(view));
        }
        getChildren().add(whole);
    }

    /** Puts a view in the place of another, which is not seen any more. */
    public void replace(TitledView old, TitledView fresh) {
        if (maximized.get().isPresent()) {
            toggle(maximized.get().get());
        }
        SplitPane home = home(old);
        int place = place(old);
        double divider = upper.getDividerPositions()[0];
        views.set(views.indexOf(old), fresh);
        fresh.setOnMaximize(() -> toggle(fresh));
        home.getItems().set(place, fresh);
        upper.setDividerPositions(divider);
        fresh.focusContent();
    }

    /** The view that fills the whole; empty if all four are shown. */
    public ReadOnlyObjectProperty<Optional<TitledView>> maximizedProperty() {
        return maximized.getReadOnlyProperty();
    }

    /** Makes a view fill the whole, or shows all four again if it did. */
    public void toggle(TitledView view) {
        boolean restore = maximized.get().filter(view::equals).isPresent();
        maximized.get().ifPresent(this::putBack);
        if (restore) {
            maximized.set(Optional.empty());
            whole.setVisible(true);
        } else {
            home(view).getItems().set(place(view), new StackPane());
            getChildren().add(view);
            whole.setVisible(false);
            maximized.set(Optional.of(view));
        }
        view.setMaximized(!restore);
        view.focusContent();
    }

    private void putBack(TitledView view) {
        getChildren().remove(view);
        double divider = upper.getDividerPositions()[0];
        home(view).getItems().set(place(view), view);
        upper.setDividerPositions(divider);
        view.setMaximized(false);
    }

    private SplitPane home(Node view) {
        return views.indexOf(view) < 2 ? upper : lower;
    }

    private int place(Node view) {
        return views.indexOf(view) % 2;
    }
}
