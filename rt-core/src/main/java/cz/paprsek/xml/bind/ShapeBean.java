package cz.paprsek.xml.bind;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Placement.Pivot;
import cz.paprsek.shape.Shape;
import cz.paprsek.xml.mistake.Problems;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import org.jspecify.annotations.Nullable;

/** What the elements of all shapes have in common. */
@XmlAccessorType(XmlAccessType.FIELD)
abstract class ShapeBean extends Located {
    @XmlAttribute String name = "";
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 rotation = Vec3.ZERO;
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Scale.class) Vec3 scale = Vec3.ONE;
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) @Nullable Vec3 pivot;
    @XmlAttribute boolean hidden;
    @XmlAttribute(name = "material") @Nullable String materialName;
    @XmlElement(name = "material") @Nullable MaterialBean ownMaterial;

    /**
     * The shape of a whole object or operand.
     *
     * @throws IllegalArgumentException with the sentence of the record that refuses
     */
    abstract Shape toShape(Problems problems);

    SceneObject toObject(Problems problems) {
        return new SceneObject(name, toShape(problems), toPlacement(), toPivot(), hidden, toMaterial(problems));
    }

    Placement toPlacement() {
        boolean plain = position.equals(Vec3.ZERO) && rotation.equals(Vec3.ZERO) && scale.equals(Vec3.ONE);
        return plain ? Placement.NONE : new Placement(position, rotation, scale);
    }

    Pivot toPivot() {
        return pivot == null ? Placement.MIDDLE : new Placement.Point(pivot);
    }

    MaterialSource toMaterial(Problems problems) {
        Require.that(materialName == null || ownMaterial == null,
                "there is a material attribute and a <material> inside; remove one of them");
        if (ownMaterial != null && !ownMaterial.name.isEmpty()) {
            problems.add(ownMaterial, "a material inside an object has no name", "name");
            throw new Problems.ToldAlready();
        }
        if (ownMaterial != null) {
            Material made = problems.make(ownMaterial, ownMaterial::toMaterial);
            if (made == null) {
                throw new Problems.ToldAlready();
            }
            return made;
        }
        return materialName == null ? Inherited.INHERITED : new MaterialName(materialName);
    }
}
