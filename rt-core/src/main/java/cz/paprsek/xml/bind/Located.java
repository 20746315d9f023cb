package cz.paprsek.xml.bind;

import cz.paprsek.xml.mistake.Problems;
import jakarta.xml.bind.annotation.XmlTransient;

/** A bean that remembers where in the file its element starts. */
@XmlTransient
abstract class Located implements Problems.Place {
    @XmlTransient
    int line;
    @XmlTransient
    int column;

    @Override
    public final int line() {
        return line;
    }

    @Override
    public final int column() {
        return column;
    }
}
