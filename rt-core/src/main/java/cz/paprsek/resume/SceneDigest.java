package cz.paprsek.resume;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.TreeMap;

/** A digest of a scene and of all that it is made of: two that have the same look the same, at any time. */
public final class SceneDigest {
    private SceneDigest() {}

    /**
     * SHA-256 in hexadecimal digits. The text of a scene only names the scenes that it includes, so theirs count too; parts are told apart by how long they are.
     *
     * @param assets the files that the scene needs, read already
     * @param more what else makes a difference
     */
    public static String of(Scene scene, Assets assets, String... more) {
        MessageDigest digest = sha256();
        add(digest, assets.digest());
        add(digest, SceneFiles.format(scene));
        new TreeMap<>(scene.recipe().included()).forEach((name, text) -> {
            add(digest, name);
            add(digest, text);
        });
        List.of(more).forEach(text -> add(digest, text));
        return HexFormat.of().formatHex(digest.digest());
    }

    /** SHA-256 of a text in UTF-8, in hexadecimal digits. */
    public static String ofText(String text) {
        return HexFormat.of().formatHex(sha256().digest(text.getBytes(StandardCharsets.UTF_8)));
    }

    private static void add(MessageDigest digest, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        digest.update((bytes.length + "\n").getBytes(StandardCharsets.UTF_8));
        digest.update(bytes);
    }

    /** SHA-256 that nothing has been added to. */
    public static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
