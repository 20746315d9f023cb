/**
 * Scenes that are made: of parameters, formulas, repetition, definitions and files that are included. Writes them out as scenes without any of that, which
 * the readers read as all others, and says which of the elements written each stems from. What becomes of formulas when the scene is changed.
 */
@NullMarked
package cz.paprsek.xml.recipe;

import org.jspecify.annotations.NullMarked;
