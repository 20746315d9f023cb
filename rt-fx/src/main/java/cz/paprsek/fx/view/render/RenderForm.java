package cz.paprsek.fx.view.render;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.beans.Observable;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;

/** What to render and how: size, rays, depth, threads, what the picture shows, which lights are lit, and whose picture it is. */
final class RenderForm extends FlowPane {
    private record Preset(int width, int height, String name) {}

    private static final List<Preset> PRESETS = List.of(
            new Preset(320, 240, "QVGA"),
            new Preset(640, 480, "VGA"),
            new Preset(800, 600, "SVGA"),
            new Preset(1024, 768, "XGA"),
            new Preset(1280, 720, "HD"),
            new Preset(1920, 1080, "Full HD"),
            new Preset(2560, 1440, "QHD"),
            new Preset(3840, 2160, "4K UHD"),
            new Preset(1024, 1024, "1 : 1"));

    private final WholeNumberField width;
    private final WholeNumberField height;
    private final RaysForm rays;
    private final WholeNumberField depth;
    private final WholeNumberField threads;
    private final StopsField exposure;
    private final ChoiceBox<Named<Tone>> tone = new ChoiceBox<>();
    private final CheckBox transparent;
    private final CheckBox denoise;
    private final CheckBox mix;
    private final ModeBox mode;
    private final CameraBox camera;
    private final HBox cameraGroup;
    private final LightBox lights;
    private final BooleanBinding valid;
    private RenderSettings settings = RenderSettings.DEFAULT;

    RenderForm(Texts texts) {
        width = new WholeNumberField("render-width", texts.of("render.width"), 1, RenderSettings.LARGEST_SIDE, 4);
        height = new WholeNumberField("render-height", texts.of("render.height"), 1, RenderSettings.LARGEST_SIDE, 4);
        rays = new RaysForm(texts);
        depth = new WholeNumberField("render-depth", texts.of("render.depth.hint"), 1, RenderSettings.DEEPEST, 3);
        threads = new WholeNumberField("render-threads", texts.of("render.threads.hint"), 1, 1024, 3);
        threads.set(Runtime.getRuntime().availableProcessors());
        exposure = new StopsField(texts);
        tone.setId("render-tone");
        tone.setTooltip(new Tooltip(texts.of("render.tone.hint")));
        for (Tone curve : Tone.values()) {
            tone.getItems().add(new Named<>(curve, texts.of("kind." + curve)));
        }
        transparent = check("render-transparent", texts.of("render.transparent"), texts.of("render.transparent.hint"));
        denoise = check("render-denoise", texts.of("render.denoise"), texts.of("render.denoise.hint"));
        mix = check("render-mix", texts.of("render.mix"), texts.of("render.mix.hint"));
        mode = new ModeBox(texts);
        BooleanBinding isOfLight = Bindings.createBooleanBinding(() -> mode.getValue() == null || mode.mode() == RenderMode.SHADED, mode.valueProperty());
        BooleanBinding isOfErrors = Bindings.createBooleanBinding(() -> mode.getValue() != null && mode.mode() == RenderMode.ERROR, mode.valueProperty());
        // How far a value is off depends on how it is shown.
        Stream.of(exposure, tone).forEach(control -> control.disableProperty().bind(isOfLight.or(isOfErrors).not()));
        transparent.disableProperty().bind(isOfLight.not());
        mix.disableProperty().bind(isOfLight.not());
        // Layers keep their noise, and who mixes them anew would bring it back.
        denoise.disableProperty().bind(isOfLight.not().or(rays.areWholePasses().not()).or(mix.selectedProperty()));
        BooleanBinding isUnknown = isOfErrors.and(rays.areJudged().not());
        Label unknown = new Label(texts.of("render.unjudged"));
        unknown.setId("render-unjudged");
        unknown.visibleProperty().bind(isUnknown);
        unknown.managedProperty().bind(isUnknown);
        lights = new LightBox(texts);
        camera = new CameraBox(texts);
        cameraGroup = group(new Label(texts.of("render.camera")), camera);
        MenuButton presets = new MenuButton(texts.of("render.size"));
        presets.setId("render-presets");
        PRESETS.forEach(preset -> presets.getItems().add(item(preset)));
        valid = Bindings.createBooleanBinding(() -> !isUnknown.get() && rays.valid().get() && exposure.validProperty().get() && fields().allMatch(field -> field.validProperty().get()),
                Stream.concat(fields().map(WholeNumberField::validProperty), Stream.of(rays.valid(), exposure.validProperty(), isUnknown)).toArray(Observable[]::new));
        setHgap(12);
        setVgap(6);
        setAlignment(Pos.CENTER_LEFT);
        getChildren().addAll(group(presets, width, new Label("×"), height), group(new Label(texts.of("render.depth")), depth),
                group(new Label(texts.of("render.threads")), threads), group(new Label(texts.of("render.exposure")), exposure, tone), transparent, denoise, mix,
                group(new Label(texts.of("render.mode")), mode, unknown), group(new Label(texts.of("render.lights")), lights), cameraGroup);
        getChildren().addAll(1, rays.groups());
    }

    /** Fills in what a scene asks for, and the camera that is looked through. */
    void set(EditorState state) {
        Scene scene = state.scene();
        settings = scene.settings();
        width.set(settings.width());
        height.set(settings.height());
        rays.set(settings);
        depth.set(settings.maxDepth());
        exposure.set(settings.exposure());
        tone.getItems().stream().filter(one -> one.value() == settings.tone()).forEach(tone.getSelectionModel()::select);
        Stream.of(transparent, denoise, mix).forEach(box -> box.setSelected(false));
        mode.reset();
        lights.offer(scene);
        follow(state);
    }

    /** Offers the cameras there are now. */
    void follow(EditorState state) {
        camera.follow(state);
        cameraGroup.setVisible(state.scene().cameras().size() > 1);
        cameraGroup.setManaged(cameraGroup.isVisible());
    }

    /** Whether all fields hold numbers within their ranges. */
    BooleanBinding valid() {
        return valid;
    }

    /** What the fields say; only if they are valid. */
    RenderOptions options() {
        RenderSettings wished = rays.applyTo(settings.withSize(width.get(), height.get()).withMaxDepth(depth.get())
                .withExposure(exposure.get()).withTone(tone.getValue().value()));
        RenderOptions options = rays.applyTo(RenderOptions.of(wished).withThreads(threads.get()).withMode(mode.mode()));
        options = isWished(transparent) ? options.withTransparency() : options;
        options = isWished(mix) ? options.withLayers(List.of(Layer.LIGHT)) : options;
        return isWished(denoise) ? options.withDenoiser() : options;
    }

    private static boolean isWished(CheckBox box) {
        return box.isSelected() && !box.isDisabled();
    }

    private static CheckBox check(String id, String text, String hint) {
        CheckBox box = new CheckBox(text);
        box.setId(id);
        box.setTooltip(new Tooltip(hint));
        return box;
    }

    /** The scene as the chosen camera sees it, with those of its lights that are to be lit. */
    Subject chosen(Scene scene) {
        return new Subject(scene, lights.lit(camera.seen(scene)), camera.word(scene), lights.word(scene));
    }

    /** What beside its size tells this picture from others; empty for one that shows the light of all lights to the only camera. */
    String remark() {
        Stream<String> others = Stream.of(mode, lights).filter(box -> box.getSelectionModel().getSelectedIndex() > 0).map(box -> box.getValue().name());
        return Stream.concat(Stream.of(camera.remark()).filter(Predicate.not(String::isEmpty)), others).map(remark -> " · " + remark).collect(Collectors.joining());
    }

    private Stream<WholeNumberField> fields() {
        return Stream.of(width, height, depth, threads);
    }

    private MenuItem item(Preset preset) {
        MenuItem item = new MenuItem(preset.width() + " × " + preset.height() + "   " + preset.name());
        item.setOnAction(event -> {
            width.set(preset.width());
            height.set(preset.height());
        });
        return item;
    }

    static HBox group(Node... nodes) {
        HBox group = new HBox(6, nodes);
        group.setAlignment(Pos.CENTER_LEFT);
        return group;
    }
}
