package cz.paprsek.xml.mistake;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Says in our words why the parser finds a text to be no XML. The parser is told to speak English, whatever the machine speaks. */
public final class Malformed {
    /** The parser's sentence, and ours; {0} is the element that is open. */
    private static final Map<Pattern, String> SENTENCES = new LinkedHashMap<>();

    static {
        say("The element type \"(.+?)\" must be terminated by the matching end-tag.*", "<$1> must be closed before this; add </$1>");
        say("XML document structures must start and end within the same entity.*", "the file ends in the middle of <{0}>; is it cut off?");
        say("Attribute \"(.+?)\" was already specified for element \"(.+?)\".*", "<$2> has the attribute \"$1\" twice; remove one of them");
        say("Attribute \"(.+?)\" bound to namespace \".*", "an element has the attribute \"$1\" twice; remove one of them");
        say("Open quote is expected for attribute \"(.+?)\" associated with an +element type +\"(.+?)\".*",
                "the value of $2 $1 must stand in quotes, as in $1=\"…\"");
        say("Attribute name \"(.+?)\" associated with an element type \"(.+?)\" must be followed by the ' = '.*",
                "$2 $1 needs a value, as in $1=\"…\"");
        say("The value of attribute \"(.+?)\" associated with an element type \"(.+?)\" must not contain the '<'.*",
                "the value of $2 $1 must not contain <; is a quote missing?");
        say("Element type \"(.+?)\" must be followed by either attribute specifications.*",
                "the tag <$1> must go on with an attribute or end with > or />; is a blank or a quote missing?");
        say("The end-tag for element type \"(.+?)\" must end with a '>'.*", "the tag </$1> must end with >");
        say("The (markup in the document following the root element must be well-formed|.*trailing section).*",
                "nothing may follow the end of the first element");
        say("Content is not allowed in trailing section.*", "nothing may follow the end of the first element");
        say("The content of elements must consist of well-formed character data or markup.*",
                "a < must be followed by the name of an element; write &lt; for the sign itself");
        say("The entity \"(.+?)\" was referenced, but not declared.*",
                "&$1; is not known here; only &amp; &lt; &gt; &quot; &apos; and numbers such as &#233; are");
        say("(The entity name must immediately follow the '&'|The reference to entity \").*",
                "a & must start something like &amp;, which is how the sign itself is written");
        say("(An invalid XML character|Character reference \"&#|A character reference|The (decimal|hexadecimal) representation must).*",
                "here is a character that XML does not allow; remove it");
        say("The prefix \"(.+?)\" for (element|attribute) \".*", "the prefix $1: is not declared; write the name without it");
        say("The string \"--\" is not permitted within comments.*", "a comment must not contain --");
        say("The character sequence \"\\]\\]>\".*", "a text must not contain ]]>");
        say("The processing instruction target matching.*", "<?xml …?> must be the very first thing in a file");
        say("XML version \"(.+?)\" is not supported.*", "XML version $1 is not supported; write version=\"1.0\"");
        say("(?s)JAXP.*more than \"([0-9,]+)\" attributes.*", "an element must not have more than $1 attributes");
        say("(?s)JAXP.*", "here is a name of more than 1000 characters, or something else beyond all measure");
    }

    private Malformed() {}

    private static void say(String theirs, String ours) {
        SENTENCES.put(Pattern.compile(theirs, Pattern.DOTALL), ours);
    }

    /** Whether the parser complains of bytes, not of characters. */
    public static boolean isAboutEncoding(String theirs) {
        return theirs.startsWith("Invalid byte") || theirs.startsWith("Expected byte") || theirs.startsWith("Byte \"")
                || theirs.startsWith("Invalid encoding name") || theirs.startsWith("The encoding") || theirs.startsWith("High surrogate");
    }

    public static String sentence(String theirs, String openElement) {
        for (Map.Entry<Pattern, String> entry : SENTENCES.entrySet()) {
            Matcher matcher = entry.getKey().matcher(theirs);
            if (matcher.matches()) {
                return matcher.replaceFirst(entry.getValue()).replace("{0}", openElement);
            }
        }
        return "this is not well-formed XML";
    }
}
