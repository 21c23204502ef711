# SPDX-License-Identifier: Apache-2.0
load "bench/style.gp"

set logscale xy
set xlabel "seconds of the reconstruction"
yLabel = "relative mean square error"
set format x "%g"
chart = "recon_error_by_time"
heading = "What a method costs, and what it gives (512×512 pixels; lower left is better)"
panels = rayCounts(results."/recon_summary.csv")
panelTitle(p) = sprintf("10^{%d} rays", p + 3)
panelPlot(p) = sprintf("plot for [i = 1:|methods|] results.'/recon_summary.csv' \
  using (strcol('scene') eq scenes[1] && strcol('method') eq methods[i] && column('rays') == 10 ** %d \
    ? column('seconds') : NaN):'relMSE' with points linestyle i pointsize 1.6 notitle", p + 3)
keyPlot = "plot for [i = 1:|methods|] NaN with points linestyle i pointsize 1.6 title names[i]"
load "bench/recon_panels.gp"
