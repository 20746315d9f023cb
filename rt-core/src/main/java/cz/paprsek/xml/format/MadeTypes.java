package cz.paprsek.xml.format;

import cz.paprsek.attribute.Kind;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** What the schema of all files has beside what stands at the records: formulas, and the elements that are gone when a scene is written out. */
final class MadeTypes {
    static final String OR_FORMULA = "OrFormula";
    /** Bodies, by the names of their elements, with their types. */
    static final Map<String, String> BODIES = table("repeat", "Repeat", "instance", "Instance");
    /** What stands directly in a scene. */
    static final Map<String, String> OF_SCENE = table("param", "Param", "define", "Define", "include", "Include");

    private MadeTypes() {}

    private static Map<String, String> table(String... words) {
        Map<String, String> table = new LinkedHashMap<>();
        for (int i = 0; i < words.length; i += 2) {
            table.put(words[i], words[i + 1]);
        }
        return table;
    }

    /** Whether numbers or colours stand there. */
    static boolean takesFormulas(Kind kind) {
        return switch (kind.form()) {
            case NUMBER, WHOLE, FROM_TO, VECTOR, PAIR, SCALE, COLOR -> true;
            case TEXT, WORDS, FLAG, WORD -> false;
        };
    }

    /** For each type of numbers or colours the same with formulas. */
    static void simple(SchemaText text) {
        text.open("simpleType", "name", "formula").documentation("a text with formulas in braces, such as {2*r} or 0 {h/2} 0");
        text.open("restriction", "base", "xs:string").leaf("pattern", "value", "[^{}]*(\\{[^{}]+\\}[^{}]*)+").close("restriction").close("simpleType");
        Set<String> done = new HashSet<>();
        for (Kind kind : Kind.values()) {
            if (kind != Kind.WORD && takesFormulas(kind) && done.add(kind.type())) {
                text.open("simpleType", "name", kind.type() + OR_FORMULA).documentation(kind.words() + ", or formulas for that").leaf("union", "memberTypes", "s:" + kind.type() + " s:formula").close("simpleType");
            }
        }
    }

    /** @param surfaces names and types of the bodies that are no solids */
    static void elements(SchemaText text, List<String[]> surfaces) {
        text.open("complexType", "name", "Param").documentation("A number, or a text such as the name of a colour, that formulas may refer to.");
        attribute(text, "name", "xs:NCName", true, "Letters, digits and _.");
        attribute(text, "value", "xs:string", true, "A number, a formula in braces, or a text.");
        attribute(text, "min", "s:numberOrFormula", false, "The least that it may be.");
        attribute(text, "max", "s:numberOrFormula", false, "The most that it may be.");
        attribute(text, "step", "s:numberOrFormula", false, "By how much it is changed by hand.");
        text.close("complexType");
        text.open("complexType", "name", "Include").documentation("Brings the definitions, materials and parameters of another scene.");
        attribute(text, "file", "xs:string", true, "Its name, from this file's folder.");
        text.close("complexType");
        text.open("group", "name", "body").open("choice").leaf("group", "ref", "s:solid");
        surfaces.forEach(one -> text.leaf("element", "name", one[0], "type", "s:" + one[1]));
        text.close("choice").close("group");
        text.open("complexType", "name", "Define").documentation("A body to be used by instances.");
        text.open("sequence").leaf("group", "ref", "s:body").close("sequence");
        attribute(text, "name", "xs:string", true, "Unique among the definitions.");
        text.close("complexType");
        text.open("complexType", "name", "Instance").documentation("The body of a definition, placed.").open("complexContent").open("extension", "base", "s:Object");
        material(text, () -> {});
        attribute(text, "of", "xs:string", true, "The name of the definition.");
        text.close("extension").close("complexContent").close("complexType");
        text.open("complexType", "name", "Repeat").documentation("Bodies again and again, each copy placed relative to the one before; as an operand one solid.")
                .open("complexContent").open("extension", "base", "s:Object");
        material(text, () -> text.leaf("group", "ref", "s:body", "maxOccurs", "unbounded"));
        attribute(text, "count", "xs:string", true, "How many copies: a whole number, or a formula.");
        attribute(text, "index", "xs:NCName", false, "What formulas inside call the number of a copy, from 0; i if not given.");
        text.close("extension").close("complexContent").close("complexType");
    }

    private static void material(SchemaText text, Runnable more) {
        text.open("sequence").leaf("element", "name", "material", "type", "s:Material", "minOccurs", "0");
        more.run();
        text.close("sequence");
    }

    private static void attribute(SchemaText text, String name, String type, boolean isRequired, String means) {
        String[] attributes = isRequired ? new String[] {"name", name, "type", type, "use", "required"} : new String[] {"name", name, "type", type};
        text.open("attribute", attributes).documentation(means).close("attribute");
    }
}
