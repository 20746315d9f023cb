package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SpotLight;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The element of a kind of light.
 *
 * @param tag the attributes of the record, then those of the choices
 * @param choices for each component that is no attribute, the records of which a light has one
 */
record LightForm(Name name, TagForm tag, RecordForm<? extends Record> form, List<List<RecordForm<? extends Record>>> choices) {
    /** All there are. */
    static final List<LightForm> ALL = ElementTable.of(Light.class).map(LightForm::of).toList();

    /** Where among the values of a spot is its inner angle. */
    private static final int INNER = Described.of(SpotLight.class).stream().map(Described::name).toList().indexOf("inner-angle");

    private static LightForm of(Class<? extends Record> type) {
        RecordForm<? extends Record> form = new RecordForm<>(type);
        List<List<RecordForm<? extends Record>>> choices = new ArrayList<>();
        for (RecordComponent component : type.getRecordComponents()) {
            if (!component.isAnnotationPresent(Attribute.class)) {
                choices.add(Arrays.stream(component.getType().getPermittedSubclasses()).<RecordForm<? extends Record>>map(LightForm::choice).toList());
            }
        }
        List<Slot> slots = choices.stream().flatMap(List::stream).flatMap(choice -> choice.slots().stream()).toList();
        return new LightForm(new Name(ElementTable.name(type)), new TagForm(form.slots(), slots), form, choices);
    }

    private static RecordForm<? extends Record> choice(Class<?> type) {
        return new RecordForm<>(type.asSubclass(Record.class));
    }

    /** Makes the light of the values of its tag. */
    Light make(Object[] values) {
        Object[] others = new Object[choices.size()];
        int at = form.slots().size();
        for (int i = 0; i < others.length; i++) {
            Object chosen = Slot.NONE;
            for (RecordForm<? extends Record> choice : choices.get(i)) {
                if (!choice.isStandard(values, at)) {
                    Unusual.unless(chosen == Slot.NONE);
                    chosen = choice.make(values, at);
                }
                at += choice.slots().size();
            }
            Unusual.unless(chosen != Slot.NONE);
            others[i] = chosen;
        }
        Light light = (Light) form.make(values, 0, others);
        // What is not given gives way to a smaller angle, what is given does not.
        boolean gaveWay = light instanceof SpotLight spot && spot.innerAngle() > spot.outerAngle();
        Unusual.unless(!gaveWay || values[INNER] == form.slots().get(INNER).otherwise());
        return light;
    }
}
