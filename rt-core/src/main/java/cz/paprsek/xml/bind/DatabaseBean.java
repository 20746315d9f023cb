package cz.paprsek.xml.bind;

import cz.paprsek.xml.mistake.Problems;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlRootElement;
import jakarta.xml.bind.annotation.XmlTransient;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** {@code <database>}. */
@XmlRootElement(name = "database")
@XmlAccessorType(XmlAccessType.FIELD)
final class DatabaseBean extends Located {
    @XmlElement(name = "scene")
    List<SceneBean> scenes = new ArrayList<>();
    @XmlTransient private final Set<String> names = new HashSet<>();

    /** To be asked for each scene once, in the order of the file. */
    void checkName(SceneBean scene, Problems problems) {
        if (scene.name.isEmpty()) {
            problems.add(scene, "a scene in a database needs a name, to be found by");
        } else if (!names.add(scene.name)) {
            problems.add(scene, "there is already a scene named \"" + scene.name + "\"; give one of them another name", "name");
        }
    }
}
