package cz.paprsek.render.account;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Encounter.Facet;
import cz.paprsek.render.explain.Encounter.PicturePoint;
import cz.paprsek.render.explain.Encounter.Reading;
import cz.paprsek.render.explain.Encounter.Refraction;
import cz.paprsek.render.explain.Encounter.Split;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LightTerm.Strewn;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.TracedRay.Absorption;
import cz.paprsek.render.explain.TracedRay.Medium;
import cz.paprsek.render.explain.TracedRay.SeenLight;
import cz.paprsek.render.explain.TracedRay.Sight;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.PartPaths;
import cz.paprsek.render.integrate.ShadowWalk;
import cz.paprsek.render.integrate.Witness;
import cz.paprsek.render.light.Emitters;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.Media;
import cz.paprsek.render.surface.Told;
import cz.paprsek.render.surface.World;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** What a tracer tells, written down as trees of rays. */
final class RayBook extends Witness {
    /** How many rays are written down, and how many shadow rays: more than anybody reads, and about as many as fit into the memory that Java takes by itself. */
    private static final int MOST_RAYS = 100_000;
    private static final int MOST_SHADOW_RAYS = 1_000_000;

    private final World scene;
    private final Emitters emitters;
    private final int maxDepth;
    private final LinearRgb ambient;
    private final ShadowWalk shadowWalk;
    private final BooleanSupplier stop;
    private int rays;
    private int shadowRays;
    private final Map<Integer, List<BodyAt>> paths = new HashMap<>();
    private final List<TracedRay> trees = new ArrayList<>();
    private final Deque<Draft> open = new ArrayDeque<>();
    private TracedRay.Kind kind = TracedRay.Kind.PRIMARY;
    private LinearRgb weight = LinearRgb.WHITE;
    /** What the substance around the ray at hand takes, once that is known. */
    private Optional<Absorption> absorbed = Optional.empty();
    private LinearRgb left = LinearRgb.WHITE;
    private Optional<Strewn> strewn = Optional.empty();
    /** What makes the rays, if an eye does. */
    private Optional<Eye> eye = Optional.empty();

    /**
     * An empty book.
     *
     * @param maxDepth the level of the last rays
     * @param stop whether to give up, which throws a {@link CancellationException}
     */
    RayBook(World scene, int maxDepth, BooleanSupplier stop) {
        this.scene = scene;
        emitters = scene.emitters();
        this.stop = stop;
        this.maxDepth = maxDepth;
        this.ambient = new LinearRgb(scene.ambient().linearRed(), scene.ambient().linearGreen(), scene.ambient().linearBlue());
        this.shadowWalk = new ShadowWalk(scene, this::surface);
    }

    /** Traces rays from an eye from now on. */
    void lookThrough(Eye from) {
        eye = Optional.of(from);
    }

    /** The rays from the eye traced so far. */
    List<TracedRay> trees() {
        return trees;
    }

    @Override
    public boolean hearsAll() {
        return true;
    }

    @Override
    public void following(boolean refracted, double red, double green, double blue) {
        kind = refracted ? TracedRay.Kind.REFRACTED : TracedRay.Kind.REFLECTED;
        weight = new LinearRgb(red, green, blue);
    }

    @Override
    public void missed(Level level) {
        deliver(begin(level));
    }

    @Override
    public void met(Level level) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        Finish finish = scene.parts().finish(ray.part);
        scene.map(level);
        List<Reading> readings = finish.tell(level).stream().map(RayBook::reading).toList();
        scene.map(level);
        InScene<BodyAt> surface = surface(ray.part);
        boolean flipped = ray.face < 0;
        Vec3 outwards = new Vec3(hit.nx, hit.ny, hit.nz);
        Part part = scene.parts().part(ray.part, level.copied);
        int own = flipped ? ~ray.face : ray.face;
        Encounter.Place place = new Encounter.Place(surface, face(surface, part.ownFace(own)),
                part.corners(own, hit).map(at -> new Encounter.Triangle(at.triangle(), at.part(), at.shares())), flipped, level.leaving,
                ray.max, new Vec3(hit.px, hit.py, hit.pz), level.leaving ? outwards.negated() : outwards, new Vec3(hit.sx, hit.sy, hit.sz),
                hit.u, hit.v, level.cosine, new Vec3(level.mirrorX, level.mirrorY, level.mirrorZ));
        open.push(new Draft(begin(level), place, finish.here(level), readings,
                new LinearRgb(level.colorRed, level.colorGreen, level.colorBlue), ambient,
                new ShadowWalk.Start(place.point(), hit.size, ray.part, level.leaving != flipped, level.media, ray.max <= ray.contact, false)));
        if (finish.alpha > 0) {
            Media beyond = new Media();
            scene.enterBeyond(level, finish, beyond);
            open.element().startBeyond = new ShadowWalk.Start(place.point(), hit.size, ray.part, level.leaving == flipped, beyond, false, true);
        }
    }

    private static Reading reading(Told told) {
        Optional<PicturePoint> point = told.file().isEmpty() ? Optional.empty() : Optional.of(new PicturePoint(told.file(), told.u(), told.v(), told.column(), told.row(),
                new LinearRgb(told.pointRed(), told.pointGreen(), told.pointBlue())));
        return new Reading(told.of(), told.pattern(), point, new LinearRgb(told.red(), told.green(), told.blue()));
    }

    @Override
    public void seen(Level level, int lamp) {
        TracedRay ray = begin(level);
        deliver(new TracedRay(ray.kind(), ray.level(), ray.weight(), ray.origin(), ray.direction(), ray.medium(), Optional.empty(),
                Optional.of(new SeenLight(lamp, scene.scene().lights().get(lamp).name(), level.ray.max, level.isLit && light(level).equals(LinearRgb.BLACK))), ray.sight(), ray.absorbed(), ray.light()));
    }

    @Override
    public void sought(int lamp, Arrival arrival, double facing, double visibility) {
        shadowRays = counted(shadowRays, MOST_SHADOW_RAYS, "shadow rays");
        Draft draft = open.element();
        Vec3 direction = new Vec3(arrival.x, arrival.y, arrival.z);
        boolean isSent = (facing > 0 || visibility > 0) && (arrival.red > 0 || arrival.green > 0 || arrival.blue > 0);
        ShadowWalk.Start start = facing > 0 ? draft.start : draft.startBeyond;
        draft.sought(lamp, name(lamp), new ShadowRay(target(lamp, draft, direction, arrival.distance), new LinearRgb(arrival.red, arrival.green, arrival.blue),
                direction, arrival.distance, facing, draft.place.mirrored().dot(direction), visibility,
                isSent && visibility < 1 ? shadowWalk.obstacles(start, direction, arrival.distance, lamp) : List.of(),
                left.equals(LinearRgb.WHITE) ? List.of() : shadowWalk.absorptions(start, direction, arrival.distance), left, Optional.empty(), 0, 0, LinearRgb.BLACK));
        left = LinearRgb.WHITE;
    }

    /** What a light is called, or a body or a sky that is looked for as lights are. */
    private String name(int lamp) {
        if (lamp < scene.lamps().length) {
            return scene.scene().lights().get(lamp).name();
        }
        if (!emitters.has(lamp)) {
            return "sky";
        }
        SceneObject body = scene.scene().objects().get(emitters.object(lamp));
        return body.name().isEmpty() ? body.shape().kind() + " " + (emitters.object(lamp) + 1) : body.name();
    }

    @Override
    public void dimmed(double red, double green, double blue) {
        left = new LinearRgb(red, green, blue);
    }

    /** Of a light without a size, to the last bit where it stands. */
    private Optional<Vec3> target(int lamp, Draft draft, Vec3 direction, double distance) {
        return lamp < scene.lamps().length && scene.scene().lights().get(lamp) instanceof PlacedLight placed && scene.lamps()[lamp].samples() == 1 ? Optional.of(placed.position())
                : Double.isFinite(distance) ? Optional.of(draft.place.point().plus(direction.times(distance))) : Optional.empty();
    }

    @Override
    public void strewn(double spread, double seen, double lit, double red, double green, double blue) {
        strewn = Optional.of(new Strewn(spread, seen, lit, new LinearRgb(red, green, blue)));
    }

    @Override
    public void illuminated(double diffuse, double highlight, double red, double green, double blue) {
        open.element().lit(strewn, diffuse, highlight, new LinearRgb(red, green, blue));
        strewn = Optional.empty();
    }

    @Override
    public void averaged(int lamp, double red, double green, double blue) {
        open.element().averaged(new LinearRgb(red, green, blue));
    }

    @Override
    public void bent(double from, double to, double cosine, double radicand) {
        open.element().refraction = Optional.of(new Refraction(from, to, cosine, radicand));
    }

    @Override
    public void split(double from, double to, double cosine, double beyond, double red, double green, double blue) {
        open.element().split = Optional.of(new Split(from, to, cosine, beyond, new LinearRgb(red, green, blue)));
    }

    @Override
    public void facet(double x, double y, double z, double chance, double seen) {
        open.element().facet = Optional.of(new Facet(new Vec3(x, y, z), chance, seen));
    }

    @Override
    public void emitted(double red, double green, double blue) {
        open.element().emitted = new LinearRgb(red, green, blue);
    }

    @Override
    public void absorbed(int object, double length, double red, double green, double blue) {
        absorbed = Optional.of(shadowWalk.absorption(object, length, new LinearRgb(red, green, blue)));
    }

    @Override
    public void ended(Level level) {
        deliver(open.pop().finished(takeAbsorbed(), light(level), maxDepth));
    }

    private Optional<Absorption> takeAbsorbed() {
        Optional<Absorption> taken = absorbed;
        absorbed = Optional.empty();
        return taken;
    }

    private int counted(int soFar, int most, String what) {
        if (stop.getAsBoolean()) {
            throw new CancellationException();
        }
        Require.that(soFar < most, "there are more than " + most + " " + what + ", too many to explain; ask for a lower max-depth or fewer samples");
        return soFar + 1;
    }

    private TracedRay begin(Level level) {
        rays = counted(rays, MOST_RAYS, "rays");
        Ray ray = level.ray;
        int around = level.media.innermost();
        return new TracedRay(kind, open.size() + 1, weight, new Vec3(ray.ox, ray.oy, ray.oz), new Vec3(ray.dx, ray.dy, ray.dz),
                new Medium(around < 0 ? Optional.empty() : Optional.of(new InScene<>(scene.scene(), ScenePath.body(scene.index(around)))), level.media.refractiveIndex()),
                Optional.empty(), Optional.empty(), kind == TracedRay.Kind.PRIMARY ? eye.flatMap(from -> sight(from, ray)) : Optional.empty(), takeAbsorbed(), light(level));
    }

    private Optional<Sight> sight(Eye from, Ray ray) {
        double[] told = from.tell(ray);
        if (told.length == 0) {
            return Optional.empty();
        }
        Camera camera = scene.scene().camera();
        Vec3 direction = new Vec3(ray.dx, ray.dy, ray.dz);
        Optional<Vec3> focus = Double.isInfinite(camera.focus()) ? Optional.empty()
                : Optional.of(new Vec3(ray.ox, ray.oy, ray.oz).plus(direction.times(camera.focus() / direction.dot(camera.forward()))));
        return Optional.of(new Sight(camera.lens(), told[0], told[1], focus, ray.isBlind()));
    }

    private void deliver(TracedRay ray) {
        if (open.isEmpty()) {
            trees.add(ray);
            kind = TracedRay.Kind.PRIMARY;
            weight = LinearRgb.WHITE;
        } else {
            open.element().add(ray);
        }
    }

    private static Shape.Face face(InScene<BodyAt> surface, int face) {
        return surface.part().in(surface.scene()).shape().face(face);
    }

    private InScene<BodyAt> surface(int part) {
        List<BodyAt> ofObject = paths.computeIfAbsent(scene.parts().object(part), object -> PartPaths.of(scene.scene(), scene.index(object)));
        return new InScene<>(scene.scene(), ofObject.get(scene.parts().placeInObject(part)));
    }

    private static LinearRgb light(Level level) {
        return new LinearRgb(level.red, level.green, level.blue);
    }
}
