package cz.paprsek.fx.view.manual;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Takes the text of a page apart: as much of Markdown as the manual is written in. */
final class Markdown {
    private static final Pattern HEADING = Pattern.compile("(#{1,6}) +(.*?)(?: +#+)?");
    private static final Pattern ITEM = Pattern.compile("( *)([-*]|\\d+\\.) +(.*)");
    private static final Pattern PICTURE = Pattern.compile("!\\[([^]]*)]\\(([^)\\s]+)\\)");
    private static final Pattern BETWEEN_CELLS = Pattern.compile("(?<!\\\\)\\|(?=(?:[^`]*`[^`]*`)*[^`]*$)");
    private static final Pattern RULE = Pattern.compile("\\|?[ :|-]+\\|?");
    private static final String FENCE = "```";
    private static final String INDENT = "    ";

    private final List<Block> blocks = new ArrayList<>();
    private final StringBuilder words = new StringBuilder();
    private String sign = "";

    private Markdown() {}

    static List<Block> blocks(String text) {
        Markdown page = new Markdown();
        page.read(text.lines().toList());
        return page.blocks;
    }

    private void read(List<String> lines) {
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i);
            if (line.startsWith(FENCE)) {
                int end = i + 1;
                while (end < lines.size() && !lines.get(end).startsWith(FENCE)) {
                    end++;
                }
                code(lines.subList(i + 1, end), 0);
                i = end;
            } else if (words.isEmpty() && line.startsWith(INDENT)) {
                int end = i;
                while (end < lines.size() && (lines.get(end).startsWith(INDENT) || lines.get(end).isBlank())) {
                    end++;
                }
                code(lines.subList(i, end), INDENT.length());
                i = end - 1;
            } else if (line.startsWith("|")) {
                int end = i;
                while (end < lines.size() && lines.get(end).startsWith("|")) {
                    end++;
                }
                table(lines.subList(i, end));
                i = end - 1;
            } else {
                line(line);
            }
        }
        flush();
    }

    private void line(String line) {
        Matcher heading = HEADING.matcher(line);
        Matcher item = ITEM.matcher(line);
        Matcher picture = PICTURE.matcher(line.strip());
        if (line.isBlank() || line.startsWith("<!--")) {
            flush();
        } else if (heading.matches()) {
            flush();
            blocks.add(new Block.Heading(heading.group(1).length(), Span.of(heading.group(2))));
        } else if (picture.matches()) {
            flush();
            blocks.add(new Block.Picture(picture.group(2), picture.group(1)));
        } else if (item.matches()) {
            flush();
            sign = item.group(1) + (item.group(2).length() == 1 ? "•" : item.group(2));
            words.append(item.group(3));
        } else {
            words.append(words.isEmpty() ? "" : " ").append(line.strip());
        }
    }

    private void code(List<String> lines, int indent) {
        flush();
        String text = String.join("\n", lines.stream().map(line -> line.substring(Math.min(indent, line.length()))).toList());
        blocks.add(new Block.Code(text.stripTrailing()));
    }

    private void table(List<String> lines) {
        flush();
        blocks.add(new Block.Table(lines.stream().filter(line -> !RULE.matcher(line).matches() || line.replaceAll("[| ]", "").isEmpty()).map(Markdown::cells).toList()));
    }

    private static List<List<Span>> cells(String line) {
        String inside = line.strip().replaceFirst("^\\|", "").replaceFirst("\\|$", "");
        return Arrays.stream(BETWEEN_CELLS.split(inside, -1)).map(cell -> Span.of(cell.strip())).toList();
    }

    private void flush() {
        if (!words.isEmpty()) {
            blocks.add(new Block.Paragraph(sign, Span.of(words.toString())));
        }
        words.setLength(0);
        sign = "";
    }
}
