package cz.paprsek.cli.plan;

import cz.paprsek.cli.process.ExitCode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Manifests that hand a plan to Kubernetes, 1.33 or newer: an indexed job with an index for each share, each tried again by itself but not if the scene or the
 * command is wrong, and a job that waits for the parts and puts them together. Scene and parts are on a volume that all pods see.
 */
public final class Kubernetes {
    /** As many indexes as a job can have of which each is tried again by itself. */
    public static final int MOST_SHARDS = 100_000;
    private static final int TRIES = 6;
    /** A week. */
    private static final int PATIENCE = 604_800;
    private static final String FOLDER = "/work";
    /** No user of any system. */
    private static final int NOBODY = 65_532;

    private Kubernetes() {}

    /**
     * The manifests in one file.
     *
     * @param image of the container
     * @param claim name of the volume claim; empty for one of this plan's own
     */
    public static String manifests(Plan plan, String image, String claim) {
        String volume = claim.isEmpty() ? "paprsek-" + plan.label() : claim;
        String head = "# Renders " + plan.name().replaceAll("\\p{Cntrl}", "?") + " in " + plan.shards() + " shares by Kubernetes, and puts them together:\n#     kubectl apply -f " + plan.label()
                + ".kubernetes.yaml\n# The scene and what it needs are to be on the volume claim " + volume + ", as in the folder where this was planned.\n";
        String storage = claim.isEmpty() ? Yaml.of(claim(volume)) + "---\n" : "";
        return head + storage + Yaml.of(render(plan, image, volume)) + "---\n" + Yaml.of(merge(plan, image, volume));
    }

    private static Map<String, Object> claim(String name) {
        return map("apiVersion", "v1", "kind", "PersistentVolumeClaim", "metadata", map("name", name),
                "spec", map("accessModes", List.of("ReadWriteMany"), "resources", map("requests", map("storage", "20Gi"))));
    }

    private static Map<String, Object> render(Plan plan, String image, String volume) {
        String line = plan.renderLine("paprsek", "\"$((JOB_COMPLETION_INDEX + 1))/" + plan.shards() + "\"");
        Map<String, Object> rules = map("rules", List.of(wrongIn("render", List.of(ExitCode.WRONG_USAGE, ExitCode.BAD_SCENE)),
                map("action", "Ignore", "onPodConditions", List.of(map("type", "DisruptionTarget", "status", "True")))));
        return job("paprsek-" + plan.label() + "-render", map("completionMode", "Indexed", "completions", plan.shards(), "parallelism", plan.parallel(), "backoffLimitPerIndex", TRIES,
                "podFailurePolicy", rules, "template", pod(plan, "render", image, volume, line, plan.cpus())));
    }

    private static Map<String, Object> merge(Plan plan, String image, String volume) {
        Map<String, Object> rules = map("rules", List.of(wrongIn("merge", List.of(ExitCode.WRONG_USAGE, ExitCode.BAD_SCENE, ExitCode.PARTS_LACKING))));
        return job("paprsek-" + plan.label() + "-merge", map("backoffLimit", TRIES, "podFailurePolicy", rules,
                "template", pod(plan, "merge", image, volume, plan.mergeLine("paprsek") + " --wait " + PATIENCE, 1)));
    }

    /** What is wrong stays wrong: the whole job ends. */
    private static Map<String, Object> wrongIn(String container, List<Integer> codes) {
        return map("action", "FailJob", "onExitCodes", map("containerName", container, "operator", "In", "values", codes));
    }

    private static Map<String, Object> job(String name, Map<String, Object> spec) {
        return map("apiVersion", "batch/v1", "kind", "Job", "metadata", map("name", name, "labels", map("app.kubernetes.io/name", "paprsek")), "spec", spec);
    }

    private static Map<String, Object> pod(Plan plan, String container, String image, String volume, String line, int cpus) {
        Map<String, Object> memory = map("memory", plan.memory() + "Mi");
        Map<String, Object> requests = map("cpu", Integer.toString(cpus));
        requests.putAll(memory);
        Map<String, Object> one = map("name", container, "image", image, "workingDir", FOLDER,
                // A dollar is doubled, as the cluster itself would replace $(NAME).
                "command", List.of("sh", "-c", ("exec " + line).replace("$", "$$")),
                "env", List.of(map("name", "PAPRSEK_JAVA_OPTIONS", "value", plan.javaOptions(cpus))),
                "resources", map("requests", requests, "limits", memory),
                "securityContext", map("allowPrivilegeEscalation", false, "readOnlyRootFilesystem", true, "capabilities", map("drop", List.of("ALL"))),
                "volumeMounts", List.of(map("name", "work", "mountPath", FOLDER), map("name", "tmp", "mountPath", "/tmp")));
        Map<String, Object> spec = map("restartPolicy", "Never", "automountServiceAccountToken", false,
                "securityContext", map("runAsNonRoot", true, "runAsUser", NOBODY, "runAsGroup", NOBODY, "fsGroup", NOBODY, "seccompProfile", map("type", "RuntimeDefault")),
                "containers", List.of(one),
                "volumes", List.of(map("name", "work", "persistentVolumeClaim", map("claimName", volume)), map("name", "tmp", "emptyDir", Map.of())));
        return map("metadata", map("labels", map("app.kubernetes.io/name", "paprsek")), "spec", spec);
    }

    private static Map<String, Object> map(Object... members) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int i = 0; i < members.length; i += 2) {
            map.put(members[i].toString(), members[i + 1]);
        }
        return map;
    }
}
