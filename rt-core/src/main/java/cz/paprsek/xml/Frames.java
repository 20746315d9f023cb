package cz.paprsek.xml;

import cz.paprsek.math.Require;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.recipe.Moment;
import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The scenes that the frames of a film show. */
final class Frames implements DoubleFunction<Scene> {
    private static final Pattern TIME = Pattern.compile("(?U)\\{[^{}]*\\b(?:t|frame)\\b");

    private final Scene scene;
    /** Whether what formulas make depends on the time: then all of it is made anew for each frame. */
    private final boolean isMadeAnew;
    private final DoubleFunction<Scene> moments;

    /** Whether one time shows something else than another. */
    static boolean differ(Scene scene) {
        return !scene.animations().isEmpty() || knowTime(scene);
    }

    private static boolean knowTime(Scene scene) {
        return Stream.concat(Stream.of(scene.recipe().text()), scene.recipe().included().values().stream()).anyMatch(text -> TIME.matcher(text).find());
    }

    Frames(Scene given) {
        isMadeAnew = knowTime(given) || given.animations().stream().anyMatch(Animation::isOfParameter);
        scene = isMadeAnew ? Settled.of(given) : given;
        moments = scene.moments();
    }

    @Override
    public Scene apply(double frame) {
        Require.that(frame >= 1 && frame <= Integer.MAX_VALUE, "a frame must be a number from 1 on, but is " + Numbers.text(frame));
        double t = scene.settings().seconds(frame);
        try {
            return (isMadeAnew ? made(new Moment(t, frame)).at(t) : moments.apply(t)).withRecipe(Recipe.NONE);
        } catch (IllegalArgumentException refused) {
            throw new IllegalArgumentException("frame " + Numbers.text(frame) + ": " + refused.getMessage(), refused);
        }
    }

    private Scene made(Moment moment) {
        Map<String, String> parameters = new HashMap<>();
        scene.animations().stream().filter(Animation::isOfParameter).forEach(one -> parameters.put(one.parameter(),
                Arrays.stream(one.at(moment.t())).mapToObj(Numbers::text).collect(Collectors.joining(" "))));
        try {
            return Settled.at(scene, parameters, moment);
        } catch (SceneFileException wrong) {
            throw new IllegalArgumentException(wrong.problems().get(0).message(), wrong);
        } catch (IOException e) {
            throw new IllegalStateException("a text in memory could not be read", e);
        }
    }
}
