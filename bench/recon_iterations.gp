# SPDX-License-Identifier: Apache-2.0
load "bench/style.gp"

array curves = ["scatter m=32", "scatter m=128", "scatter m=512", "scatter m=2048", "marvasti", "voronoi"]
array curveNames = ["G.-M. scatter, m = 32", "G.-M. scatter, m = 128", "G.-M. scatter, m = 512", \
  "G.-M. scatter, m = 2048", "Marvasti", "Voronoi, densities"]
array shades = ["#c9b8e8", "#9d7fd6", "#6f45b8", "#35127a", "#00a0a0", "#2e8b2e"]
array marks = [1, 4, 6, 13, 8, 10]
do for [i = 1:6] { set style line i linecolor rgb shades[i] dashtype 1 linewidth 2 \
  pointtype marks[i] pointsize 0.9 }

set logscale y
set xlabel "iterations"
set ylabel "relative mean square error"
set format x "%g"
eval terminalOf(1120, 440)
set output fileOf("recon_iterations")
set multiplot title "Iterations sharpen what was too blurred, then bring back the noise" font ",15"
do for [p = 1:2] {
  set lmargin at screen 0.075 + 0.385 * (p - 1)
  set rmargin at screen 0.39 + 0.385 * (p - 1)
  set tmargin at screen 0.82
  set bmargin at screen 0.14
  if (p == 2) { set ylabel "" }
  set title sprintf("10^{%d} rays", p + 4)
  plot for [i = 1:6] results."/recon_iterations.csv" \
    using (column("rays") == 10 ** (p + 4) && strcol("curve") eq curves[i] ? column("iterations") : NaN):"relMSE" \
    with linespoints linestyle i notitle
}
set lmargin at screen 0.79
set rmargin at screen 0.99
eval keyPlace
plot for [i = 1:6] NaN with linespoints linestyle i title curveNames[i]
unset multiplot
