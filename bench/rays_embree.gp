# SPDX-License-Identifier: Apache-2.0
# The ways to ask Embree for the next face: a panel an aspect ratio, a bar a way, errors per million at its end.
load "bench/rays_style.gp"

table = results."/rays_embree.csv"
aspects = wordsOf(table, "aspect")
ways = words(wordsOf(table, "way"))
inUse = word(wordsOf(table, "way"), 1)
speedHere(a, some) = (strcol("aspect") eq word(aspects, a) && (column("wrong_per_million") > 0) == some) \
  ? column("million_per_second") : NaN
labelOf(a) = a == 1 ? strcol("label") : ""
row(a) = column(0) - (a - 1) * ways
stats table using (column("million_per_second")) name "speed" nooutput
stats table using (column("queries")) name "queries" nooutput
explanation = sprintf("number at a bar: wrong faces per million, none in %.3g million where there is no number; " \
  ."dotted: the way in use", 1e-6 * queries_min)

eval terminalOf(1120, 620)
set output fileOf("rays_embree")
set multiplot title "Ways to ask Embree for the next face: million a second, one thread" font ",15"
set format "%g"
set xrange [0:1.2 * speed_max]
set xtics 10
set yrange [ways - 0.4:-0.6]
set ytics scale 0
set grid noytics xtics
set style fill solid 1.0 noborder
unset key
set tmargin at screen 0.87
set bmargin at screen 0.13
do for [a = 1:words(aspects)] {
  set lmargin at screen 0.215 + 0.262 * (a - 1)
  set rmargin at screen 0.465 + 0.262 * (a - 1)
  set title "aspect ".word(aspects, a)
  if (a > 1) { set format y "" }
  if (a == 2) { set xlabel explanation } else { unset xlabel }
  used = entryOf2(table, "way", inUse, "aspect", word(aspects, a), "million_per_second") + 0
  set arrow 1 from used, -0.6 to used, ways - 0.4 nohead front dashtype 3 linewidth 1.5 linecolor rgb "#404040"
  plot for [some = 0:1] table using \
      (speedHere(a, some)):(row(a)):(0):(speedHere(a, some)):(row(a) - 0.36):(row(a) + 0.36):yticlabels(labelOf(a)) \
      with boxxyerror linecolor rgb (some ? 0xE69F00 : hue("embree")), \
    table using (speedHere(a, 1) + 0.01 * speed_max):(row(a)):(sprintf("%.0f", column("wrong_per_million"))) \
      with labels left font ",10"
}
unset multiplot
