package cz.paprsek.format;

import cz.paprsek.shape.mesh.Triangles;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/** Bodies as triangles, and as files of several formats. */
final class Solids {
    private Solids() {}

    /** The block from 0 to (x, y, z). */
    static Triangles block(double x, double y, double z) {
        double[] places = new double[24];
        for (int i = 0; i < 8; i++) {
            places[3 * i] = (i & 1) * x;
            places[3 * i + 1] = (i >> 1 & 1) * y;
            places[3 * i + 2] = (i >> 2) * z;
        }
        return Triangles.of(places, new int[] {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5});
    }

    /** A ring about z, of so many steps each way. */
    static Triangles torus(double major, double minor, int steps, int sides) {
        Triangles.Builder builder = Triangles.builder();
        for (int i = 0; i < steps; i++) {
            for (int j = 0; j < sides; j++) {
                double a = 2 * Math.PI * i / steps;
                double b = 2 * Math.PI * j / sides;
                double r = major + minor * StrictMath.cos(b);
                builder.vertex(r * StrictMath.cos(a), r * StrictMath.sin(a), minor * StrictMath.sin(b));
            }
        }
        for (int i = 0; i < steps; i++) {
            for (int j = 0; j < sides; j++) {
                int a = i * sides + j;
                int b = (i + 1) % steps * sides + j;
                int c = (i + 1) % steps * sides + (j + 1) % sides;
                int d = i * sides + (j + 1) % sides;
                builder.triangle(a, b, c);
                builder.triangle(a, c, d);
            }
        }
        return builder.build();
    }

    static String stlText(Triangles mesh) {
        StringBuilder text = new StringBuilder("solid a body\n");
        for (int t = 0; t < mesh.count(); t++) {
            text.append(" facet normal 0 0 0\n  outer loop\n");
            for (int k = 0; k < 3; k++) {
                int v = mesh.corner(t, k);
                text.append(String.format(Locale.ROOT, "   vertex %e %e %e%n", mesh.x(v), mesh.y(v), mesh.z(v)));
            }
            text.append("  endloop\n endfacet\n");
        }
        return text.append("endsolid a body\n").toString();
    }

    static byte[] stlBytes(Triangles mesh, String head) {
        ByteBuffer bytes = ByteBuffer.allocate(84 + 50 * mesh.count()).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(head.getBytes(StandardCharsets.US_ASCII)).position(80);
        bytes.putInt(mesh.count());
        for (int t = 0; t < mesh.count(); t++) {
            bytes.putFloat(0).putFloat(0).putFloat(1);
            for (int k = 0; k < 3; k++) {
                int v = mesh.corner(t, k);
                bytes.putFloat((float) mesh.x(v)).putFloat((float) mesh.y(v)).putFloat((float) mesh.z(v));
            }
            bytes.putShort((short) 0);
        }
        return bytes.array();
    }

    static String obj(Triangles mesh) {
        StringBuilder text = new StringBuilder();
        for (int v = 0; v < mesh.vertexCount(); v++) {
            text.append("v ").append(mesh.x(v)).append(' ').append(mesh.y(v)).append(' ').append(mesh.z(v)).append('\n');
        }
        for (int t = 0; t < mesh.count(); t++) {
            text.append("f ").append(mesh.corner(t, 0) + 1).append(' ').append(mesh.corner(t, 1) + 1).append(' ').append(mesh.corner(t, 2) + 1).append('\n');
        }
        return text.toString();
    }

    static String off(Triangles mesh) {
        StringBuilder text = new StringBuilder("OFF # made by a test\n" + mesh.vertexCount() + ' ' + mesh.count() + " 0\n");
        for (int v = 0; v < mesh.vertexCount(); v++) {
            text.append(mesh.x(v)).append(' ').append(mesh.y(v)).append(' ').append(mesh.z(v)).append('\n');
        }
        for (int t = 0; t < mesh.count(); t++) {
            text.append("3 ").append(mesh.corner(t, 0)).append(' ').append(mesh.corner(t, 1)).append(' ').append(mesh.corner(t, 2)).append("  255 128 0 # orange\n");
        }
        return text.toString();
    }

    /** @param order of the bytes; null for text */
    static byte[] ply(Triangles mesh, @Nullable ByteOrder order) {
        String head = "ply\nformat " + (order == null ? "ascii" : order == ByteOrder.BIG_ENDIAN ? "binary_big_endian" : "binary_little_endian")
                + " 1.0\ncomment made by a test\nelement vertex " + mesh.vertexCount() + "\nproperty uchar flag\nproperty double z\nproperty float x\nproperty double y\nelement face "
                + mesh.count() + "\nproperty float weight\nproperty list uchar int vertex_indices\nproperty list ushort short more\nend_header\n";
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(head.getBytes(StandardCharsets.US_ASCII));
        ByteBuffer bytes = ByteBuffer.allocate(64).order(order == null ? ByteOrder.BIG_ENDIAN : order);
        for (int v = 0; v < mesh.vertexCount(); v++) {
            if (order == null) {
                out.writeBytes(("7 " + mesh.z(v) + " " + mesh.x(v) + " " + mesh.y(v) + "\n").getBytes(StandardCharsets.US_ASCII));
            } else {
                bytes.clear().put((byte) 7).putDouble(mesh.z(v)).putFloat((float) mesh.x(v)).putDouble(mesh.y(v));
                out.write(bytes.array(), 0, bytes.position());
            }
        }
        for (int t = 0; t < mesh.count(); t++) {
            if (order == null) {
                out.writeBytes(("0.5 3 " + mesh.corner(t, 0) + " " + mesh.corner(t, 1) + " " + mesh.corner(t, 2) + " 2 -1 -2\n").getBytes(StandardCharsets.US_ASCII));
            } else {
                bytes.clear().putFloat(0.5f).put((byte) 3).putInt(mesh.corner(t, 0)).putInt(mesh.corner(t, 1)).putInt(mesh.corner(t, 2));
                bytes.putShort((short) 2).putShort((short) -1).putShort((short) -2);
                out.write(bytes.array(), 0, bytes.position());
            }
        }
        return out.toByteArray();
    }
}
