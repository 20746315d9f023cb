/**
 * Shapes, scenes, the scene file, the renderer and its pictures. Who only renders needs neither JAXB nor AWT; JAXB reads wrong and unusual files,
 * AWT reads and writes PNG and the other formats that the Java platform knows.
 */
@SuppressWarnings("module") // Our own programs are told from others by names that no module has yet: they run from the class path.
module cz.paprsek.core {
    requires static org.jspecify;
    requires static jakarta.xml.bind;
    requires static transitive java.desktop;
    requires java.xml;

    exports cz.paprsek.asset;
    exports cz.paprsek.image;
    exports cz.paprsek.material;
    exports cz.paprsek.math;
    exports cz.paprsek.query;
    exports cz.paprsek.ray;
    exports cz.paprsek.render;
    exports cz.paprsek.render.explain;
    exports cz.paprsek.render.film;
    exports cz.paprsek.render.mode;
    exports cz.paprsek.scene;
    exports cz.paprsek.shape;
    exports cz.paprsek.shape.check;
    exports cz.paprsek.shape.height;
    exports cz.paprsek.shape.mesh;
    exports cz.paprsek.xml;

    exports cz.paprsek.attribute to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.drawing to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.format to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.format.model to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.formula to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.image.film to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.io to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.lesson to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.origin to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.pov to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.query.text to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.render.explain.text to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.render.join to cz.paprsek.cli;
    exports cz.paprsek.render.live to cz.paprsek.fx;
    exports cz.paprsek.resume to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.shape.placed to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.sheet to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.standard to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.teach to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.teach.grade to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.teach.mistake to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.text to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.warning to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.words to cz.paprsek.cli, cz.paprsek.fx;
    exports cz.paprsek.xml.typing to cz.paprsek.fx;

    opens cz.paprsek.xml.bind to jakarta.xml.bind, org.glassfish.jaxb.core, org.glassfish.jaxb.runtime;
}
