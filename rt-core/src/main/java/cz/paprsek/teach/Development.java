package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.GAMMA_DOUBLED;
import static cz.paprsek.teach.mistake.Mistake.GAMMA_MISSING;
import static cz.paprsek.teach.mistake.Mistake.GAMMA_POWER;
import static cz.paprsek.teach.mistake.Mistake.NO_CLAMP;
import static cz.paprsek.teach.mistake.Mistake.RED_BLUE_SWAPPED;

import cz.paprsek.material.Rgb;
import cz.paprsek.teach.mistake.Mistakes;

/** What goes wrong when light becomes numbers of a picture: said as the light that a right picture would have to show the same numbers. */
record Development(Mistakes made) {
    Vec of(Vec light) {
        Vec swapped = made.has(RED_BLUE_SWAPPED) ? new Vec(light.z(), light.y(), light.x()) : light;
        return new Vec(channel(swapped.x()), channel(swapped.y()), channel(swapped.z()));
    }

    private double channel(double light) {
        if (!(made.has(NO_CLAMP) && light > 1) && !changesNumbers()) {
            return light;
        }
        double number = number(Math.max(0, made.has(NO_CLAMP) ? light : Math.min(1, light)));
        return Rgb.linear(number > 255 ? Math.rint(number) % 256 : number);
    }

    private boolean changesNumbers() {
        return made.has(GAMMA_MISSING) || made.has(GAMMA_DOUBLED) || made.has(GAMMA_POWER);
    }

    /** The number, 0–255, that the picture gets. */
    private double number(double light) {
        if (made.has(GAMMA_MISSING)) {
            return 255 * light;
        } else if (made.has(GAMMA_DOUBLED)) {
            return Rgb.encoded(Rgb.encoded(light) / 255);
        }
        return made.has(GAMMA_POWER) ? 255 * StrictMath.pow(light, 1 / 2.2) : Rgb.encoded(light);
    }
}
