/** What the editor says first: where to begin. */
package cz.paprsek.fx.view.welcome;
