package cz.paprsek.xml.mistake;

import cz.paprsek.text.Similar;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** What an author meant with a word that is not known here: one that other programs and formats use for the same, or a slip of the fingers. */
final class Wording {
    /** The words of others, in lower case and without hyphens; behind them ours. Where there are several, those that are known at the place count. */
    private static final String OF_OTHERS = """
            box cube cuboid brick parallelepiped = block
            ball globe orb = sphere
            spheroid ovoid = ellipsoid
            tube rod pipe = cylinder
            pill spherocylinder stadium roundcylinder = capsule
            pyramid frustum = cone
            ngon hexagon polygonprism = prism
            superquadric superquadrics superball = superellipsoid
            roundedbox roundbox = block
            ring donut doughnut = torus
            square quad quadrangle rect = rectangle
            circle disk = disc
            ground halfspace infiniteplane = plane
            light lamp omni omnilight bulb lightsource = point-light
            spot spotlamp spotsource = spot-light
            sun directional directionallight distantlight distant infinitelight = sun-light
            rectanglelight rectlight quadlight disclight disklight softbox panel = area-light
            balllight globelight = sphere-light
            backgroundcolor skycolor = background
            skysphere skydome environment envmap skybox = sky
            ambientlight globalambient = ambient
            eye viewpoint viewer view = camera
            image film output settings options resolution = render
            ev stops gain = exposure
            tonemapping tonemap tonemapper filmic aces reinhard = tone
            checkers checkered checkeredpattern chess cubes = checker
            board chessboard = checkerboard
            ramp blend linear = gradient
            bands strips = stripes
            bricks masonry = brick
            clouds perlin bozo fractal = noise
            colorstop key = stop
            picture texture imagemap bitmap = image
            group add join merge compound = union
            subtract subtraction minus cut = difference
            intersect common and = intersection
            texture finish pigment surface appearance mat shader bsdf = material
            comment info note text title = description
            world = scene
            parameter variable var constant = param
            loop for copy copies array = repeat
            definition def prototype = define
            reference clone = instance
            animation motion = animate
            keyframe = key
            terrain relief = height-field
            implicit isofunction = isosurface
            formula function equation = expression

            r rad = radius
            diameter = radius
            ior eta refraction n index = refractive-index
            diffuse kd lambert = diffusion
            metal metalness metallic conductor = fresnel
            glossyroughness alphag microfacet = roughness
            emissive emissivecolor glow luminous radiance emit = emission
            emissivestrength emissionintensity emissiveintensity = emission-strength
            absorption absorptioncolor transmissioncolor transmissiontint = attenuation-color
            absorptiondistance transmissiondepth atdistance = attenuation-distance
            thinwalled = thin
            phong spec ks highlight = specular
            phongsize exponent glossiness gloss hardness = shininess
            reflect mirror reflectivity reflectance kr = reflection
            opacity alpha transmit transmission transmittance translucency kt filter = transparency
            rgb rgba pigment diffusecolor basecolor basecolour colour albedo tint = color
            location center centre translate translation origin from eye pos at = position
            rotate angles orientation euler turn = rotation
            lookat to focus interest = target
            look dir view forward = direction
            fov angle fieldofview yfov vfov viewangle = fovy
            power strength brightness energy = intensity
            id label title = name
            src source href path url filename uri map texture imagefile = file
            spp antialias aa antialiasing supersampling samplesperpixel = samples
            depth maxdepth recursion recursiondepth bounces maxbounces tracelevel maxtracelevel = max-depth
            radii radiuses halfaxes = semi-axes
            axes = semi-axes
            bottomradius baseradius radius1 = radius
            radius2 = top-radius
            radius ringradius outerradius r1 = major-radius
            tuberadius innerradius r2 = minor-radius
            length = height
            corner1 lower p0 p1 = min
            corner2 upper p2 = max
            size dimensions = min max
            color1 colora white = even
            color2 colorb black = odd
            cols = columns
            """;

    /** Elements of others that nothing here stands for; behind them what to do. */
    private static final String NOT_HERE = """
            trimesh trianglemesh indexedfaceset triangle triangles polygon polyhedron facet = triangles stand in a file of their own: <mesh file="..."/>
            import use xi:include = other scene files are brought in by <include file="..."/>
            """;

    private static final Map<String, List<String>> BY_WORD = byWord();

    private Wording() {}

    /** The known word that was meant, if that can be told. */
    static Optional<String> meant(String word, Collection<String> known) {
        return ours(word, known).stream().findFirst().or(() -> Similar.nearest(word, known));
    }

    /** {@code ; the word here is "…"} or {@code ; did you mean "…"?}, or nothing. */
    static String suggestion(String word, Collection<String> known) {
        List<String> ours = ours(word, known);
        return switch (ours.size()) {
            case 0 -> Similar.suggestion(word, known);
            case 1 -> "; the word here is \"" + ours.get(0) + "\"";
            default -> "; the words here are \"" + String.join("\" and \"", ours) + "\"";
        };
    }

    /** {@code ; …}, what to do about an element that nothing here stands for; or nothing. */
    static String insteadOf(String element) {
        String plain = element.toLowerCase(Locale.ROOT);
        return NOT_HERE.lines().map(line -> line.split(" = ", 2)).filter(sides -> List.of(sides[0].split(" ")).contains(plain))
                .map(sides -> "; " + sides[1]).findFirst().orElse("");
    }

    private static List<String> ours(String word, Collection<String> known) {
        String plain = word.toLowerCase(Locale.ROOT).replaceAll("[-_.]", "");
        return BY_WORD.getOrDefault(plain, List.of()).stream().filter(known::contains).toList();
    }

    private static Map<String, List<String>> byWord() {
        Map<String, List<String>> byWord = new HashMap<>();
        for (String line : OF_OTHERS.lines().filter(text -> !text.isBlank()).toList()) {
            String[] sides = line.split(" = ", 2);
            List<String> ours = List.of(sides[1].split(" "));
            Arrays.stream(sides[0].split(" ")).forEach(word -> byWord.merge(word, ours, Wording::joined));
        }
        return byWord;
    }

    private static List<String> joined(List<String> some, List<String> more) {
        return Stream.concat(some.stream(), more.stream()).distinct().toList();
    }
}
