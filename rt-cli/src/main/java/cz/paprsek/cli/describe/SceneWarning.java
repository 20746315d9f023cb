package cz.paprsek.cli.describe;

/**
 * Something in a scene that is allowed but hardly meant.
 *
 * @param kind what kind of thing it is, for programs: one word, or some joined by dashes
 * @param object what it is about, as it is called in the message; empty for the scene as a whole
 * @param message a sentence for people
 */
public record SceneWarning(String kind, String object, String message) {}
