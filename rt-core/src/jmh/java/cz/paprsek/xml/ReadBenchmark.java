package cz.paprsek.xml;

import cz.paprsek.material.Material;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import cz.paprsek.standard.StandardScenes;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** A file of a million spheres: read and checked, beside a bare StAX loop that checks nothing and fills the same records. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(value = 1, jvmArgs = "-Xmx3g")
@Warmup(iterations = 4)
@Measurement(iterations = 7)
public class ReadBenchmark {
    private Path file;

    @Setup
    public void write() throws IOException {
        file = Files.createTempFile("cloud", ".xml");
        SceneFiles.write(StandardScenes.cloud(1_000_000), file);
    }

    @TearDown
    public void delete() throws IOException {
        Files.delete(file);
    }

    @Benchmark
    public Scene checked() throws Exception {
        return SceneFiles.read(file);
    }

    @Benchmark
    public List<SceneObject> bare() throws IOException, XMLStreamException {
        List<SceneObject> objects = new ArrayList<>();
        try (InputStream input = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
            XMLStreamReader reader = XMLInputFactory.newFactory().createXMLStreamReader(input);
            while (reader.hasNext()) {
                if (reader.next() != XMLStreamConstants.START_ELEMENT) {
                    continue;
                }
                if (reader.getLocalName().equals("sphere")) {
                    double[] position = numbers(reader, "position");
                    objects.add(SceneObject.of(new Sphere(numbers(reader, "radius")[0])).at(position[0], position[1], position[2]));
                } else if (reader.getLocalName().equals("material")) {
                    double[] color = numbers(reader, "color");
                    Material material = Material.color(color[0], color[1], color[2]).withDiffusion(numbers(reader, "diffusion")[0]);
                    if (reader.getAttributeValue(null, "specular") != null) {
                        material = material.withHighlight(numbers(reader, "specular")[0], numbers(reader, "shininess")[0]);
                    }
                    objects.set(objects.size() - 1, objects.get(objects.size() - 1).madeOf(material));
                }
            }
        }
        return objects;
    }

    private static double[] numbers(XMLStreamReader reader, String attribute) {
        return Stream.of(reader.getAttributeValue(null, attribute).split(" ")).mapToDouble(Double::parseDouble).toArray();
    }
}
