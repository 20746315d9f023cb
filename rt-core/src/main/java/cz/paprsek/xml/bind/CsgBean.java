package cz.paprsek.xml.bind;

import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Csg.Operation;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.xml.mistake.Problems;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElementRef;
import jakarta.xml.bind.annotation.XmlRootElement;
import java.util.ArrayList;
import java.util.List;

/** {@code <union>}, {@code <difference>} and {@code <intersection>}. */
@XmlAccessorType(XmlAccessType.FIELD)
abstract class CsgBean extends ShapeBean {
    @XmlElementRef List<ShapeBean> operands = new ArrayList<>();

    abstract Operation operation();

    @Override
    Shape toShape(Problems problems) {
        List<Operand> made = new ArrayList<>();
        for (ShapeBean bean : operands) {
            Operand operand = problems.make(bean,
                    () -> new Operand(bean.name, (Solid) bean.toShape(problems), bean.toPlacement(), bean.toPivot(), bean.hidden, bean.toMaterial(problems)));
            if (operand != null) {
                made.add(operand);
            }
        }
        if (made.isEmpty() || made.size() < operands.size()) {
            // The schema sees to it that there is an operand; one that is missing here was refused.
            throw new Problems.ToldAlready();
        }
        return new Csg(operation(), made);
    }

    @XmlRootElement(name = "union")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class UnionBean extends CsgBean {
        @Override
        Operation operation() {
            return Operation.UNION;
        }
    }

    @XmlRootElement(name = "difference")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class DifferenceBean extends CsgBean {
        @Override
        Operation operation() {
            return Operation.DIFFERENCE;
        }
    }

    @XmlRootElement(name = "intersection")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class IntersectionBean extends CsgBean {
        @Override
        Operation operation() {
            return Operation.INTERSECTION;
        }
    }
}
