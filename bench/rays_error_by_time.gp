# SPDX-License-Identifier: Apache-2.0
# Error of the picture against the time of its rays, a column of panels for each scene.
load "bench/rays_style.gp"

table = results."/rays_error_by_time.csv"
skies = wordsOf(table, "scene")
configurations = wordsOf(table, "configuration")
array pictures = ["plain", "adaptive"]
array pictureNames = ["the plain picture, 128×128", "the reconstruction, 512×512"]
titleOf(scene) = scene eq "random-columns" ? "rings of random columns" : scene eq "parhelia" ? "parhelia of plates" \
  : scene eq "display" ? "a grand display" : scene

set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "CPU seconds of tracing"
eval terminalOf(1440, 760)
set output fileOf("rays_error_by_time")
set multiplot title "How fast the error falls: one curve a way to trace (lower left is better)" font ",15"
do for [row = 1:2] {
  do for [c = 1:words(skies)] {
    set lmargin at screen 0.07 + 0.24 * (c - 1)
    set rmargin at screen 0.265 + 0.24 * (c - 1)
    set tmargin at screen 0.89 - 0.48 * (row - 1)
    set bmargin at screen 0.57 - 0.48 * (row - 1)
    unset key
    set title titleOf(word(skies, c))
    if (c == 1) { set ylabel "relMSE of ".pictureNames[row] } else { set ylabel "" }
    plot for [k in configurations] table using \
      (strcol("scene") eq word(skies, c) && strcol("configuration") eq k ? column("cpu_seconds") : NaN):pictures[row] \
      with linespoints linecolor rgb hue(k) dashtype dash(k) linewidth width(k) pointtype symbol(k) pointsize 0.8
  }
}
set lmargin at screen 0.77
set rmargin at screen 0.99
slopeText(slope) = slope eq "" ? "– " : sprintf("%.2f ", slope + 0)
slopeOf(k, c, picture) = c > words(skies) ? "" \
  : slopeText(entryOf2(table, "scene", word(skies, c), "configuration", k, picture."_slope"))
slopesOf(k, picture) = slopeOf(k, 1, picture).slopeOf(k, 2, picture).slopeOf(k, 3, picture)
set tmargin at screen 0.91
set bmargin at screen 0.05
eval keyPlace
set key title "slopes: plain, then reconstructed,\nscenes left to right" left
plot for [i = 1:2 * words(configurations)] k = word(configurations, (i + 1) / 2) NaN with linespoints \
  linecolor rgb (i % 2 ? hue(k) : 0xFFFFFF) dashtype dash(k) linewidth width(k) pointtype symbol(k) pointsize 0.8 \
  title i % 2 ? entryOf(table, "configuration", k, "label") : slopesOf(k, "plain")." / ".slopesOf(k, "adaptive")
unset multiplot
