import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Executors;

/** Takes a scene file by POST at /thumbnail, and answers with a small PNG; or with status 400 and what is wrong with the file, line by line. On this machine only. */
public final class ThumbnailServer {
    private static final int WIDTH = 160;
    private static final int LARGEST = 1 << 20;

    private ThumbnailServer() {}

    public static void main(String[] args) throws IOException {
        HttpServer server = start(args.length == 0 ? 8080 : Integer.parseInt(args[0]));
        System.out.println("curl --data-binary @scene.xml http://localhost:" + server.getAddress().getPort() + "/thumbnail > scene.png");
    }

    /** @param port 0 for any that is free */
    static HttpServer start(int port) throws IOException {
        HttpServer server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 0);
        server.createContext("/thumbnail", ThumbnailServer::answer);
        // Each picture takes all processors: one after the other.
        server.setExecutor(Executors.newSingleThreadExecutor());
        server.start();
        return server;
    }

    private static void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            byte[] file = exchange.getRequestBody().readNBytes(LARGEST + 1);
            if (file.length > LARGEST) {
                send(exchange, 413, "text/plain", ("a scene may have " + LARGEST + " bytes here\n").getBytes(StandardCharsets.UTF_8));
                return;
            }
            try {
                send(exchange, 200, "image/png", thumbnail(SceneFiles.parse(new String(file, StandardCharsets.UTF_8))));
            } catch (SceneFileException | UncheckedIOException | IllegalArgumentException wrong) {
                // Not valid; names files, which nobody has sent along; or is too large.
                send(exchange, 400, "text/plain; charset=utf-8", (wrong.getMessage() + "\n").getBytes(StandardCharsets.UTF_8));
            }
        }
    }

    private static byte[] thumbnail(Scene scene) throws IOException {
        int height = Math.max(1, WIDTH * scene.settings().height() / scene.settings().width());
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageFiles.write(Renderer.render(scene.withSettings(scene.settings().withSize(WIDTH, height))), png, ImageFormat.PNG);
        return png.toByteArray();
    }

    private static void send(HttpExchange exchange, int status, String type, byte[] body) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", type);
        exchange.sendResponseHeaders(status, body.length);
        exchange.getResponseBody().write(body);
    }
}
