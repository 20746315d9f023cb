package cz.paprsek.xml;

import java.io.IOException;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

/** Writes a canonical file as somebody else could have: any order, white space, quotes and prefix, and comments everywhere, each with its number. */
final class RandomLayout {
    private final Random random;
    private final StringBuilder out = new StringBuilder();
    private final String prefix;
    private final String lineBreak;
    private int comments;

    private RandomLayout(long seed) {
        random = new Random(seed);
        prefix = random.nextInt(4) == 0 ? "p:" : "";
        lineBreak = random.nextInt(3) == 0 ? "\r\n" : "\n";
    }

    static String of(String canonical, long seed) throws ParserConfigurationException, IOException, SAXException {
        RandomLayout layout = new RandomLayout(seed);
        Element root = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(canonical))).getDocumentElement();
        layout.out.append(layout.random.nextBoolean() ? "<?xml version='1.0' encoding=\"utf-8\"?>" + layout.lineBreak : "");
        layout.gap(0);
        layout.element(root, 0);
        layout.gap(0);
        return layout.out.append(layout.random.nextBoolean() ? "<?end here?>" : "").append(layout.random.nextBoolean() ? "\n \n" : "").toString();
    }

    private void gap(int level) {
        for (int i = random.nextInt(3); i > 0; i--) {
            boolean isOnLine = random.nextInt(4) > 0;
            out.append(isOnLine ? lineBreak + "\t".repeat(level) : " ");
            out.append(random.nextInt(6) == 0 ? "<?note <x a='1'/>?>" : "");
            out.append("<!-- c").append(comments++).append(random.nextInt(5) == 0 ? lineBreak + " <sphere radius=\"1\"> ' " : "").append(" -->");
        }
        out.append(random.nextInt(6) > 0 ? lineBreak.repeat(1 + random.nextInt(2)) + "\t".repeat(level) : "");
    }

    private void element(Element element, int level) {
        out.append('<').append(prefix).append(element.getTagName());
        attributes(element, level);
        List<Element> children = children(element);
        String text = children.isEmpty() ? element.getTextContent() : "";
        if (element.getTagName().equals("scene") && random.nextBoolean() && children.stream().noneMatch(child -> child.getTagName().equals("background") || child.getTagName().equals("sky"))) {
            children.add(element.getOwnerDocument().createElement("background"));
            children.get(children.size() - 1).setAttribute("color", "0 0\t0");
        }
        if (children.isEmpty() && text.isEmpty() && random.nextInt(4) > 0) {
            out.append(random.nextBoolean() ? "/>" : " />");
            return;
        }
        out.append(random.nextInt(3) == 0 ? " >" : ">");
        if (!text.isEmpty()) {
            boolean isPlain = random.nextBoolean() && !text.contains("\r") && !text.contains("]]>");
            out.append(isPlain ? "<![CDATA[" + text.replace("\n", lineBreak) + "]]>" : escaped(text));
        } else if (children.isEmpty()) {
            // White space would be too much.
            out.append(random.nextBoolean() ? "" : "<!-- c" + comments++ + "-->");
        } else {
            boolean isFree = element.getTagName().equals("scene");
            (isFree ? mixed(children) : children).forEach(child -> {
                gap(level + 1);
                element(child, level + 1);
            });
            gap(level);
        }
        out.append("</").append(prefix).append(element.getTagName()).append(random.nextInt(4) == 0 ? " >" : ">");
    }

    /** In another order, but for those of the same name, and for bodies. */
    private List<Element> mixed(List<Element> children) {
        Map<String, List<Element>> groups = new LinkedHashMap<>();
        List<String> order = new ArrayList<>();
        for (Element child : children) {
            String group = List.of("description", "render", "background", "sky", "ambient", "camera", "point-light", "material").contains(child.getTagName())
                    ? child.getTagName() : "body";
            groups.computeIfAbsent(group, name -> new ArrayList<>()).add(child);
            order.add(group);
        }
        Collections.shuffle(order, random);
        return order.stream().map(group -> Objects.requireNonNull(groups.get(group)).remove(0)).toList();
    }

    private void attributes(Element element, int level) {
        List<String> attributes = new ArrayList<>();
        for (int i = 0; i < element.getAttributes().getLength(); i++) {
            Node attribute = element.getAttributes().item(i);
            String name = attribute.getNodeName().equals("xmlns") && !prefix.isEmpty() ? "xmlns:p" : attribute.getNodeName();
            boolean isDouble = random.nextBoolean();
            String value = escaped(attribute.getNodeValue());
            attributes.add(name + (random.nextInt(5) == 0 ? " = " : "=") + (isDouble ? '"' + value + '"' : "'" + value + "'"));
        }
        boolean isBody = element.hasAttribute("radius") || (element.hasAttribute("height") && !element.getTagName().equals("render"));
        if (isBody && !element.hasAttribute("position") && random.nextBoolean()) {
            attributes.add("position=\"0  0 0.0\"");
        }
        Collections.shuffle(attributes, random);
        boolean isOnLines = random.nextInt(4) == 0;
        attributes.forEach(attribute -> out.append(isOnLines ? lineBreak + "\t".repeat(level + 2) : " ".repeat(1 + random.nextInt(2))).append(attribute));
    }

    private static List<Element> children(Element element) {
        List<Element> children = new ArrayList<>();
        for (int i = 0; i < element.getChildNodes().getLength(); i++) {
            if (element.getChildNodes().item(i) instanceof Element child) {
                children.add(child);
            }
        }
        return children;
    }

    private static String escaped(String text) {
        return text.replace("&", "&#38;").replace("<", "&lt;").replace("\"", "&quot;").replace("'", "&apos;").replace(">", "&gt;").replace("\r", "&#xd;");
    }
}
