package cz.paprsek.fx.view.manual;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.view.manual.Span.Style;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Pages taken apart. */
class MarkdownTest {
    @Test
    void allThatTheManualIsWrittenInIsUnderstood() {
        List<Block> blocks = Markdown.blocks("# A *b*\n\nOne\ntwo `x | y` **bold** [here](c.md#d).\n\n- item\n  goes on\n1. first\n\n    code\n      more\n\n| a | b |\n|---|---|\n| `p|q` | ![r](r.jpg)<br/>s |\n\n```java\nint i;\n```\n![says](p.png)\n");
        assertThat(blocks).containsExactly(
                new Block.Heading(1, List.of(new Span("A ", Style.PLAIN, ""), new Span("b", Style.ITALIC, ""))),
                new Block.Paragraph("", List.of(new Span("One two ", Style.PLAIN, ""), new Span("x | y", Style.CODE, ""), new Span(" ", Style.PLAIN, ""), new Span("bold", Style.BOLD, ""),
                        new Span(" ", Style.PLAIN, ""), new Span("here", Style.PLAIN, "c.md#d"), new Span(".", Style.PLAIN, ""))),
                new Block.Paragraph("•", List.of(new Span("item goes on", Style.PLAIN, ""))),
                new Block.Paragraph("1.", List.of(new Span("first", Style.PLAIN, ""))),
                new Block.Code("code\n  more"),
                new Block.Table(List.of(List.of(List.of(new Span("a", Style.PLAIN, "")), List.of(new Span("b", Style.PLAIN, ""))),
                        List.of(List.of(new Span("p|q", Style.CODE, "")), List.of(new Span("r", Style.PICTURE, "r.jpg"), new Span("\ns", Style.PLAIN, ""))))),
                new Block.Code("int i;"), new Block.Picture("p.png", "says"));
    }

    /** Whatever is added to the manual is in the editor, in its own language first, with all pictures and links within it. */
    @Test
    void everyPageIsShippedWithItsPicturesAndLinks() throws IOException {
        List<ManualPage> pages = ManualPage.all(Locale.ENGLISH);
        Set<String> paths = pages.stream().map(ManualPage::path).collect(Collectors.toSet());
        try (Stream<Path> english = Files.list(Path.of("../docs")); Stream<Path> czech = Files.list(Path.of("../docs/cs")); Stream<Path> decisions = Files.list(Path.of("../docs/decisions"))) {
            Set<String> there = Stream.of(english, czech, decisions).flatMap(files -> files).filter(file -> file.toString().endsWith(".md")).map(file -> Path.of("..").relativize(file).toString().replace('\\', '/')).collect(Collectors.toSet());
            there.add("README.md");
            assertThat(paths).isEqualTo(there);
        }
        assertThat(pages.stream().filter(page -> !page.isListed()).map(ManualPage::path)).as("found by links and words only").hasSizeGreaterThan(50).allMatch(path -> path.startsWith("docs/decisions/"));
        assertThat(ManualPage.all(Locale.forLanguageTag("cs")).get(0).path()).isEqualTo("docs/cs/start.md");
        for (ManualPage page : pages) {
            for (Block block : page.blocks()) {
                if (block instanceof Block.Picture picture) {
                    assertThat(page.picture(picture.file())).as("%s in %s", picture.file(), page.path()).isPresent();
                }
                if (block instanceof Block.Table table) {
                    table.rows().stream().flatMap(List::stream).flatMap(List::stream).filter(span -> span.style() == Style.PICTURE)
                            .forEach(span -> assertThat(page.picture(span.link())).as("%s in %s", span.link(), page.path()).isPresent());
                }
                // A mark that was not understood would be read as it is written.
                if (!(block instanceof Block.Code)) {
                    assertThat(block.plain()).as(page.path()).doesNotContain("](");
                }
            }
        }
    }

    @Test
    void linksLeadToAnchors() {
        ManualPage page = new ManualPage("docs/cs/editor.md", "", List.of());
        assertThat(page.resolve("../editor.md#x")).contains("docs/editor.md");
        assertThat(page.resolve("#here")).contains("docs/cs/editor.md");
        assertThat(page.resolve("https://example.org/")).isEmpty();
        assertThat(new Block.Heading(2, Span.of("Parameters, formulas, repetition")).anchor()).isEqualTo("parameters-formulas-repetition");
    }
}
