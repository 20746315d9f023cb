package cz.paprsek.fx;

import cz.paprsek.fx.view.look.Theme;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import javafx.application.Platform;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.robot.Robot;
import javafx.stage.Stage;

/**
 * Drives a window as a person does: mouse and keys through JavaFX's own robot, also without a display. Every step is an event of its own
 * on JavaFX's thread, and ends when the window has been laid out anew.
 */
public final class Gui implements AutoCloseable {
    /** On a machine with other work to do; only what never comes takes so long. */
    private static final long PATIENCE_SECONDS = 60;

    private final Stage stage;
    private final Robot robot;

    private Gui(Stage stage, Robot robot) {
        this.stage = stage;
        this.robot = robot;
    }

    /** Shows a node in a window of the given size, in pixels, in the light theme. */
    public static Gui show(Callable<? extends Parent> content, double width, double height) {
        return open(() -> {
            Stage stage = new Stage();
            stage.setScene(new Scene(content.call(), width, height));
            Theme.LIGHT.applyTo(stage.getScene());
            return stage;
        });
    }

    /** Shows a window at the top left of the screen. */
    public static Gui open(Callable<Stage> window) {
        startToolkit();
        Gui gui = on(() -> {
            Stage stage = window.call();
            stage.setX(0);
            stage.setY(0);
            stage.show();
            stage.requestFocus();
            return new Gui(stage, new Robot());
        });
        gui.pulse();
        return gui;
    }

    /** Computes something on JavaFX's thread; what it throws is thrown here. */
    public static <T> T on(Callable<T> work) {
        startToolkit();
        CompletableFuture<T> result = new CompletableFuture<>();
        Runnable now = () -> {
            try {
                result.complete(work.call());
            } catch (Throwable e) {
                result.completeExceptionally(e);
            }
        };
        if (Platform.isFxApplicationThread()) {
            // What is waited for on JavaFX's thread would wait for itself.
            now.run();
        } else {
            Platform.runLater(now);
        }
        return await(result);
    }

    /** Does something on JavaFX's thread and waits for the window to be laid out. */
    public void act(Runnable work) {
        on(() -> {
            work.run();
            return true;
        });
        pulse();
    }

    /** Waits until something holds on JavaFX's thread; fails, naming it, if it never does. */
    public void until(String what, BooleanSupplier condition) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!on(condition::getAsBoolean)) {
            if (System.nanoTime() > end) {
                throw new AssertionError("this never came to be: " + what);
            }
            pulse();
        }
        // What has just appeared is laid out before anybody clicks on it.
        pulse();
    }

    public Stage stage() {
        return stage;
    }

    /** The one visible node that a CSS selector finds in the window. */
    public Node node(String selector) {
        return on(() -> stage.getScene().getRoot().lookupAll(selector).stream().filter(Gui::isShown).findFirst()
                .orElseThrow(() -> new AssertionError("the window shows no " + selector)));
    }

    public void click(String selector) {
        click(node(selector));
    }

    public void click(Node node) {
        Point2D centre = on(() -> centre(node));
        moveTo(node, centre.getX(), centre.getY());
        press(MouseButton.PRIMARY);
        release(MouseButton.PRIMARY);
    }

    /** Clicks a point of a node, in its own coordinates. */
    public void click(Node node, double x, double y) {
        moveTo(node, x, y);
        press(MouseButton.PRIMARY);
        release(MouseButton.PRIMARY);
    }

    /** Presses at one point of a node, moves to another in steps, and releases there. */
    public void drag(Node node, double x0, double y0, double x1, double y1) {
        moveTo(node, x0, y0);
        press(MouseButton.PRIMARY);
        for (int i = 1; i <= 4; i++) {
            moveTo(node, x0 + (x1 - x0) * i / 4, y0 + (y1 - y0) * i / 4);
        }
        release(MouseButton.PRIMARY);
    }

    public void moveTo(Node node, double x, double y) {
        act(() -> {
            Point2D screen = node.localToScreen(x, y);
            robot.mouseMove(screen);
        });
    }

    public void press(MouseButton button) {
        act(() -> robot.mousePress(button));
    }

    public void release(MouseButton button) {
        act(() -> robot.mouseRelease(button));
    }

    /** Turns the wheel; positive is towards the user. */
    public void wheel(int notches) {
        act(() -> robot.mouseWheel(notches));
    }

    /** Presses keys in the given order and releases them in the opposite one, as for Ctrl+Z. */
    public void keys(KeyCode... keys) {
        for (KeyCode key : keys) {
            hold(key);
        }
        for (int i = keys.length - 1; i >= 0; i--) {
            letGo(keys[i]);
        }
    }

    public void hold(KeyCode key) {
        act(() -> robot.keyPress(key));
    }

    public void letGo(KeyCode key) {
        act(() -> robot.keyRelease(key));
    }

    /** Waits until the window has been laid out and drawn once more. */
    public void pulse() {
        CompletableFuture<Boolean> laidOut = new CompletableFuture<>();
        Platform.runLater(() -> {
            Scene scene = stage.getScene();
            if (scene == null || !stage.isShowing()) {
                laidOut.complete(true);
                return;
            }
            Runnable[] listener = new Runnable[1];
            listener[0] = () -> {
                scene.removePostLayoutPulseListener(listener[0]);
                laidOut.complete(true);
            };
            scene.addPostLayoutPulseListener(listener[0]);
            Platform.requestNextPulse();
        });
        await(laidOut);
    }

    @Override
    public void close() {
        on(() -> {
            stage.close();
            return true;
        });
    }

    private static boolean isShown(Node node) {
        for (Node n = node; n != null; n = n.getParent()) {
            if (!n.isVisible()) {
                return false;
            }
        }
        return true;
    }

    private static Point2D centre(Node node) {
        return new Point2D(
                (node.getLayoutBounds().getMinX() + node.getLayoutBounds().getMaxX()) / 2,
                (node.getLayoutBounds().getMinY() + node.getLayoutBounds().getMaxY()) / 2);
    }

    private static void startToolkit() {
        Toolkit.start();
    }

    /** Not in the class below: JavaFX's thread would wait there for the very initialisation that waits for it. */
    private static void startup() {
        CompletableFuture<Boolean> started = new CompletableFuture<>();
        Platform.startup(() -> started.complete(true));
        Platform.setImplicitExit(false);
        await(started);
    }

    private static <T> T await(CompletableFuture<T> result) {
        try {
            return result.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw new AssertionError("failed on JavaFX's thread", e.getCause());
        } catch (InterruptedException | TimeoutException e) {
            throw new AssertionError("JavaFX's thread gave no answer", e);
        }
    }

    /** Starts JavaFX when it is first needed; a class is initialised once. */
    private static final class Toolkit {
        static {
            startup();
        }

        static void start() {}
    }
}
