package cz.paprsek.xml;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlRootElement;
import java.util.ArrayList;
import java.util.List;

/** {@code <database>}. */
@XmlRootElement(name = "database")
@XmlAccessorType(XmlAccessType.FIELD)
final class DatabaseBean extends Located {
    @XmlElement(name = "scene")
    List<SceneBean> scenes = new ArrayList<>();
}
