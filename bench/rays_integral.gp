# SPDX-License-Identifier: Apache-2.0
# Error of whole pictures against their time, a panel for each scene: rays, reconstructions, pictures without rays.
load "bench/rays_style.gp"

table = results."/rays_integral.csv"
array skies = ["random columns profile", "random columns", "columns at rest", "plates", "Parry", "parhelia", "display"]
array titles = ["random columns: rings' profile", "random columns", "columns at rest", "plates: a sun pillar", \
  "Parry crystals and columns", "parhelia: plates, tilt 0.7°", "a grand display"]
array curves = ["plain rays", "Sobol' points", "mirrored or in rings", "adaptive", "integral", "mixed"]
array colours = [0x909090, 0xCC79A7, 0xE69F00, 0x0072B2, 0xD55E00, 0xD55E00]
array marks = [6, 4, 8, 5, 7, 7]

set datafile separator ","
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [0.03:60]
eval terminalOf(1440, 720)
set output fileOf("rays_integral")
set multiplot title "Error of a picture of 512 × 512 pixels in colours against its time (lower left is better)" font ",15"
unset key
do for [c = 1:7] {
  column = (c - 1) % 4
  row = (c - 1) / 4
  set lmargin at screen 0.055 + 0.243 * column
  set rmargin at screen 0.245 + 0.243 * column
  set tmargin at screen 0.88 - 0.46 * row
  set bmargin at screen 0.56 - 0.46 * row
  set title titles[c]
  if (column == 0) { set ylabel "relMSE" } else { set ylabel "" }
  if (c > 3) { set xlabel "CPU seconds of the whole" } else { set xlabel "" }
  plot for [k = 1:6] table using \
    (strcol("scene") eq skies[c] && strcol("curve") eq curves[k] ? column("cpu_seconds") : NaN):"relMSE" \
    with linespoints linecolor rgb colours[k] linewidth (k > 4 ? 4 : 2) pointtype marks[k] pointsize 0.8
}
set xlabel ""
set lmargin at screen 0.77
set rmargin at screen 0.99
set tmargin at screen 0.40
set bmargin at screen 0.09
eval keyPlace
plot for [k = 1:5] NaN with linespoints linecolor rgb colours[k] linewidth (k > 4 ? 4 : 2) pointtype marks[k] \
  title k == 5 ? "integral, and rays for Parry crystals" : curves[k]
unset multiplot
