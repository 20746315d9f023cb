package cz.paprsek.format;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.text.Numbers;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Objects;

/** Writes triangles as files that other programs read. */
public final class MeshWriter {
    private static final int HEAD = 80;
    private static final int RECORD = 50;

    private MeshWriter() {}

    /** As OBJ, with normals, places in pictures, colours and a group for each part; numbers read back as the very same. The stream is flushed, and not closed. */
    public static void obj(Triangles mesh, OutputStream stream) throws IOException {
        Objects.requireNonNull(mesh, "mesh");
        BufferedOutputStream out = new BufferedOutputStream(Objects.requireNonNull(stream, "stream"), 1 << 16);
        StringBuilder line = new StringBuilder("# written by Paprsek\n");
        for (int v = 0; v < mesh.vertexCount(); v++) {
            line.append("v ").append(Numbers.text(mesh.place(v))).append(mesh.hasColors() ? color(mesh.color(v)) : "").append('\n');
            if (mesh.hasMap()) {
                line.append("vt ").append(Numbers.text(mesh.u(v))).append(' ').append(Numbers.text(mesh.v(v))).append('\n');
            }
            if (mesh.hasNormals()) {
                line.append("vn ").append(Numbers.text(mesh.normal(v))).append('\n');
            }
            flush(line, out);
        }
        String between = mesh.hasMap() ? "/" : mesh.hasNormals() ? "//" : "";
        int part = -1;
        for (int t = 0; t < mesh.count(); t++) {
            if (mesh.part(t) != part) {
                part = mesh.part(t);
                String name = mesh.parts().get(part);
                line.append(name.isEmpty() && mesh.parts().size() == 1 ? "" : "g " + name + "\n");
            }
            line.append('f');
            for (int k = 0; k < 3; k++) {
                int number = mesh.corner(t, k) + 1;
                line.append(' ').append(number);
                if (mesh.hasMap()) {
                    line.append('/').append(number);
                }
                if (mesh.hasNormals()) {
                    line.append(mesh.hasMap() ? "/" : between).append(number);
                }
            }
            line.append('\n');
            flush(line, out);
        }
        out.flush();
    }

    /** sRGB, 0–1, as other programs expect it; white at most. */
    private static String color(Vec3 light) {
        StringBuilder text = new StringBuilder();
        for (double channel : new double[] {light.x(), light.y(), light.z()}) {
            text.append(' ').append(Numbers.text((float) (Rgb.encoded(Math.min(1, channel)) / 255)));
        }
        return text.toString();
    }

    private static void flush(StringBuilder text, OutputStream out) throws IOException {
        out.write(text.toString().getBytes(StandardCharsets.UTF_8));
        text.setLength(0);
    }

    /** As STL in bytes, whose numbers have seven digits. The stream is flushed, and not closed. */
    public static void stl(Triangles mesh, OutputStream stream) throws IOException {
        Objects.requireNonNull(mesh, "mesh");
        BufferedOutputStream out = new BufferedOutputStream(Objects.requireNonNull(stream, "stream"), 1 << 16);
        ByteBuffer record = ByteBuffer.allocate(HEAD + Integer.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        record.put("written by Paprsek".getBytes(StandardCharsets.US_ASCII)).position(HEAD);
        record.putInt(mesh.count());
        out.write(record.array());
        for (int t = 0; t < mesh.count(); t++) {
            record.clear();
            record.putFloat(0).putFloat(0).putFloat(0);
            for (int k = 0; k < 3; k++) {
                int v = mesh.corner(t, k);
                record.putFloat((float) mesh.x(v)).putFloat((float) mesh.y(v)).putFloat((float) mesh.z(v));
            }
            record.putShort((short) 0);
            out.write(record.array(), 0, RECORD);
        }
        out.flush();
    }
}
