package cz.paprsek.fx.view.render.fields;

/** A value to choose, and what the user reads for it. */
public record Named<T>(T value, String name) {
    @Override
    public String toString() {
        return name;
    }
}
