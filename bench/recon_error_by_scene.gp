# SPDX-License-Identifier: Apache-2.0
load "bench/style.gp"

set logscale xy
set xlabel "rays traced"
yLabel = "relative mean square error"
chart = "recon_error_by_scene"
heading = "Nearly the same order in other skies"
panels = sceneCount(results."/recon_summary.csv")
panelTitle(p) = sceneNames[p]
panelPlot(p) = sprintf("plot for [i = 1:|methods|] results.'/recon_summary.csv' \
  using (strcol('scene') eq scenes[%d] && strcol('method') eq methods[i] ? column('rays') : NaN):'relMSE' \
  with linespoints linestyle i notitle", p)
keyPlot = "plot for [i = 1:|methods|] NaN with linespoints linestyle i title names[i]"
load "bench/recon_panels.gp"
