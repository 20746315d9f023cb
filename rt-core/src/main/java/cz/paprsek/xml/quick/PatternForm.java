package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.material.Pattern;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The element of a kind of pattern.
 *
 * @param tag the attributes of the record, then those of the others
 * @param others for each component that is no attribute the record that its attributes make: two colours where there may be stops instead
 * @param hasStops whether there may be stops inside
 */
record PatternForm(Name name, TagForm tag, RecordForm<? extends Record> form, List<RecordForm<? extends Record>> others, boolean hasStops) {
    /** All there are. */
    static final List<PatternForm> ALL = ElementTable.of(Pattern.class).map(PatternForm::of).toList();

    static final byte[] STOP = Slot.ascii(ElementTable.name(Pattern.Stop.class));
    static final RecordForm<Pattern.Stop> STOPS = new RecordForm<>(Pattern.Stop.class);
    static final TagForm STOP_TAG = new TagForm(List.of(), STOPS.slots());

    private static PatternForm of(Class<? extends Record> type) {
        RecordForm<? extends Record> form = new RecordForm<>(type);
        List<Class<?>> components = Arrays.stream(type.getRecordComponents())
                .filter(component -> !component.isAnnotationPresent(Attribute.class)).<Class<?>>map(RecordComponent::getType).toList();
        List<RecordForm<? extends Record>> others = new ArrayList<>();
        for (Class<?> component : components) {
            others.add(component == Pattern.Colors.class ? new RecordForm<>(Pattern.TwoColors.class) : new RecordForm<>(component.asSubclass(Record.class)));
        }
        List<Slot> slots = others.stream().flatMap(other -> other.slots().stream()).toList();
        return new PatternForm(new Name(ElementTable.name(type)), new TagForm(form.slots(), slots), form, others, components.contains(Pattern.Colors.class));
    }

    /** Makes the pattern of the values of its tag. */
    Pattern make(Object[] values, List<Pattern.Stop> stops) {
        Unusual.unless(stops.isEmpty() || hasStops);
        Object[] made = new Object[others.size()];
        int at = form.slots().size();
        for (int i = 0; i < made.length; i++) {
            made[i] = others.get(i).make(values, at);
            if (made[i] instanceof Pattern.TwoColors && !stops.isEmpty()) {
                Unusual.unless(others.get(i).isUntouched(values, at));
                made[i] = new Pattern.Stops(stops);
            }
            at += others.get(i).slots().size();
        }
        return (Pattern) form.make(values, 0, made);
    }
}
