/** Questions in windows of their own, and the windows behind them. */
@NullMarked
package cz.paprsek.fx.view.dialog;

import org.jspecify.annotations.NullMarked;
