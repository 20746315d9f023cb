/**
 * The tree of the scene's camera, lights and objects, operands within their operations. Changes nothing but through the editor's model.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.tree;
