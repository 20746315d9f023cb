/** Finding whatever can be done, selected or opened by a few letters of its name; what keys there are, and what symbols mean. Changes nothing by itself. */
package cz.paprsek.fx.view.find;
