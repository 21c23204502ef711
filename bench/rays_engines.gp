# SPDX-License-Identifier: Apache-2.0
# Speed against errors: one symbol an aspect ratio, one colour an engine.
load "bench/rays_style.gp"

table = results."/rays_engines.csv"
engines = wordsOf(table, "engine")
aspects = wordsOf(table, "aspect")
array symbolOf[5] = [8, 4, 6, 12, 10]   # open; the filled ones are the next numbers
# None at all is drawn as half a one of all queries, open and with an arrow down.
stats table using (column("queries")) name "queries" nooutput
stats table using (1e6 * (column("wrong") + column("lost")) / column("queries")) name "rate" nooutput
floorRate = 0.5e6 / queries_min
array speeds = ["rays_per_cpu_second", "loop_per_cpu_second"]
array fastest[2]
do for [p = 1:2] {
  stats table using (1e-6 * column(speeds[p])) name "speed" nooutput
  fastest[p] = speed_max
}

set logscale y
set yrange [floorRate / 3 : 3 * (rate_max > 10 * floorRate ? rate_max : 10 * floorRate)]
set format y "10^{%T}"
set format x "%g"
set ylabel "wrong and lost rays per million"
eval terminalOf(1120, 560)
set output fileOf("rays_engines")
set multiplot title "Speed against accuracy of the engines (lower right is better)" font ",15"
unset key
array axes = ["million rays a second: whole renders, one thread", "million next faces a second: bare loop, one thread"]
# The speed of one engine's rows, of one aspect ratio's where a is not 0, with errors or without.
speedOf(p, e, a, some) = (strcol("engine") eq e && (a == 0 || strcol("aspect") eq word(aspects, a)) \
  && (column("wrong") + column("lost") > 0) == some && column(speeds[p]) > 0) ? 1e-6 * column(speeds[p]) : NaN
do for [p = 1:2] {
  set lmargin at screen 0.075 + 0.385 * (p - 1)
  set rmargin at screen 0.39 + 0.385 * (p - 1)
  set tmargin at screen 0.88
  set bmargin at screen 0.13
  set xlabel axes[p]
  set xrange [0:1.1 * fastest[p]]
  if (p == 2) { set ylabel "" }
  plot for [e in engines] table using (speedOf(p, e, 0, 0)):(floorRate / 1.25):(0):(floorRate * (1 / 2.2 - 1 / 1.25)) \
      with vectors head filled size screen 0.008, 20 linewidth 1.2 linecolor rgb hue(e), \
    for [e in engines] for [a = 1:words(aspects)] table using (speedOf(p, e, a, 0)):(floorRate) \
      with points pointtype symbolOf[a] pointsize 1.6 linewidth 1.8 linecolor rgb hue(e), \
    for [e in engines] for [a = 1:words(aspects)] table using \
      (speedOf(p, e, a, 1)):(1e6 * (column("wrong") + column("lost")) / column("queries")) \
      with points pointtype symbolOf[a] + 1 pointsize 1.6 linecolor rgb hue(e)
}
set lmargin at screen 0.79
set rmargin at screen 0.99
eval keyPlace
plot for [e in engines] NaN with points pointtype 7 pointsize 1.6 linecolor rgb hue(e) \
    title entryOf(table, "engine", e, "label"), \
  NaN with points pointtype -1 title " ", \
  for [a = 1:words(aspects)] NaN with points pointtype symbolOf[a] + 1 pointsize 1.6 linecolor rgb "#404040" \
    title "aspect ".word(aspects, a), \
  NaN with points pointtype -1 title " ", \
  NaN with points pointtype 6 pointsize 1.6 linewidth 1.8 linecolor rgb "#404040" \
    title "open, with an arrow:", \
  NaN with points pointtype -1 title sprintf("none in %.3g million", 1e-6 * queries_min)
unset multiplot
