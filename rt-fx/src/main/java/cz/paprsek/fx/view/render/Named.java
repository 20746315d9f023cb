package cz.paprsek.fx.view.render;

/** A value to choose, and what the user reads for it. */
record Named<T>(T value, String name) {
    @Override
    public String toString() {
        return name;
    }
}
