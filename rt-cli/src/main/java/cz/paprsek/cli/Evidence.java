package cz.paprsek.cli;

import cz.paprsek.cli.input.Originals;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Words;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Where the evidence of each picture goes. */
final class Evidence {
    private final Map<Path, Path> targets = new HashMap<>();

    /**
     * @param wish a file, or a directory, which ends in /; empty for no evidence
     * @throws WrongUsage if two pictures would have the same file, or one, or the scene, would be written over
     */
    Evidence(Optional<String> wish, Path scene, List<Path> pictures) {
        wish.ifPresent(place -> {
            boolean isFolder = place.endsWith("/");
            if (pictures.size() > 1 && !isFolder) {
                throw new WrongUsage("evidence of " + pictures.size() + " pictures does not fit into " + place + "; name a directory that ends in /");
            }
            pictures.forEach(picture -> add(picture, isFolder ? Path.of(place, stem(picture) + ".png") : Words.path(place)));
            for (Path target : targets.values()) {
                Originals.spare(target, "evidence", "the picture", pictures);
                Originals.spare(target, "evidence", "the scene", List.of(scene));
            }
        });
    }

    /** @throws WrongUsage if one would be written over a file that the scene needs */
    void spare(List<Path> own) {
        targets.values().forEach(target -> Originals.spare(target, "evidence", "the scene's own", own));
    }

    private void add(Path picture, Path target) {
        targets.forEach((other, taken) -> {
            if (taken.equals(target)) {
                throw new WrongUsage("evidence of " + other + " and of " + picture + " would both be " + target + "; grade them one by one");
            }
        });
        targets.put(picture, target);
    }

    /** The file's name without what says its format. */
    private static String stem(Path picture) {
        String name = String.valueOf(picture.getFileName());
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }

    /** Empty if none is wanted. */
    Optional<Path> of(Path picture) {
        return Optional.ofNullable(targets.get(picture));
    }
}
