package cz.paprsek.xml.bind;

import cz.paprsek.attribute.Described;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Animation.Ease;
import cz.paprsek.scene.Animation.Turning;
import cz.paprsek.xml.format.ColorWords;
import cz.paprsek.xml.mistake.Problems;
import cz.paprsek.xml.mistake.Problems.ToldAlready;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.adapters.CollapsedStringAdapter;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** {@code <animate>}. */
@XmlAccessorType(XmlAccessType.FIELD)
final class AnimationBean extends Located {
    @XmlAttribute(required = true) String target = "";
    @XmlAttribute(required = true) String attribute = "";
    @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String turn = Described.word(Turning.ANGLES);
    @XmlAttribute String path = "";
    @XmlElement(name = "key") List<KeyBean> keys = new ArrayList<>();

    /** {@code <key>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class KeyBean extends Located {
        @XmlAttribute(required = true) double t;
        @XmlAttribute(required = true) String value = "";
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String ease = Described.word(Ease.LINEAR);

        Animation.Key toKey() {
            return new Animation.Key(t, ColorWords.asNumbers(value), Ease.valueOf(ease.toUpperCase(Locale.ROOT).replace('-', '_')));
        }
    }

    /** What is wrong with a key is told where that stands. */
    Animation toAnimation(Problems problems) {
        if (keys.isEmpty()) {
            // The schema has said so, or that those there are are wrong.
            throw new ToldAlready();
        }
        List<Animation.Key> made = new ArrayList<>();
        for (KeyBean bean : keys) {
            Animation.Key key = problems.make(bean, () -> {
                Animation.Key fresh = bean.toKey();
                if (!made.isEmpty()) {
                    Animation.checkNext(made.get(made.size() - 1), fresh);
                }
                return fresh;
            });
            if (key == null) {
                throw new ToldAlready();
            }
            made.add(key);
        }
        return new Animation(target, attribute, Turning.valueOf(turn.toUpperCase(Locale.ROOT)), path, made);
    }
}
