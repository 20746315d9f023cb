/** The window of the scene database: scenes as thumbnails, everything as tables. */
package cz.paprsek.fx.view.library;
