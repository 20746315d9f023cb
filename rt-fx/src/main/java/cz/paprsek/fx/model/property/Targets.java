package cz.paprsek.fx.model.property;

import cz.paprsek.fx.model.edit.Materials;
import cz.paprsek.fx.model.edit.Pivots;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import java.util.AbstractList;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.RandomAccess;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/** The kinds of target there are. */
final class Targets {
    private Targets() {}

    /** The change may be one of names. */
    private static Scene renamed(Scene scene, UnaryOperator<Scene> change) {
        return scene.changed(change, Optional::of);
    }

    /** Objects and operands. */
    record BodiesAt(List<BodyAt> places) implements Target {
        @Override
        public List<Body> read(Scene scene) {
            return places.stream().allMatch(at -> at.isIn(scene)) ? new Bodies(places, scene) : places.stream().flatMap(at -> at.find(scene).stream()).toList();
        }

        @Override
        public Optional<Spot> spot(Scene scene) {
            return places.size() == 1 ? Optional.of(Spot.of(places.get(0))) : Optional.empty();
        }

        @Override
        public Scene change(Scene scene, UnaryOperator<Record> change) {
            return renamed(scene, still -> still.with(places, (at, body) -> Pivots.kept(still, at, body, (Body) change.apply(body))));
        }
    }

    /** Made one by one: whoever asks what many have in common mostly knows after two. */
    private static final class Bodies extends AbstractList<Body> implements RandomAccess {
        private final List<BodyAt> places;
        private final Scene scene;

        Bodies(List<BodyAt> places, Scene scene) {
            this.places = places;
            this.scene = scene;
        }

        @Override
        public Body get(int index) {
            return places.get(index).in(scene);
        }

        @Override
        public int size() {
            return places.size();
        }
    }

    /** Lights. */
    record LightsAt(List<LightAt> places) implements Target {
        @Override
        public List<Record> read(Scene scene) {
            return places.stream().filter(at -> at.index() < scene.lights().size()).map(at -> (Record) scene.lights().get(at.index())).toList();
        }

        @Override
        public Optional<Spot> spot(Scene scene) {
            return places.size() == 1 ? Optional.of(Spot.of(places.get(0))) : Optional.empty();
        }

        @Override
        public Scene change(Scene scene, UnaryOperator<Record> change) {
            List<Light> lights = new ArrayList<>(scene.lights());
            places.forEach(at -> lights.set(at.index(), (Light) change.apply((Record) lights.get(at.index()))));
            return renamed(scene, still -> still.withLights(lights));
        }
    }

    /** Cameras. */
    record CamerasAt(List<CameraAt> places) implements Target {
        @Override
        public List<Camera> read(Scene scene) {
            return places.stream().filter(at -> at.index() < scene.cameras().size()).map(at -> scene.cameras().get(at.index())).toList();
        }

        @Override
        public Optional<Spot> spot(Scene scene) {
            return places.size() == 1 ? Optional.of(Spot.of(places.get(0))) : Optional.empty();
        }

        @Override
        public Scene change(Scene scene, UnaryOperator<Record> change) {
            List<Camera> cameras = new ArrayList<>(scene.cameras());
            places.forEach(at -> cameras.set(at.index(), (Camera) change.apply(cameras.get(at.index()))));
            return renamed(scene, still -> still.withCameras(cameras));
        }
    }

    /** What of a scene there is one of. */
    record Whole(Function<Scene, Record> get, BiFunction<Scene, Record, Scene> with) implements Target {
        static final Whole SCENE = new Whole(scene -> scene, (scene, fresh) -> (Scene) fresh);
        static final Whole SETTINGS = new Whole(Scene::settings, (scene, fresh) -> scene.withSettings((RenderSettings) fresh));

        @Override
        public List<Record> read(Scene scene) {
            return List.of(get.apply(scene));
        }

        @Override
        public Optional<Spot> spot(Scene scene) {
            return Optional.of(new Spot(Optional.empty(), equals(SETTINGS) ? List.of("render") : List.of()));
        }

        @Override
        public Scene change(Scene scene, UnaryOperator<Record> change) {
            return with.apply(scene, change.apply(get.apply(scene)));
        }
    }

    /** What objects and operands are made of: their own materials, and the named ones they refer to, for all that do so. */
    record MaterialsOf(List<BodyAt> places) implements Target {
        @Override
        public List<Material> read(Scene scene) {
            Stream<Material> own = new BodiesAt(places).read(scene).stream().map(Body::material)
                    .filter(Material.class::isInstance).map(Material.class::cast);
            return Stream.concat(own, new NamedMaterials(Materials.names(scene, places)).read(scene).stream()).distinct().toList();
        }

        @Override
        public Optional<Spot> spot(Scene scene) {
            Set<String> names = Materials.names(scene, places);
            return !names.isEmpty() ? new NamedMaterials(names).spot(scene)
                    : places.size() == 1 ? Optional.of(new Spot(Optional.of(places.get(0)), List.of("material"))) : Optional.empty();
        }

        @Override
        public Scene change(Scene scene, UnaryOperator<Record> change) {
            Scene named = new NamedMaterials(Materials.names(scene, places)).change(scene, change);
            return named.with(places, (at, body) ->
                    body.material() instanceof Material own ? body.madeOf((Material) change.apply(own)) : body);
        }
    }

    /** Materials by their names. A change of one that every scene knows makes it this scene's own. */
    record NamedMaterials(Set<String> names) implements Target {
        @Override
        public List<Material> read(Scene scene) {
            return names.stream().filter(name -> scene.materials().containsKey(name) || Material.ready().containsKey(name)).map(name -> material(scene.materials(), name)).toList();
        }

        @Override
        public Optional<Spot> spot(Scene scene) {
            return names.size() == 1 ? Optional.of(Spot.of(new MaterialAt(names.iterator().next()))) : Optional.empty();
        }

        @Override
        public Scene change(Scene scene, UnaryOperator<Record> change) {
            if (names.isEmpty()) {
                return scene;
            }
            Map<String, Material> materials = new LinkedHashMap<>(scene.materials());
            names.forEach(name -> materials.put(name, (Material) change.apply(material(materials, name))));
            return scene.withMaterials(materials);
        }

        private static Material material(Map<String, Material> materials, String name) {
            return new MaterialName(name).in(materials);
        }
    }
}
