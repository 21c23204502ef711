# SPDX-License-Identifier: Apache-2.0
# Up to four panels and a key beside them. Before loading: panelPlot(p) is the command that draws panel p, panelTitle(p)
# its title, keyPlot the command for the key, panels how many, yLabel that of the vertical axes, chart the file's stem,
# heading the title of all.

eval terminalOf(1120, 760)
set output fileOf(chart)
set multiplot title heading font ",15"
do for [p = 1:panels] {
  column = (p - 1) % 2
  row = (p - 1) / 2
  set lmargin at screen 0.075 + 0.395 * column
  set rmargin at screen 0.395 + 0.395 * column
  set tmargin at screen 0.89 - 0.46 * row
  set bmargin at screen 0.56 - 0.46 * row
  set title panelTitle(p)
  unset key
  if (column == 1) { set ylabel "" } else { set ylabel yLabel }
  eval panelPlot(p)
}
set lmargin at screen 0.81
set rmargin at screen 0.99
set tmargin at screen 0.89
set bmargin at screen 0.1
eval keyPlace
eval keyPlot
unset multiplot
