package cz.paprsek.fx.view.manual;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A page of the manual.
 *
 * @param path of its file, from the folder of the project, such as "docs/editor.md"
 */
record ManualPage(String path, String title, List<Block> blocks) {
    private static final String FOLDER = "/cz/paprsek/fx/manual/";
    private static final List<String> ENGLISH = List.of("README.md", "docs/editor.md", "docs/scene-file.md", "docs/elements.md", "docs/materials.md", "docs/gallery.md", "docs/scenes.md", "docs/models.md",
            "docs/explain.md", "docs/lessons.md", "docs/what-went-wrong.md", "docs/textbooks.md", "docs/database.md", "docs/command-line.md", "docs/povray.md", "docs/library.md",
            "docs/performance.md", "docs/measured.md", "docs/cluster.md", "docs/proofs.md", "docs/architecture.md", "docs/decisions.md");
    private static final List<String> CZECH = List.of("docs/cs/start.md", "docs/cs/editor.md", "docs/cs/scene-file.md", "docs/cs/explain.md", "docs/cs/lessons.md");

    /** Where decisions are listed: each is a page of its own, which is found by its link or its words. */
    private static final String DECISIONS = "docs/decisions.md";

    /** All pages, those in the language first, and those that are not listed last. What is not there in Czech is there in English. */
    static List<ManualPage> all(Locale language) {
        boolean isCzech = language.getLanguage().equals("cs");
        List<ManualPage> listed = (isCzech ? Stream.concat(CZECH.stream(), ENGLISH.stream()) : Stream.concat(ENGLISH.stream(), CZECH.stream())).map(ManualPage::read).toList();
        return Stream.concat(listed.stream(), listed.stream().filter(page -> page.path().equals(DECISIONS)).flatMap(ManualPage::below)).toList();
    }

    /** The pages in the folder of its name that it links to. */
    private Stream<ManualPage> below() {
        String folder = path.replaceFirst("\\.md$", "/");
        return blocks.stream().filter(Block.Paragraph.class::isInstance).flatMap(block -> ((Block.Paragraph) block).text().stream()).flatMap(span -> resolve(span.link()).stream())
                .filter(found -> found.startsWith(folder)).distinct().map(ManualPage::read);
    }

    /** Whether it stands among the names beside the pages, rather than being found by a link or a word only. */
    boolean isListed() {
        return ENGLISH.contains(path) || CZECH.contains(path);
    }

    /** Whether it is written in that language. */
    boolean isIn(Locale language) {
        return CZECH.contains(path) == language.getLanguage().equals("cs");
    }

    private static ManualPage read(String path) {
        try (InputStream input = Objects.requireNonNull(ManualPage.class.getResourceAsStream(FOLDER + path), path + " is missing")) {
            List<Block> blocks = Markdown.blocks(new String(input.readAllBytes(), StandardCharsets.UTF_8));
            return new ManualPage(path, blocks.stream().filter(Block.Heading.class::isInstance).map(Block::plain).findFirst().orElse(path), blocks);
        } catch (IOException e) {
            throw new IllegalStateException(path + " in the program's own jar cannot be read", e);
        }
    }

    /** The path of a file that is named relative to this page; empty for what is not of the project. */
    Optional<String> resolve(String link) {
        String file = link.replaceFirst("#.*", "");
        if (link.contains("://") || link.startsWith("mailto:")) {
            return Optional.empty();
        }
        return Optional.of(file.isEmpty() ? path : URI.create(path).resolve(file).toString());
    }

    /** Where a picture is that is named relative to this page. */
    Optional<URL> picture(String link) {
        return resolve(link).flatMap(found -> Optional.ofNullable(ManualPage.class.getResource(FOLDER + found)));
    }

    /** Whether all words stand in it, in whatever case. */
    boolean has(List<String> words) {
        return words.stream().allMatch(word -> title.toLowerCase(Locale.ROOT).contains(word) || blocks.stream().anyMatch(block -> block.plain().toLowerCase(Locale.ROOT).contains(word)));
    }
}
