package cz.paprsek.words;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.query.Filter;
import cz.paprsek.query.FilterException;
import cz.paprsek.query.SceneTables;
import cz.paprsek.scene.Light;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is wrong, told in Czech; the sentences come from files and records that are wrong. */
class SentencesTest {
    private static final Words CZECH = Words.in(Locale.forLanguageTag("cs"));

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            torus major-radius must be a finite number above 0, but is -1.0            | anuloid, poloměr prstence: má být konečné číslo větší než 0, ale je -1.0
            sphere rotation must be three finite numbers, x y z, but has 2: "1 2"      | koule, natočení: má být tři konečná čísla, x y z, ale má 2: "1 2"
            reflection must be a number from 0 to 1, but is 2.0                        | zrcadlení: má být číslo od 0 do 1, ale je 2.0
            there is no material named "gols"; did you mean "gold"?                    | není tu materiál se jménem "gols"; nemyslíte "gold"?
            there is already an object named "a {1} b" here; give one of them another name | předmět se jménem "a {1} b" tu už je; dejte jednomu z nich jiné jméno
            <sphere> has no attribute "shade"                                          | <sphere> nemá atribut "shade"
            a worksheet is about single rays, not paths: integrator must be whitted    | pracovní list je o jednotlivých paprscích, ne o cestách: integrator má být whitted
            no other pixel is like 3,4, whose rays meet the same: choose one that has such neighbours | žádný jiný bod není jako 3,4, aby jeho paprsky potkaly totéž: zvolte bod, který má takové sousedy
            nothing is repeated in the scene, and no definition used                   | ve scéně se nic neopakuje a není použita žádná definice
            column 5: the end or an operation must stand here, but "m" was found       | sloupec 5: tady má stát konec nebo operace, ale je tu "m"
            frame 41: sphere radius must be a finite number above 0, but is -0.6       | snímek 41: koule, poloměr: má být konečné číslo větší než 0, ale je -0.6
            "pictures/oak.png": there is no such file beside the scene                 | "pictures/oak.png": vedle scény takový soubor není
            /home/eva/picture.properties: is damaged                                   | /home/eva/picture.properties: je poškozen
            a rectangle has no inside, so <difference> cannot use it; give it a <block> | obdélník nemá vnitřek, a tak ho <difference> nemůže použít; dejte mu <block>
            <scene> must hold elements of the namespace urn:paprsek:scene:1 only, but here is <foo> of "u" | <scene> má obsahovat jen prvky jmenného prostoru urn:paprsek:scene:1, ale tady je <foo> z "u"
            this is text in UTF-16, but the file claims to be US-ASCII; save it as UTF-8 | toto je text v UTF-16, ale soubor o sobě uvádí US-ASCII; uložte ho v UTF-8
            this is not a scene file: it should start with <scene xmlns="urn:paprsek:scene:1"> | toto není soubor scény: měl by začínat <scene xmlns="urn:paprsek:scene:1">
            at byte 8, in the table loca, places of more than 3 glyphs must stand, but 2 was found | u bajtu 8, v tabulce loca, má stát místa více než 3 glyfů, ale je tu 2
            a whole number from 1 to 16, of paths to 1000000, or two such as 2..8 | celé číslo od 1 do 16, u cest do 1000000, nebo dvě jako 2..8
            "short.ttf": the table of contents ends at byte 4 of the font, but should go on to byte 6 | "short.ttf": obsah písma končí u bajtu 4, ale má jít až k bajtu 6
            "m.gltf": byte 26: here must be "}", but is the end                        | "m.gltf": bajt 26: tady má být "}", ale je konec
            "m.ply": line 2: the format must be ascii, binary_little_endian or binary_big_endian, but is "foo" | "m.ply": řádek 2: formát má být ascii, binary_little_endian nebo binary_big_endian, ale je "foo"
            "a.png": a picture of 9 × 9 pixels does not fit into a file of 12 bytes: it is cut off or damaged | "a.png": obrázek 9 × 9 bodů se nevejde do souboru o 12 bajtech: je useknutý nebo poškozený
            what a list holds does not fit into a file of 12 bytes: it is cut off or damaged | what a list holds does not fit into a file of 12 bytes: it is cut off or damaged
            gizmo must be round, but is 3.0                                            | gizmo must be round, but is 3.0
            sphere radius must be rounder than this, but is 3.0                        | sphere radius must be rounder than this, but is 3.0
            <sphere> must hold what nobody has translated                              | <sphere> must hold what nobody has translated
            box of eva: is damaged                                                     | box of eva: is damaged
            /home/the eva/box of eva.xml: is damaged                                   | /home/the eva/box of eva.xml: je poškozen
            a sentence that nobody has translated                                      | a sentence that nobody has translated
            """)
    void aSentenceIsSaidInCzech(String english, String czech) {
        assertThat(CZECH.sentence(english)).isEqualTo(czech);
        assertThat(Words.ENGLISH.sentence(english)).isEqualTo(english);
    }

    static Stream<String> files() {
        List<String> files = new ArrayList<>();
        Stream.of(ElementTable.of(Shape.class).filter(type -> type != Csg.class), ElementTable.of(Light.class)).flatMap(some -> some).forEach(type ->
                Described.of(type).stream().filter(Described::isNumber).forEach(one -> files.add("<" + ElementTable.name(type) + " " + one.name() + "='-1'/>")));
        Described.of(Material.class).stream().filter(Described::isNumber).forEach(one -> files.add("<material name='m' " + one.name() + "='-1'/>"));
        ElementTable.of(Pattern.class).forEach(type -> Described.of(type).stream().filter(Described::isNumber).forEach(one ->
                files.add("<material name='m'><" + ElementTable.name(type) + " " + one.name() + "='-1'/></material>")));
        files.addAll(List.of("<sphere radius='1' scale='0'/>", "<sphere radius='1' position='1 2'/>", "<block min='0 0 0' max='1 1 1' rounding='2'/>",
                "<block min='1 1 1' max='0 0 0'/>", "<rectangle min='1 1' max='0 0'/>", "<cone radius='0' height='1'/>", "<sphere radius='1' material='m'/>",
                "<sphere radius='1' name='a'/><sphere radius='1' name='a'/>", "<sphere radius='1'><material color='reed'/></sphere>", "<spere radius='1'/>",
                "<union/>", "<sphere radius='1'><material><checkerboard columns='2' rows='2'/></material></sphere>", "<sphere radius='1'>text</sphere>",
                "<point-light position='0 0 0' name='l'/><point-light position='0 0 0' name='l'/>", "<disc radius='1'><sphere radius='1'/></disc>",
                "<sphere radius=1/>", "<sphere radius='1' x/>", "<sphere radius='1'y='2'/>", "<sphere radius='1' radius='2'/>", "<sphere radius='<'/>", "<union>", "<sphere", "< sphere/>", "&nbsp;", "a & b", "<!-- -- -->",
                "<sphere radius='x0.9'/>", "<sphere radius='1,5'/>", "<sphere radius='1cm'/>", "<sphere radius='1' rotation='90°'/>", "<sphere radius='1' position='1, 2, 3'/>",
                "<sphere radius='1'><material color='rgb &lt;1, 0, 0&gt;'/></sphere>", "<sphere radius='1'><material color='ff8000'/></sphere>",
                "<sphere radius='1'><material color='#ff8000ff'/></sphere>", "<sphere radius='1'><material diffusion='50%'/></sphere>",
                "<a:sphere radius='1'/>", "]]>", "</scene><scene>", "<sphere radius='1'></sphere", "<?xml version='1.0'?>"));
        return files.stream();
    }

    /** Every number that is out of its range, every rule between the parts of a scene. */
    @ParameterizedTest
    @MethodSource("files")
    void whatIsWrongWithAFileIsSaidInCzech(String element) {
        SceneFileException wrong = catchThrowableOfType(SceneFileException.class, () -> SceneFiles.parse("<scene xmlns='" + SceneFiles.NAMESPACE
                + "'><camera position='0 0 5' direction='0 0 -1'/>" + element + "</scene>"));
        for (Problem problem : wrong.problems()) {
            assertThat(CZECH.sentence(problem.message())).as(problem.message()).isNotEqualTo(problem.message())
                    .doesNotContainPattern("(?U)\\b(must|but|has|is|there|here|this|number|needs|not|the|of|only|numbers|write|stands|colours|colour)\\b(?![^<]*>)");
        }
    }

    /** What the library finds wrong is said by its records in the same words. */
    @Test
    void aRecordIsUnderstoodAsWell() {
        IllegalArgumentException refused = catchThrowableOfType(IllegalArgumentException.class, () -> Light.at(0, 0, 0).withIntensity(-1));
        assertThat(CZECH.sentence(String.valueOf(refused.getMessage()))).isEqualTo("světlo, intenzita: má být konečné číslo, nejméně 0, ale je -1");
    }

    /** Their lines of derivations are formulas, or sentences with formulas in them. */
    @Test
    void whatGoesWrongIsSaidInCzech() {
        for (Mistake mistake : Mistake.values()) {
            assertThat(mistake.right(CZECH) + " / " + mistake.wrong(CZECH)).as("%s", mistake).doesNotContainPattern("(?U)\\b(the|of|is|it|if|no|all|once|each|first|in|and|column|colour|red|levels)\\b|\\d\\.\\d");
            assertThat(mistake.wrong(Words.ENGLISH)).isNotEqualTo(mistake.right(Words.ENGLISH));
        }
        assertThat(Mistake.BEHIND.right(CZECH)).isEqualTo("nejmenší t > 0");
        assertThat(Mistake.NO_DIFFUSE.right(CZECH)).isEqualTo(Mistake.NO_DIFFUSE.right(Words.ENGLISH));
    }

    @ParameterizedTest
    @ValueSource(strings = {"radiuss > 1", "quux > 1", "kind = sphere", "radius like \"a\"", "position = 3", "position < \"1 2 3\"", "radius = \"a\"", "radius ! 3", "(radius = 1", "radius", "name = \"a", "name = 3", "radius.x = 1",
        "position.w = 1", "exists(sphere)", "position = \"1 2\"", "radius in 3", "radius in (3 4)", "= 3", "radius = 1 radius", "1x = radius", "radius & 3"})
    void whatIsWrongWithAFilterIsSaidInCzech(String filter) {
        FilterException wrong = catchThrowableOfType(FilterException.class, () -> Filter.parse(filter, SceneTables.named("object").table()));
        assertThat(CZECH.sentence(String.valueOf(wrong.getMessage())).replaceAll("\"[^\"]*\"|: \\w+, .*|jsou tu .*", "")).as(wrong.getMessage()).startsWith("znak ")
                .doesNotContainPattern("(?U)\\b(expected|but|found|is|there|this|needs|the|of|write|compare|which|only|means)\\b");
    }

    @Test
    void noKindOfNumberIsLeftInEnglish() {
        for (Kind kind : Kind.values()) {
            assertThat(kind == Kind.WORD || !CZECH.sentence(kind.words()).equals(kind.words())).as(kind.words()).isTrue();
        }
    }

    @Test
    void numbersHaveTheSignOfTheLanguageAndNamesStay() {
        assertThat(Words.in(Locale.forLanguageTag("cs")).figures("P = (0, 3.2, −8.5) + 10.58·(−0.199, 0, 1.5·10⁻⁷) of ball \"1.5, 2\", kD 0.8, n 50"))
                .isEqualTo("P = (0; 3,2; −8,5) + 10,58·(−0,199; 0; 1,5·10⁻⁷) of ball \"1.5, 2\", kD 0,8, n 50");
        assertThat(Words.ENGLISH.figures("(0, 3.2)")).isEqualTo("(0, 3.2)");
    }
}
