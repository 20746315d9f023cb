package cz.paprsek.fx.view.render;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.render.fields.Answer;
import cz.paprsek.fx.view.render.fields.CheckedField;
import cz.paprsek.fx.view.render.fields.FormGrid;
import cz.paprsek.fx.view.render.fields.Named;
import cz.paprsek.fx.view.render.fields.RegionFields;
import cz.paprsek.fx.view.render.fields.StopsField;
import cz.paprsek.fx.view.render.fields.WholeNumberField;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.beans.Observable;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;

/** What to render and how: size, part, rays, depth, threads, what the picture shows, which lights are lit, and whose picture it is. */
final class RenderForm extends FormGrid {
    private final Texts texts;
    private final SizeFields size;
    private final RegionFields region;
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
    private final LightBox lights;
    private final BooleanBinding valid;
    private final List<Answer> answers;
    private RenderSettings settings = RenderSettings.DEFAULT;
    /** What the controls say if nobody says anything else. */
    private Map<String, String> asked = Map.of();

    RenderForm(Texts texts) {
        this.texts = texts;
        lookLikeAForm();
        size = new SizeFields(texts);
        region = new RegionFields(texts);
        rays = new RaysForm(texts);
        depth = new WholeNumberField("render-depth", texts.of("render.depth.hint"), 1, RenderSettings.DEEPEST, 3);
        threads = new WholeNumberField("render-threads", texts.of("render.threads.hint"), 1, 1024, 3);
        exposure = new StopsField("render-exposure", texts);
        tone.setId("render-tone");
        Hint.of(tone).set(texts.of("render.tone.hint"));
        for (Tone curve : Tone.values()) {
            tone.getItems().add(new Named<>(curve, texts.of("kind." + curve)));
        }
        tone.getSelectionModel().selectFirst();
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
        denoise.disableProperty().bind(isOfLight.not().or(rays.areWholePasses().not()).or(mix.selectedProperty()).or(region.partProperty()));
        BooleanBinding isUnknown = isOfErrors.and(rays.areJudged().not());
        lights = new LightBox(texts);
        camera = new CameraBox(texts);
        Observable[] sides = Stream.concat(size.fields().stream(), region.fields().stream()).flatMap(field -> Stream.<Observable>of(field.textProperty(), field.validProperty())).toArray(Observable[]::new);
        BooleanBinding isOutside = Bindings.createBooleanBinding(() -> size.areValid() && region.areValid() && !region.isWithin(size.columns(), size.rows()),
                Stream.concat(Stream.of(sides), Stream.of(region.partProperty())).toArray(Observable[]::new));
        BooleanBinding numbers = Bindings.createBooleanBinding(() -> rays.valid().get() && exposure.validProperty().get() && region.areValid() && fields().allMatch(field -> field.validProperty().get()),
                Stream.concat(Stream.of(sides), Stream.of(rays.valid(), exposure.validProperty(), depth.validProperty(), threads.validProperty(), region.partProperty())).toArray(Observable[]::new));
        valid = numbers.and(isUnknown.not()).and(isOutside.not());
        size.fields().forEach(side -> side.textProperty().addListener((property, old, now) -> proposePart()));
        ask(texts.of("render.size"), size.fields(), size);
        ask(texts.of("render.region"), orElse(refusal(region.fields()), isOutside, "render.region.outside"), region);
        ask(texts.of("render.camera"), List.of(), camera, new Label(texts.of("render.lights")), lights);
        ask(texts.of("field.integrator"), List.of(), rays.integrator());
        ask(texts.of("render.samples"), orElse(refusal(rays.samples()), rays.rising().not(), "render.samples.falling"), rays.samples().get(0), new Label("–"), rays.samples().get(1));
        ask(texts.of("field.error"), rays.accuracy(), rays.accuracy().get(0), new Label(texts.of("field.confidence")), rays.accuracy().get(1));
        ask(texts.of("field.filter"), List.of(), rays.filter(), new Label(texts.of("render.sampler")), rays.sampler());
        ask(texts.of("render.depth"), List.of(depth, threads), depth, new Label(texts.of("render.threads")), threads);
        ask(texts.of("render.exposure"), List.of(exposure), exposure, tone);
        ask(texts.of("render.mode"), orElse(refusal(List.of()), isUnknown, "render.unjudged"), mode);
        ask("", List.of(), transparent, denoise, mix);
        answers = Stream.of(size.answers(), List.of(new Answer("region", () -> region.word(size.word()), word -> region.say(word, size.word())),
                new Answer("camera", camera::word, camera::say), new Answer("lights", lights::word, lights::say)), rays.answers(),
                List.of(Answer.of("depth", depth), Answer.of("threads", threads), Answer.of("exposure", exposure), Answer.of("tone", tone), Answer.of("mode", mode),
                        Answer.of("transparent", transparent), Answer.of("denoise", denoise), Answer.of("mix", mix))).flatMap(List::stream).toList();
    }

    /** As long as no part is wished, its numbers are those of the picture's middle. */
    private void proposePart() {
        if (size.areValid() && !region.partProperty().get()) {
            region.propose(size.columns(), size.rows());
        }
    }

    private ObservableValue<String> orElse(ObservableValue<String> first, BooleanBinding holds, String key) {
        return Bindings.createStringBinding(() -> !first.getValue().isEmpty() ? first.getValue() : holds.get() ? texts.of(key) : "", first, holds);
    }

    /** Fills in what a scene asks for, the camera that is looked through, and in place of that what was said last. */
    void set(EditorState state, Map<String, String> said) {
        Scene scene = state.scene();
        settings = scene.settings();
        size.ask(settings.width(), settings.height());
        region.setWhole();
        rays.set(settings);
        depth.set(settings.maxDepth());
        threads.set(Runtime.getRuntime().availableProcessors());
        exposure.set(settings.exposure());
        tone.getItems().stream().filter(one -> one.value() == settings.tone()).forEach(tone.getSelectionModel()::select);
        Stream.of(transparent, denoise, mix).forEach(box -> box.setSelected(false));
        mode.reset();
        lights.offer(scene);
        camera.follow(state);
        asked = words();
        Map<String, String> wished = new HashMap<>(asked);
        wished.putAll(said);
        answers.forEach(answer -> answer.set().accept(wished.getOrDefault(answer.name(), "")));
    }

    /** Fills in a part of pictures, and how large they are, from a word to be remembered; all of them if it says none. */
    void sayRegion(String word) {
        int at = word.indexOf('/');
        if (at > 0) {
            size.answers().get(0).set().accept(word.substring(at + 1));
        }
        region.say(word, size.word());
    }

    /** What is said here otherwise than the scene asks for: to be remembered. */
    Map<String, String> said() {
        return words().entrySet().stream().filter(word -> !word.getValue().equals(asked.get(word.getKey()))).collect(Collectors.toUnmodifiableMap(Map.Entry::getKey, Map.Entry::getValue));
    }

    /** All that is said here, by the names of the questions. */
    Map<String, String> words() {
        return answers.stream().collect(Collectors.toMap(Answer::name, answer -> answer.get().get()));
    }

    /** Takes the keyboard, at the first question. */
    void takeKeys() {
        size.fields().get(0).requestFocus();
    }

    /** Offers the cameras there are now. */
    void follow(EditorState state) {
        camera.follow(state);
    }

    /** Whether all fields hold numbers within their ranges. */
    BooleanBinding valid() {
        return valid;
    }

    /** What the fields say; only if they are valid. */
    RenderOptions options() {
        RenderSettings wished = rays.applyTo(settings.withSize(size.columns(), size.rows()).withMaxDepth(depth.get())
                .withExposure(exposure.get()).withTone(tone.getValue().value()));
        RenderOptions options = rays.applyTo(RenderOptions.of(wished).withThreads(threads.get()).withMode(mode.mode()));
        Optional<Tile> part = region.region();
        options = part.isPresent() ? options.withRegion(part.get()) : options;
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
        Hint.of(box).set(hint);
        return box;
    }

    /** The scene as the chosen camera sees it, with those of its lights that are to be lit. */
    Subject chosen(Scene scene) {
        return new Subject(scene, lights.lit(camera.seen(scene)), camera.word(scene), lights.word(scene));
    }

    /** What beside its size tells this picture from others; empty for one that shows the light of all lights to the only camera. */
    String remark() {
        Stream<String> part = region.region().stream().map(tile -> texts.of("render.region.remark", tile.x(), tile.y(), tile.width(), tile.height()));
        Stream<String> others = Stream.of(mode, lights).filter(box -> box.getSelectionModel().getSelectedIndex() > 0).map(box -> box.getValue().name());
        return Stream.of(part, Stream.of(camera.remark()).filter(Predicate.not(String::isEmpty)), others).flatMap(words -> words).map(remark -> " · " + remark).collect(Collectors.joining());
    }

    private Stream<CheckedField> fields() {
        return Stream.concat(size.fields().stream(), Stream.of(depth, threads));
    }
}
