package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.render.fields.Answer;
import cz.paprsek.fx.view.render.fields.Named;
import cz.paprsek.fx.view.render.fields.RealField;
import cz.paprsek.fx.view.render.fields.WholeNumberField;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import java.util.List;
import java.util.stream.Stream;
import javafx.beans.Observable;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.value.ObservableBooleanValue;
import javafx.scene.control.ChoiceBox;

/** How many rays a pixel takes, where they go through, and what is random about them; as {@code render} has it in its options. */
final class RaysForm {
    private final ChoiceBox<Named<Integrator>> integrator = new ChoiceBox<>();
    private final WholeNumberField samples;
    private final WholeNumberField mostSamples;
    private final RealField error;
    private final RealField confidence;
    private final ChoiceBox<Named<PixelFilter>> filter = new ChoiceBox<>();
    private final ChoiceBox<Named<Boolean>> sampler = new ChoiceBox<>();
    private final BooleanBinding valid;
    private final BooleanBinding rising;

    RaysForm(Texts texts) {
        samples = new WholeNumberField("render-samples", texts.of("render.samples.hint"), 1, RenderSettings.MOST_SAMPLES, 6);
        mostSamples = new WholeNumberField("render-most-samples", texts.of("render.most-samples.hint"), 0, RenderSettings.MOST_SAMPLES, 6);
        for (Integrator kind : Integrator.values()) {
            integrator.getItems().add(new Named<>(kind, texts.of("kind." + kind)));
        }
        integrator.setId("render-integrator");
        Hint.of(integrator).set(texts.of("render.integrator.hint"));
        integrator.getSelectionModel().selectFirst();
        integrator.valueProperty().addListener((property, old, now) -> turnTo(now.value()));
        error = RealField.of("render-error", texts.of("render.error.hint"), texts, value -> value > 0, RenderSettings.DEFAULT.error());
        confidence = RealField.of("render-confidence", texts.of("render.confidence.hint"), texts, value -> value > 0 && value < 1, RenderSettings.DEFAULT.confidence());
        for (PixelFilter kind : PixelFilter.values()) {
            filter.getItems().add(new Named<>(kind, texts.of("kind." + kind)));
        }
        filter.setId("render-filter");
        Hint.of(filter).set(texts.of("render.filter.hint"));
        filter.getSelectionModel().selectFirst();
        sampler.getItems().setAll(List.of(new Named<>(false, texts.of("render.sampler.scrambled")), new Named<>(true, texts.of("render.sampler.fixed"))));
        sampler.setId("render-sampler");
        Hint.of(sampler).set(texts.of("render.sampler.hint"));
        sampler.getSelectionModel().selectFirst();
        BooleanBinding isGrid = Bindings.createBooleanBinding(() -> mostSamples.validProperty().get() && mostSamples.get() == 0, mostSamples.textProperty());
        error.disableProperty().bind(isGrid);
        confidence.disableProperty().bind(isGrid);
        ObservableBooleanValue[] each = {samples.validProperty(), mostSamples.validProperty(), error.validProperty(), confidence.validProperty()};
        rising = Bindings.createBooleanBinding(() -> !samples.validProperty().get() || !mostSamples.validProperty().get() || isFromLessToMore(),
                samples.textProperty(), mostSamples.textProperty(), samples.validProperty(), mostSamples.validProperty());
        valid = Bindings.createBooleanBinding(() -> Stream.of(each).allMatch(ObservableBooleanValue::get) && isFromLessToMore(),
                Stream.concat(Stream.of(each), Stream.of(samples.textProperty(), mostSamples.textProperty())).toArray(Observable[]::new));
    }

    ChoiceBox<Named<Integrator>> integrator() {
        return integrator;
    }

    /** From how many rays to how many. */
    List<WholeNumberField> samples() {
        return List.of(samples, mostSamples);
    }

    /** How near pixels are to come to the truth, and how probably. */
    List<RealField> accuracy() {
        return List.of(error, confidence);
    }

    ChoiceBox<Named<PixelFilter>> filter() {
        return filter;
    }

    ChoiceBox<Named<Boolean>> sampler() {
        return sampler;
    }

    /** Whether the samples go from less to more, as far as they are numbers. */
    BooleanBinding rising() {
        return rising;
    }

    /** What its controls say; the integrator first, with which the numbers of samples change. */
    List<Answer> answers() {
        return List.of(Answer.of("integrator", integrator), Answer.of("samples", samples), Answer.of("most-samples", mostSamples), Answer.of("error", error),
                Answer.of("confidence", confidence), Answer.of("filter", filter), Answer.of("sampler", sampler));
    }

    /** Fills in what a scene asks for; how random numbers are chosen is no matter of scenes, and as usual. */
    void set(RenderSettings settings) {
        integrator.getItems().stream().filter(kind -> kind.value() == settings.integrator()).findFirst().ifPresent(integrator::setValue);
        samples.set(settings.samples());
        mostSamples.set(settings.mostSamples());
        error.set(settings.error());
        confidence.set(settings.confidence());
        filter.getItems().stream().filter(kind -> kind.value() == settings.filter()).findFirst().ifPresent(filter::setValue);
        sampler.getSelectionModel().selectFirst();
    }

    /** Fields get the range of an integrator's samples, and the numbers that it takes if nobody says any. */
    private void turnTo(Integrator kind) {
        samples.setMost(kind.mostSamples());
        mostSamples.setMost(kind.mostSamples());
        samples.set(kind.usualSamples());
        mostSamples.set(0);
    }

    /** Whether it can be known how near pixels are to the truth: those of paths, and of rays that are no grid. */
    BooleanBinding areJudged() {
        return Bindings.createBooleanBinding(() -> integrator.getValue().value() == Integrator.PATH || (mostSamples.validProperty().get() && mostSamples.get() > 0),
                integrator.valueProperty(), mostSamples.textProperty());
    }

    /** Whether pictures are made in whole passes of paths, of which noise can be taken out. */
    BooleanBinding areWholePasses() {
        return Bindings.createBooleanBinding(() -> integrator.getValue().value() == Integrator.PATH && samples.validProperty().get() && mostSamples.validProperty().get()
                && Math.max(samples.get(), mostSamples.get()) % RenderSettings.USUAL_PATHS == 0, integrator.valueProperty(), samples.textProperty(), mostSamples.textProperty());
    }

    /** Whether all fields hold numbers within their ranges. */
    BooleanBinding valid() {
        return valid;
    }

    /** Settings with what the fields say; only if they are valid. */
    RenderSettings applyTo(RenderSettings settings) {
        return settings.withIntegrator(integrator.getValue().value()).withSamples(samples.get(), mostSamples.get()).withError(error.get()).withConfidence(confidence.get()).withFilter(filter.getValue().value());
    }

    RenderOptions applyTo(RenderOptions options) {
        return sampler.getValue().value() ? options.withFixedSampler() : options;
    }

    private boolean isFromLessToMore() {
        return mostSamples.get() == 0 || mostSamples.get() >= samples.get();
    }
}
