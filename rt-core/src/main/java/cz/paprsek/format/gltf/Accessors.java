package cz.paprsek.format.gltf;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Map;

/** The numbers in the bytes: vertices, normals, indices. Nothing is allocated for numbers that have no bytes, but zeros, of which there may be so many. */
final class Accessors {
    /** How many numbers may be without bytes: they would cost nothing in a file, and much in memory. */
    private static final long MOST_ZEROS = 50_000_000;
    private static final Map<String, Integer> WIDTHS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4, "MAT4", 16);

    private final Tree document;
    private final Buffers buffers;

    Accessors(Tree document, Buffers buffers) {
        this.document = document;
        this.buffers = buffers;
    }

    /** The kinds of numbers, by their codes. */
    private enum Kind {
        BYTE(5120, 1), UNSIGNED_BYTE(5121, 1), SHORT(5122, 2), UNSIGNED_SHORT(5123, 2), UNSIGNED_INT(5125, 4), FLOAT(5126, 4);

        private final int code;
        private final int bytes;

        Kind(int code, int bytes) {
            this.code = code;
            this.bytes = bytes;
        }

        static Kind of(Tree accessor) throws FormatFault {
            int code = accessor.needed("componentType");
            for (Kind kind : values()) {
                if (kind.code == code) {
                    return kind;
                }
            }
            throw accessor.fault("componentType", "there is no type " + code);
        }

        double value(ByteBuffer bytes, int at, boolean isNormalized) {
            double raw = switch (this) {
                case BYTE -> bytes.get(at);
                case UNSIGNED_BYTE -> bytes.get(at) & 0xFF;
                case SHORT -> bytes.getShort(at);
                case UNSIGNED_SHORT -> bytes.getShort(at) & 0xFFFF;
                case UNSIGNED_INT -> bytes.getInt(at) & 0xFFFFFFFFL;
                case FLOAT -> bytes.getFloat(at);
            };
            return !isNormalized ? raw : switch (this) {
                case BYTE -> Math.max(-1, raw / 127);
                case UNSIGNED_BYTE -> raw / 255;
                case SHORT -> Math.max(-1, raw / 32767);
                case UNSIGNED_SHORT -> raw / 65535;
                case UNSIGNED_INT, FLOAT -> raw;
            };
        }
    }

    /** How many elements there are. */
    int count(int index) throws FormatFault {
        return document.item("accessors", index).needed("count");
    }

    /** All numbers of an accessor, which must be finite. */
    float[] floats(int index, String type) throws IOException {
        Tree accessor = document.item("accessors", index);
        int width = width(accessor, type);
        Kind kind = Kind.of(accessor);
        int count = accessor.needed("count");
        boolean isNormalized = accessor.flag("normalized");
        ByteBuffer bytes = elements(accessor, kind.bytes * width);
        int step = step(accessor, kind.bytes * width);
        float[] values = new float[Math.multiplyExact(count, width)];
        for (int i = 0; i < count && bytes.capacity() > 0; i++) {
            for (int k = 0; k < width; k++) {
                values[i * width + k] = (float) kind.value(bytes, i * step + k * kind.bytes, isNormalized);
            }
        }
        overwrite(accessor, kind, width, values);
        for (int i = 0; i < values.length; i++) {
            if (!(Math.abs(values[i]) <= Float.MAX_VALUE)) {
                throw accessor.fault("number " + i % width + " of element " + i / width + " must be finite, but is " + values[i]);
            }
        }
        return values;
    }

    /** How many numbers reading all of it takes. */
    long size(int index) throws FormatFault {
        return count(index) * (long) WIDTHS.getOrDefault(document.item("accessors", index).text("type", ""), 1);
    }

    /**
     * Whether all numbers can be read, and are within the limits that the document says.
     *
     * @param most how many numbers may be read for that; of more it is not looked at each
     * @return how many were
     */
    long check(int index, long most) throws IOException {
        Tree accessor = document.item("accessors", index);
        String type = accessor.text("type", "");
        Kind kind = Kind.of(accessor);
        if (accessor.has("sparse") && accessor.childOrNothing("sparse").needed("count") > accessor.needed("count")) {
            throw accessor.fault("sparse", "there are more elements here than the " + accessor.needed("count") + " of all");
        }
        if (accessor.flag("normalized") && (kind == Kind.FLOAT || kind == Kind.UNSIGNED_INT)) {
            throw accessor.fault("normalized", "this is for whole numbers of one or two bytes");
        }
        aligned(accessor, kind);
        if (!WIDTHS.containsKey(type) || (accessor.has("bufferView") && !fits(accessor, kind, type))) {
            return 0;
        }
        int width = width(accessor, type);
        boolean isNothing = !accessor.has("bufferView") && !accessor.has("sparse");
        long size = isNothing ? width : size(index);
        if (size > most) {
            return 0;
        }
        // What has no bytes is zeros, of which one element tells as much as all.
        float[] values = isNothing ? new float[width] : floats(index, type);
        double[] min = accessor.has("min") ? accessor.numbers("min", new double[width]) : new double[0];
        double[] max = accessor.has("max") ? accessor.numbers("max", new double[width]) : new double[0];
        for (int i = 0; i < values.length && !accessor.flag("normalized"); i++) {
            int k = i % width;
            if ((min.length > 0 && values[i] < (float) min[k]) || (max.length > 0 && values[i] > (float) max[k])) {
                throw accessor.fault("number " + k + " of element " + i / width + " is " + Numbers.text(Double.parseDouble(Float.toString(values[i]))) + ", which is beyond what \"min\" and \"max\" say");
            }
        }
        return size;
    }

    /** Whether its bytes are known; that they lie within their view is looked at in any case. */
    private boolean fits(Tree accessor, Kind kind, String type) throws IOException {
        int index = accessor.needed("bufferView");
        int size = kind.bytes * width(accessor, type);
        long end = accessor.whole("byteOffset", 0) + (accessor.needed("count") - 1L) * step(accessor, size) + size;
        int length = document.item("bufferViews", index).needed("byteLength");
        if (end > length) {
            throw accessor.fault("these " + accessor.needed("count") + " elements reach to byte " + end + " of a view of " + length + ", " + step(accessor, size) + " bytes apart");
        }
        return buffers.isKnown(index);
    }

    private void aligned(Tree accessor, Kind kind) throws IOException {
        long offset = (long) accessor.whole("byteOffset", 0) + (accessor.has("bufferView") ? buffers.offset(accessor.needed("bufferView")) : 0);
        if (accessor.whole("byteOffset", 0) % kind.bytes != 0 || offset % kind.bytes != 0) {
            throw accessor.fault("byteOffset", "numbers of " + kind.bytes + " bytes must begin at a multiple of that, but these begin at byte " + offset);
        }
    }

    /** The numbers of vertices, each below a limit. */
    int[] indices(int index, int limit) throws IOException {
        Tree accessor = document.item("accessors", index);
        width(accessor, "SCALAR");
        Kind kind = unsigned(accessor);
        int count = accessor.needed("count");
        ByteBuffer bytes = elements(accessor, kind.bytes);
        int step = step(accessor, kind.bytes);
        float[] sparse = accessor.has("sparse") ? floats(index, "SCALAR") : new float[0];
        int[] values = new int[count];
        for (int i = 0; i < count; i++) {
            double value = sparse.length > 0 ? sparse[i] : bytes.capacity() == 0 ? 0 : kind.value(bytes, i * step, false);
            if (value >= limit) {
                throw accessor.fault("element " + i + " is vertex " + (long) value + ", but there are " + limit + " vertices");
            }
            values[i] = (int) value;
        }
        return values;
    }

    private static Kind unsigned(Tree accessor) throws FormatFault {
        Kind kind = Kind.of(accessor);
        if (kind != Kind.UNSIGNED_BYTE && kind != Kind.UNSIGNED_SHORT && kind != Kind.UNSIGNED_INT) {
            throw accessor.fault("componentType", "indices must be whole numbers without a sign");
        }
        return kind;
    }

    private static int width(Tree accessor, String type) throws FormatFault {
        String is = accessor.text("type", "");
        Integer width = WIDTHS.get(type);
        if (width == null || !is.equals(type)) {
            throw accessor.fault("type", "this must be " + type + ", but is " + FormatFault.quoted(is));
        }
        return width;
    }

    private int step(Tree accessor, int size) throws IOException {
        int stride = accessor.has("bufferView") ? buffers.stride(accessor.needed("bufferView")) : 0;
        return stride == 0 ? size : stride;
    }

    /** The bytes from the first element on; none if all are zeros. */
    private ByteBuffer elements(Tree accessor, int size) throws IOException {
        long count = accessor.needed("count");
        if (!accessor.has("bufferView")) {
            if (count > MOST_ZEROS) {
                throw accessor.fault("count", "these are " + count + " elements without bytes; up to " + MOST_ZEROS + " are read");
            }
            return ByteBuffer.allocate(0);
        }
        ByteBuffer view = buffers.view(accessor.needed("bufferView"));
        return elements(accessor, view, accessor.whole("byteOffset", 0), count, size, step(accessor, size));
    }

    private static ByteBuffer elements(Tree owner, ByteBuffer view, long offset, long count, int size, int step) throws FormatFault {
        long end = count == 0 ? offset : offset + (count - 1) * step + size;
        if (end > view.capacity() || step < size) {
            throw owner.fault("these " + count + " elements reach to byte " + end + " of a view of " + view.capacity() + ", " + step + " bytes apart");
        }
        return view.slice((int) Math.min(offset, view.capacity()), view.capacity() - (int) Math.min(offset, view.capacity())).order(view.order());
    }

    /** Some elements of many may be said apart. */
    private void overwrite(Tree accessor, Kind kind, int width, float[] values) throws IOException {
        if (!accessor.has("sparse")) {
            return;
        }
        Tree sparse = accessor.childOrNothing("sparse");
        int count = sparse.needed("count");
        Tree where = sparse.childOrNothing("indices");
        Tree what = sparse.childOrNothing("values");
        Kind whereKind = unsigned(where);
        ByteBuffer places = elements(where, buffers.view(where.needed("bufferView")), where.whole("byteOffset", 0), count, whereKind.bytes, whereKind.bytes);
        int size = kind.bytes * width;
        ByteBuffer numbers = elements(what, buffers.view(what.needed("bufferView")), what.whole("byteOffset", 0), count, size, size);
        boolean isNormalized = accessor.flag("normalized");
        for (int i = 0; i < count; i++) {
            long place = (long) whereKind.value(places, i * whereKind.bytes, false);
            if (place >= values.length / width) {
                throw where.fault("element " + i + " is " + place + ", but there are " + values.length / width + " elements");
            }
            for (int k = 0; k < width; k++) {
                values[(int) (place * width + k)] = (float) kind.value(numbers, i * size + k * kind.bytes, isNormalized);
            }
        }
    }
}
