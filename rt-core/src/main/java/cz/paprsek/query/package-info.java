/**
 * Scenes as tables of typed columns, and the language that filters them. The language knows tables only; what tables there are stands in
 * {@link cz.paprsek.query.SceneTables}. Knows no files and no pictures.
 */
@NullMarked
package cz.paprsek.query;

import org.jspecify.annotations.NullMarked;
