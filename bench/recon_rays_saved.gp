# SPDX-License-Identifier: Apache-2.0
load "bench/style.gp"

set logscale xy
set xlabel "rays traced"
yLabel = "times as many rays"
set format y "%g"
chart = "recon_rays_saved"
heading = "How many times as many rays the plain picture needs to be as close"
panels = sceneCount(results."/recon_summary.csv")
panelTitle(p) = sceneNames[p]
panelPlot(p) = sprintf("plot for [i = 1:|methods|] results.'/recon_summary.csv' \
  using (strcol('scene') eq scenes[%d] && strcol('method') eq methods[i] ? column('rays') : NaN):'rays_saved' \
  with linespoints linestyle i notitle", p)
keyPlot = "plot for [i = 1:|methods|] NaN with linespoints linestyle i title names[i]"
load "bench/recon_panels.gp"
