import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.launcher.Launcher;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

/** Runs the tests of some classes, one class after the other, until the first fails, and says which that is. Surefire would run all the others, too. */
public final class FirstFailure {
    private FirstFailure() {}

    public static void main(String[] classes) {
        Launcher launcher = LauncherFactory.create();
        for (String name : classes) {
            launcher.execute(LauncherDiscoveryRequestBuilder.request().selectors(selectClass(name)).build(), new TestExecutionListener() {
                @Override
                public void executionFinished(TestIdentifier test, TestExecutionResult result) {
                    if (result.getStatus() == TestExecutionResult.Status.FAILED) {
                        System.out.println("noticed by " + name.substring(name.lastIndexOf('.') + 1) + ", " + test.getLegacyReportingName());
                        System.out.flush();
                        Runtime.getRuntime().halt(0);
                    }
                }
            });
        }
        System.out.println("NOT NOTICED");
    }
}
