package cz.paprsek.xml.bind;

import jakarta.xml.bind.annotation.XmlTransient;

/** A bean that remembers where in the file its element starts. */
@XmlTransient
abstract class Located {
    @XmlTransient
    int line;
    @XmlTransient
    int column;
}
