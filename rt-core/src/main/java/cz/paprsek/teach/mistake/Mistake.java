package cz.paprsek.teach.mistake;

import cz.paprsek.words.Words;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;

/** What goes wrong in ray tracers that are written to learn: the line of the derivation as it should be, and as it was. What in it is said in words is in the table of sentences. */
public enum Mistake {
    FULL_FOVY(Part.EYE, "h = 2·tan(fovy/2)", "h = 2·tan(fovy)"),
    FOVY_HORIZONTAL(Part.EYE, "h = 2·tan(fovy/2), w = h·W/H", "w = 2·tan(fovy/2), h = w·H/W"),
    ASPECT_IGNORED(Part.EYE, "w = h·W/H", "w = h"),
    HALF_PIXEL(Part.EYE, "(x, y) = (column + ½, row + ½)", "(x, y) = (column, row)"),
    FLIP_X(Part.EYE, "d + (x/W − ½)·w·r + (½ − y/H)·h·u", "d − (x/W − ½)·w·r + (½ − y/H)·h·u"),
    FLIP_Y(Part.EYE, "d + (x/W − ½)·w·r + (½ − y/H)·h·u", "d + (x/W − ½)·w·r − (½ − y/H)·h·u"),
    UP_AS_GIVEN(Part.EYE, "u = r × d", "u = up"),
    RIGHT_NOT_UNIT(Part.EYE, "r = (d × up)/|d × up|", "r = d × up"),

    RADIUS_IS_DIAMETER(Part.SHAPE, "|P − S| = r", "|P − S| = r/2"),
    NORMAL_NOT_UNIT(Part.SHAPE, "N = (P − S)/|P − S|", "N = 2(P − S)"),
    NORMAL_NOT_TURNED(Part.SHAPE, "N := −N if d·N > 0", "N as it is"),
    NORMAL_BY_MATRIX(Part.SHAPE, "N = (M⁻¹)ᵀ·n", "N = M·n"),
    RECTANGLE_SIGN(Part.SHAPE, "t = −o_z/d_z", "t = o_z/d_z"),
    RECTANGLE_ONE_SIDED(Part.SHAPE, "no hit if d_z = 0", "no hit if d_z ≥ 0"),
    ELLIPSOID_AS_DIRECTION(Part.SHAPE, "|p|² = 1", "|p|² = 0: the 1 is lost with w = 0"),
    SMALLER_T(Part.SHAPE, "the smaller t > 0 of both", "the smaller t, if it is > 0"),
    BEHIND(Part.SHAPE, "the smallest t > 0", "the smallest t"),
    LAST_HIT(Part.SHAPE, "the body with the smallest t", "the last body that is hit"),
    ONE_INTERVAL(Part.SHAPE, "all stretches inside", "the first stretch only"),
    DIFFERENCE_SWAPPED(Part.SHAPE, "A and not B", "B and not A"),
    SUBTRACTED_NOT_TURNED(Part.SHAPE, "N := −N on what is subtracted", "N as it is"),
    NO_ROTATION(Part.SHAPE, "P = T·R·S·p", "P = T·S·p"),
    ROTATION_OPPOSITE(Part.SHAPE, "R(α)", "R(−α)"),
    ROTATION_ORDER(Part.SHAPE, "R = R_z·R_y·R_x", "R = R_x·R_y·R_z"),

    CHECKER_SWAPPED(Part.PATTERN, "the first colour if ⌊x⌋ + ⌊y⌋ is even", "the first colour if it is odd"),
    CHECKER_CONSTANT(Part.PATTERN, "⌊x⌋ + ⌊y⌋ of the point hit", "⌊x⌋ + ⌊y⌋ of a corner"),
    CHECKER_TRUNCATED(Part.PATTERN, "⌊x⌋", "(int) x: −0.5 becomes 0"),
    COLORS_NOT_DECODED(Part.PATTERN, "C = ((v/255 + 0.055)/1.055)^2.4", "C = v/255"),

    NO_AMBIENT(Part.LIGHT, "A·C", "0"),
    AMBIENT_UNCOLORED(Part.LIGHT, "A·C", "A"),
    AMBIENT_PER_LIGHT(Part.LIGHT, "A·C once", "A·C for each light"),
    NO_DIFFUSE(Part.LIGHT, "kD·C·max(0, N·L)", "0"),
    NO_COSINE(Part.LIGHT, "kD·C·max(0, N·L)", "kD·C"),
    DIFFUSE_NOT_CLAMPED(Part.LIGHT, "max(0, N·L)", "N·L"),
    L_NOT_UNIT(Part.LIGHT, "L = (Q − P)/|Q − P|", "L = Q − P"),
    NO_HIGHLIGHT(Part.LIGHT, "kS·max(0, R·L)ⁿ", "0"),
    HIGHLIGHT_NOT_CLAMPED(Part.LIGHT, "max(0, R·L)ⁿ", "(R·L)ⁿ"),
    HIGHLIGHT_BEHIND(Part.LIGHT, "no highlight if N·L ≤ 0", "kS·max(0, R·L)ⁿ always"),
    HIGHLIGHT_OPPOSITE(Part.LIGHT, "max(0, R·L)ⁿ", "max(0, −R·L)ⁿ"),
    HIGHLIGHT_COLORED(Part.LIGHT, "kS·max(0, R·L)ⁿ", "kS·C·max(0, R·L)ⁿ"),
    HALF_VECTOR(Part.LIGHT, "max(0, R·L)ⁿ", "max(0, N·(L − d)/|L − d|)ⁿ"),
    NO_EXPONENT(Part.LIGHT, "max(0, R·L)ⁿ", "max(0, R·L)"),
    FIRST_LIGHT_ONLY(Part.LIGHT, "Σ over all lights", "the first light"),
    WHITE_LIGHT(Part.LIGHT, "I·colour", "I"),
    NO_FALL_OFF(Part.LIGHT, "I·D²/d²", "I"),
    FALL_OFF_LINEAR(Part.LIGHT, "I·D²/d²", "I·D²/d"),
    FALL_OFF_ADDED(Part.LIGHT, "I", "I/d²"),
    SPOT_HARD(Part.LIGHT, "3t² − 2t³", "t"),
    SPOT_FULL_ANGLE(Part.LIGHT, "angles from the middle of the cone", "angles across the whole cone"),

    NO_SHADOW(Part.SHADOW, "V = Π kT of what is in the way", "V = 1"),
    SHADOW_BEYOND_LIGHT(Part.SHADOW, "0 < t < |Q − P|", "0 < t"),
    GLASS_SHADOW_BLACK(Part.SHADOW, "V = Π kT of what is in the way", "V = 0 if anything is in the way"),
    ACNE(Part.SHADOW, "the surface left is not met at t ≈ 0", "t > 0"),

    NO_REFLECTION(Part.MIRROR, "kR·trace(R)", "0"),
    MIRROR_SIGN(Part.MIRROR, "R = d + 2c·N, c = |d·N|", "R = d − 2c·N"),
    MIRROR_BLENDS(Part.MIRROR, "B + kR·trace(R)", "(1 − kR)·B + kR·trace(R)"),
    MISS_IS_BLACK(Part.MIRROR, "a ray that hits nothing brings the background", "a mirrored ray that hits nothing brings 0"),
    NO_TRANSPARENCY(Part.MIRROR, "kT·trace(T)", "0"),
    NO_REFRACTION(Part.MIRROR, "T = e·d + (e·c − √t)·N", "T = d"),
    SNELL_UPSIDE_DOWN(Part.MIRROR, "e = n₁/n₂", "e = n₂/n₁"),
    SNELL_NOT_SQUARED(Part.MIRROR, "t = 1 + e²(c² − 1)", "t = 1 + e(c² − 1)"),
    SNELL_ALWAYS_IN(Part.MIRROR, "e = n₁/n₂", "e = 1/n, also on the way out"),
    TOTAL_REFLECTION_LOST(Part.MIRROR, "(kR + kT)·trace(R) if t < 0", "kR·trace(R)"),
    DEPTH_MORE(Part.MIRROR, "levels 1 … N", "levels 1 … N + 1"),
    DEPTH_LESS(Part.MIRROR, "levels 1 … N", "levels 1 … N − 1"),

    GAMMA_MISSING(Part.PICTURE, "v = 255·(1.055·B^(1/2.4) − 0.055)", "v = 255·B"),
    GAMMA_DOUBLED(Part.PICTURE, "v = 255·s(B)", "v = 255·s(s(B))"),
    GAMMA_POWER(Part.PICTURE, "v = 255·(1.055·B^(1/2.4) − 0.055)", "v = 255·B^(1/2.2)"),
    NO_CLAMP(Part.PICTURE, "v = min(255, v)", "v mod 256"),
    RED_BLUE_SWAPPED(Part.PICTURE, "red, green, blue", "blue, green, red");

    /** The names of all, as people type them. */
    public static final List<String> NAMES = Arrays.stream(values()).map(Mistake::toString).toList();

    private final Part part;
    private final String right;
    private final String wrong;

    /** What of a ray tracer is wrong. */
    public enum Part { EYE, SHAPE, PATTERN, LIGHT, SHADOW, MIRROR, PICTURE }

    Mistake(Part part, String right, String wrong) {
        this.part = part;
        this.right = right;
        this.wrong = wrong;
    }

    /** What of a ray tracer it is in. */
    public Part part() {
        return part;
    }

    /** The line of the derivation as it should be. */
    public String right(Words words) {
        return Objects.requireNonNull(words, "words").sentence(right);
    }

    /** The line as it was. */
    public String wrong(Words words) {
        return Objects.requireNonNull(words, "words").sentence(wrong);
    }

    /** What goes wrong, in a few words. */
    public String meaning(Words words) {
        return Objects.requireNonNull(words, "words").of("mistake." + this);
    }

    /** The name as people type it. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The mistake of that name, in any case. */
    public static Optional<Mistake> of(String name) {
        Objects.requireNonNull(name, "name");
        return Arrays.stream(values()).filter(mistake -> mistake.toString().equalsIgnoreCase(name)).findFirst();
    }
}
