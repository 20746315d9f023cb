package cz.paprsek.shape.font;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Vec3;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Fonts as fontTools 4.68 reads them (AreaPen, width of a glyph, kern), and what is said of broken ones. */
class FontTest {
    @ParameterizedTest
    @CsvSource({
            "sans, O, 0.18732776244481403, 0.787109375",
            "sans, g, 0.1745806336402893, 0.634765625",
            "sans, ř, 0.09330473343531293, 0.4111328125",
            "sans, @, 0.26613565286000573, 1",
            "sans-bold, Ů, 0.33724951744079584, 0.81201171875",
            "serif, P, 0.1524652441342672, 0.6728515625"})
    void lettersHaveTheAreaAndTheWidthThatTheyShould(String name, String letter, double area, double width) {
        Font font = Fonts.shipped(name).orElseThrow();
        assertThat(font.width(font.glyph(letter.codePointAt(0))) / 2048.0).isEqualTo(width);
        double found = 0;
        for (Letters.Letter one : new Letters(font, letter, 1).all()) {
            found += one.outline().polygons(1e-3).stream().mapToDouble(FontTest::area).sum() / 2048 / 2048;
        }
        assertThat(Math.abs(found)).isCloseTo(area, within(1e-6));
    }

    private static double area(List<Vec3> polygon) {
        double twice = 0;
        for (int i = 0; i + 1 < polygon.size(); i++) {
            twice += polygon.get(i).x() * polygon.get(i + 1).y() - polygon.get(i + 1).x() * polygon.get(i).y();
        }
        return twice / 2;
    }

    @ParameterizedTest
    @CsvSource({"sans, AV, -131", "sans, To, -348", "sans-bold, LT, -339", "serif, AV, -102", "sans, oo, 0"})
    void pairsAreKerned(String name, String pair, int units) {
        Font font = Fonts.shipped(name).orElseThrow();
        assertThat(font.kerning(font.glyph(pair.charAt(0)), font.glyph(pair.charAt(1)))).isEqualTo(units);
    }

    @Test
    void everyLetterOfCzechIsShipped() {
        for (String name : Fonts.NAMES) {
            assertThat(new Letters(Fonts.shipped(name).orElseThrow(), "Příliš žluťoučký kůň úpěl ďábelské ódy; ÁČĎÉĚÍŇÓŘŠŤÚŮÝŽ „–“ 0123456789", 1).all()).hasSizeGreaterThan(60);
        }
    }

    @Test
    void aFontThatIsNoneIsToldByASentence() {
        assertThatThrownBy(() -> new Font("<html>".getBytes(StandardCharsets.US_ASCII)))
                .hasMessage("this is no TrueType font: it must begin with the bytes 00 01 00 00, but has 3c68746d");
        assertThatThrownBy(() -> new Font(new byte[] {'O', 'T', 'T', 'O', 0, 0})).hasMessageContaining("as PostScript has them");
        assertThatThrownBy(() -> new Font(new byte[] {0, 1})).hasMessage("the table of contents ends at byte 2 of the font, but should go on to byte 4");
        assertThatThrownBy(() -> new Letters(Fonts.shipped("sans").orElseThrow(), "a中", 1)).hasMessage("the font has no letter for \"中\" (U+4E2D)");
    }

    /** Cut off anywhere, or with bytes that are others: a sentence with a place, or letters; and never long. */
    @Test
    void brokenFontsGetASentenceAndNeverHang() throws IOException {
        byte[] whole = bytes("serif");
        Random random = new Random(5);
        int refused = 0;
        for (int i = 0; i < 400; i++) {
            byte[] broken = i % 2 == 0 ? Arrays.copyOf(whole, random.nextInt(whole.length)) : whole.clone();
            for (int k = 0; i % 2 != 0 && k < 1 + i / 20; k++) {
                broken[random.nextInt(random.nextBoolean() ? 400 : broken.length)] = (byte) random.nextInt();
            }
            try {
                new Letters(new Font(broken), "Žába AVÉ", 1);
            } catch (IllegalArgumentException e) {
                refused++;
                assertThat(e.getMessage()).containsAnyOf("byte", "no letter", "this ", "none of the letters", "letter path", "pieces");
            }
        }
        assertThat(refused).isGreaterThan(200);
    }

    private static byte[] bytes(String name) throws IOException {
        try (InputStream input = Objects.requireNonNull(Fonts.class.getResourceAsStream(name + ".ttf"))) {
            return input.readAllBytes();
        }
    }
}
