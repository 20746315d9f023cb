package cz.paprsek.fx;

import cz.paprsek.fx.view.shell.MessageBar;
import cz.paprsek.xml.Problem;
import java.util.List;

/** Tells the user something without stopping anything. */
interface Notices {
    /** Says a sentence in the status bar. */
    void say(String sentence);

    /** Says a sentence at the top of the window, with answers to choose from. */
    void ask(String sentence, List<MessageBar.Choice> choices);

    /** Lists what is wrong with a file. */
    void problems(String header, List<Problem> problems);

    /** Takes back what was asked or listed. */
    void quiet();
}
