package cz.paprsek.cli.plan;

import static java.util.Map.entry;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.shard.Again;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A script that hands a plan to Slurm: arrays of jobs, and one that puts the picture together when all have ended. */
public final class Slurm {
    /** Slurm's own MaxArraySize is 1001 unless it is set up otherwise. */
    private static final int LARGEST_ARRAY = 1000;

    private static final Pattern WORD = Pattern.compile("@[A-Z]+");

    private Slurm() {}

    /** @param program how Paprsek is called there */
    public static String script(Plan plan, String program) {
        String script = """
                #!/bin/sh
                # Renders @LABEL in @SHARDS shares by Slurm, and puts them together when all have ended. Start it where the scene is, in a directory that all nodes see:
                #     sh @LABEL.slurm.sh
                # Start it again after failures: parts that are there are not made again. What is missing in the end is told in @PARTS/merge.log.
                set -eu
                mkdir -p @PARTS

                ended=
                first=0
                while [ "$first" -lt @SHARDS ]; do
                    size=$((@SHARDS - first))
                    if [ "$size" -gt @LARGEST ]; then size=@LARGEST; fi
                    job=$(sbatch --parsable --job-name=paprsek-@LABEL --array="1-$size@LIMIT" --cpus-per-task=@CPUS --mem=@MEMORY --requeue \\
                        --open-mode=append --output=@PARTS/render-%A-%a.log --export=ALL,PAPRSEK_FIRST="$first" << 'END'
                #!/bin/sh
                shard=$((PAPRSEK_FIRST + SLURM_ARRAY_TASK_ID))/@SHARDS
                export PAPRSEK_JAVA_OPTIONS="${PAPRSEK_JAVA_OPTIONS:-@JAVA}"
                for attempt in 1 2 3; do
                    code=0
                    @RENDER || code=$?
                    case $code in
                        0) exit 0 ;;
                        @USAGE | @SCENE) exit "$code" ;; # what is wrong stays wrong
                    esac
                done
                exit "$code"
                END
                    )
                    ended=$ended:${job%%;*}
                    first=$((first + size))
                done

                sbatch --parsable --job-name=paprsek-@LABEL-merge --dependency="afterany$ended" --mem=@MEMORY --output=@PARTS/merge.log << 'END'
                #!/bin/sh
                export PAPRSEK_JAVA_OPTIONS="${PAPRSEK_JAVA_OPTIONS:-@ONE}"
                exec @MERGE
                END
                """;
        Map<String, String> words = Map.ofEntries(entry("@LABEL", plan.label()), entry("@SHARDS", number(plan.shards())), entry("@LARGEST", number(LARGEST_ARRAY)),
                entry("@LIMIT", plan.parallel() < plan.shards() ? "%" + plan.parallel() : ""), entry("@CPUS", number(plan.cpus())), entry("@MEMORY", plan.memory() + "M"),
                entry("@JAVA", plan.javaOptions(plan.cpus())), entry("@ONE", plan.javaOptions(1)), entry("@USAGE", number(ExitCode.WRONG_USAGE)), entry("@SCENE", number(ExitCode.BAD_SCENE)), entry("@PARTS", Again.quoted(plan.parts())),
                entry("@RENDER", plan.renderLine(program, "\"$shard\"")), entry("@MERGE", plan.mergeLine(program)));
        // All at once: what stands in a name is none of these words.
        return WORD.matcher(script).replaceAll(found -> Matcher.quoteReplacement(words.getOrDefault(found.group(), found.group())));
    }

    private static String number(int value) {
        return Integer.toString(value);
    }
}
