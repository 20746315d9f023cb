/** Numbers side by side, of which the JVM reckons several by one instruction. */
@NullMarked
package cz.paprsek.render.lanes;

import org.jspecify.annotations.NullMarked;
