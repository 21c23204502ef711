# SPDX-License-Identifier: Apache-2.0
load "bench/style.gp"

array curves = ["scatter k=1", "gather k=1", "scatter k=2", "gather k=2"]
array curveNames = ["scatter, k = 1", "gather, k = 1", "scatter, k = 2", "gather, k = 2"]
array shades = ["#4b1f9e", "#9467d8", "#b85c00", "#e8a860"]
do for [i = 1:4] { set style line i linecolor rgb shades[i] dashtype 1 linewidth 2 pointtype symbols[i] pointsize 0.7 }

set logscale xy
set xlabel "m, hits in a square"
yLabel = "relative mean square error"
set xrange [6:5500]
set xtics (8, 32, 128, 512, 2048)
set format x "%g"
chart = "recon_samples"
heading = "Gonzato and Marchand's m: the best one grows with the rays"
panels = rayCounts(results."/recon_samples.csv")
panelTitle(p) = sprintf("10^{%d} rays", p + 3)
panelPlot(p) = sprintf("plot for [i = 1:4] results.'/recon_samples.csv' \
  using (column('rays') == 10 ** %d && strcol('curve') eq curves[i] ? column('samples') : NaN):'relMSE' \
  with linespoints linestyle i notitle", p + 3)
keyPlot = "plot for [i = 1:4] NaN with linespoints linestyle i title curveNames[i]"
load "bench/recon_panels.gp"
