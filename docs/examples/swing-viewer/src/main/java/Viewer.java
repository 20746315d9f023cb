import cz.paprsek.image.Image;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ForkJoinPool;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;

/** A window with the picture of a scene, which appears tile by tile. Closing it stops the render. */
public final class Viewer {
    private Viewer() {}

    public static void main(String[] args) throws IOException {
        if (args.length != 1) {
            System.err.println("usage: Viewer SCENE.xml");
            System.exit(2);
        }
        try {
            Scene scene = SceneFiles.read(Path.of(args[0]));
            SwingUtilities.invokeLater(() -> show(scene));
        } catch (SceneFileException wrong) {
            wrong.problems().forEach(System.err::println);
            System.exit(3);
        }
    }

    private static void show(Scene scene) {
        BufferedImage shown = new BufferedImage(scene.settings().width(), scene.settings().height(), BufferedImage.TYPE_INT_RGB);
        JPanel canvas = new JPanel() {
            @Override
            protected void paintComponent(Graphics graphics) {
                graphics.drawImage(shown, 0, 0, null);
            }
        };
        canvas.setPreferredSize(new Dimension(shown.getWidth(), shown.getHeight()));
        CompletableFuture<?> render = Renderer.start(RenderScene.of(scene), RenderOptions.of(scene), new RenderMonitor() {
            /** Told by the threads that trace; what is finished no longer changes. */
            @Override
            public void finished(Tile tile, Image image, int done, int total) {
                int[] pixels = new int[tile.width() * tile.height()];
                for (int y = 0; y < tile.height(); y++) {
                    for (int x = 0; x < tile.width(); x++) {
                        pixels[y * tile.width() + x] = image.argb(tile.x() + x, tile.y() + y);
                    }
                }
                SwingUtilities.invokeLater(() -> {
                    shown.setRGB(tile.x(), tile.y(), tile.width(), tile.height(), pixels, 0, tile.width());
                    canvas.repaint(tile.x(), tile.y(), tile.width(), tile.height());
                });
            }
        }, ForkJoinPool.commonPool());
        JFrame frame = new JFrame(scene.name());
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                render.cancel(true);
            }
        });
        frame.add(canvas);
        frame.pack();
        frame.setVisible(true);
    }
}
