package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Described;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** The attributes of {@code <camera>}: its own, and those of all lenses, of which one has it. */
final class CameraForm {
    private static final RecordForm<Camera> EYE = new RecordForm<>(Camera.class);
    private static final List<Slot> AIMS = Stream.of(Camera.Direction.class, Camera.Target.class).flatMap(aim -> Described.of(aim).stream()).map(Slot::of).toList();
    private static final List<OfLens> LENSES = Arrays.stream(Lens.class.getPermittedSubclasses())
            .map(type -> new OfLens(type, new RecordForm<>(type.asSubclass(Record.class)))).toList();
    /** Where in the values those of the camera, and of its lens, begin. */
    private static final int OWN = AIMS.size();
    private static final int LENS = OWN + EYE.slots().size();
    private static final int UP = OWN + names().indexOf("up");
    private static final int PROJECTION = OWN + names().indexOf("projection");

    static final TagForm TAG = new TagForm(Stream.concat(AIMS.stream(), EYE.slots().stream()).toList(),
            LENSES.stream().flatMap(lens -> lens.form().slots().stream()).map(Slot::unlessGiven).toList());

    private record OfLens(Class<?> type, RecordForm<?> form) {}

    private CameraForm() {}

    private static List<String> names() {
        return Described.of(Camera.class).stream().map(Described::name).toList();
    }

    /** @throws Unusual if it has no view, or attributes of a lens that is not its own */
    static Camera camera(Object[] values) {
        Unusual.unless(values[0] == Slot.NONE != (values[1] == Slot.NONE));
        values[PROJECTION] = lens(values);
        Camera camera = EYE.make(values, OWN, values[0] instanceof Vec3 direction ? new Camera.Direction(direction) : new Camera.Target((Vec3) values[1]));
        // What is not given gives way to another, what is given does not.
        boolean isUpGiven = values[UP] != EYE.slots().get(UP - OWN).otherwise();
        Unusual.unless(!isUpGiven || !Camera.isAlong(camera.forward(), camera.up()));
        return camera;
    }

    private static Lens lens(Object[] values) {
        @Nullable Lens made = null;
        int from = LENS;
        for (OfLens lens : LENSES) {
            List<Slot> slots = lens.form().slots();
            boolean isOurs = lens.type() == values[PROJECTION];
            for (int i = 0; i < slots.size(); i++) {
                boolean isGiven = values[from + i] != Slot.NONE;
                Unusual.unless(isOurs ? isGiven || !slots.get(i).isRequired() : !isGiven);
                values[from + i] = isGiven ? values[from + i] : slots.get(i).otherwise();
            }
            made = isOurs ? (Lens) lens.form().make(values, from) : made;
            from += slots.size();
        }
        if (made == null) {
            throw new Unusual();
        }
        return made;
    }
}
