package cz.paprsek.fx;

import cz.paprsek.fx.view.shell.MessageBar;
import cz.paprsek.xml.Problem;
import java.util.List;

/** Tells the user something without stopping anything. */
interface Notices {
    /** Says a sentence in the status bar, as it is: in the language of the window. */
    void say(String sentence);

    /** Says in the status bar, in the language of the window, what the library or the model has said in English of something that is wrong. */
    void wrong(String english);

    /** Says a sentence at the top of the window, as it is, with answers to choose from. */
    void ask(String sentence, List<MessageBar.Choice> choices);

    /** Lists what is wrong with a file, in place of what was listed before; nothing, if there is nothing to list. */
    void problems(String header, List<Problem> problems);

    /** Takes back what was asked or listed. */
    void quiet();
}
