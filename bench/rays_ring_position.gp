# SPDX-License-Identifier: Apache-2.0
# The ring's inner edge by the number of rays, and how far it is from the closed form.
load "bench/rays_style.gp"

table = results."/rays_ring_position.csv"
engines = wordsOf(table, "engine")
exact = entryOf(table, "engine", word(engines, 1), "exact") + 0
labelOf(engine) = engine eq "embree" ? "Embree" : engine
shift(engine) = engine eq word(engines, 1) ? 0.95 : 1.05  # or one would hide the other
dashOf(engine) = engine eq word(engines, 1) ? 1 : 2

set logscale x
set xlabel "rays traced"
set xrange [7e3:1.4e8]
eval terminalOf(1120, 480)
set output fileOf("rays_ring_position")
set multiplot title "Where the 22° ring's inner edge is found, n = 1.31" font ",15"
do for [p = 1:2] {
  set lmargin at screen 0.085 + 0.475 * (p - 1)
  set rmargin at screen 0.49 + 0.475 * (p - 1)
  set tmargin at screen 0.86
  set bmargin at screen 0.15
  if (p == 1) {
    set title "position, with its standard error"
    set ylabel "degrees from the sun"
    set format y "%.4f"
    set key top right
    plot exact with lines linecolor rgb "#404040" linewidth 1.5 title sprintf("closed form, %.4f°", exact), \
      for [e in engines] table using (strcol("engine") eq e ? column("rays") * shift(e) : NaN): \
        (exact + column("deviation")):"error" \
      with yerrorbars linecolor rgb hue(e) linewidth 2 pointtype symbol(e) title labelOf(e)
  } else {
    set title "the same error bar, and the distance to the closed form"
    set ylabel "degrees"
    set logscale y
    set format y "10^{%T}"
    set key top right
    plot for [e in engines] table using (strcol("engine") eq e ? column("rays") : NaN):"error" \
        with lines linecolor rgb hue(e) linewidth 2 dashtype dashOf(e) \
        title labelOf(e).", error bar", \
      for [e in engines] table using \
        (strcol("engine") eq e ? column("rays") * shift(e) : NaN):(abs(column("deviation"))) \
        with points linecolor rgb hue(e) linewidth 2 pointtype symbol(e) title labelOf(e).", distance"
  }
}
unset multiplot
