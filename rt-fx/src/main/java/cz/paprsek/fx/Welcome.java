package cz.paprsek.fx;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.model.file.Settings;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.fx.view.welcome.Offer;
import cz.paprsek.fx.view.welcome.WelcomePane;
import cz.paprsek.fx.view.welcome.WelcomePane.Beginning;
import cz.paprsek.lesson.Lessons;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** What there is to begin with. */
final class Welcome {
    private static final String SETTING = "welcome";
    private static final String NO = "no";
    /** Bytes; larger files are offered without a picture. */
    private static final long LARGEST = 1 << 20;
    private static final int MOST_RECENT = 6;

    private Welcome() {}

    /** Whether it comes at the start. */
    static boolean isWanted(Settings settings) {
        return settings.get(SETTING).filter(NO::equals).isEmpty();
    }

    static void open(WelcomePane pane, Editor editor) {
        Texts texts = editor.texts();
        List<Beginning> beginnings = new ArrayList<>();
        for (String template : Templates.NEW) {
            beginnings.add(new Beginning("new-" + template, texts.of("welcome.new", texts.of("template." + template)), () -> editor.files().newFrom(template)));
        }
        beginnings.add(new Beginning("open", texts.of("welcome.open"), editor.files()::open));
        beginnings.add(new Beginning("library", texts.of("welcome.library"), editor.library()::show));
        beginnings.add(new Beginning("manual", texts.of("welcome.manual"), editor.manual()::show));
        List<Offer> recent = editor.settings().recent().stream().filter(Files::exists).limit(MOST_RECENT)
                .map(file -> new Offer(String.valueOf(file.getFileName()), file.toString(), () -> read(file), () -> editor.files().open(file))).toList();
        List<Offer> shipped = Templates.EXAMPLES.stream()
                .map(name -> new Offer(name, "", () -> new Offer.Subject(Templates.read(name), Templates.pictures()), () -> editor.files().newFrom(name))).toList();
        pane.atStart().setSelected(isWanted(editor.settings()));
        pane.atStart().setOnAction(event -> editor.settings().set(SETTING, pane.atStart().isSelected() ? "yes" : NO));
        pane.open(new Beginning("tour", texts.of("welcome.tour"), () -> editor.lessons().open(Lessons.tour())), beginnings, recent, shipped);
    }

    private static Offer.Subject read(Path file) throws IOException, SceneFileException {
        if (Files.size(file) > LARGEST || SceneFiles.isDatabase(file)) {
            throw new IOException(file + ": too large for a picture");
        }
        return new Offer.Subject(SceneFiles.read(file), Assets.beside(file));
    }
}
