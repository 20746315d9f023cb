package cz.paprsek.fx.view.manual;

import java.util.List;
import java.util.stream.Collectors;

/** A piece of a page, from top to bottom. */
sealed interface Block {
    /** Its words without marks, for who looks for some. */
    String plain();

    /** @param level from 1 */
    record Heading(int level, List<Span> text) implements Block {
        @Override
        public String plain() {
            return Span.plain(text);
        }

        /** The name that links lead to: letters and digits in lower case, with hyphens for blanks. */
        String anchor() {
            return plain().toLowerCase(java.util.Locale.ROOT).replaceAll("[^\\p{L}\\p{N} _-]", "").replace(' ', '-');
        }
    }

    /** @param sign that of a line in a list, such as a bullet or a number; empty for none */
    record Paragraph(String sign, List<Span> text) implements Block {
        @Override
        public String plain() {
            return Span.plain(text);
        }
    }

    /** Lines that stand as they are. */
    record Code(String text) implements Block {
        @Override
        public String plain() {
            return text;
        }
    }

    /** The first row is that of headers, which may all be empty. */
    record Table(List<List<List<Span>>> rows) implements Block {
        @Override
        public String plain() {
            return rows.stream().map(row -> row.stream().map(Span::plain).collect(Collectors.joining(" | "))).collect(Collectors.joining("\n"));
        }
    }

    /** @param file relative to the page */
    record Picture(String file, String says) implements Block {
        @Override
        public String plain() {
            return says;
        }
    }
}
