# SPDX-License-Identifier: Apache-2.0
# Speed against threads and against picture size, memory against picture size, and the ways to share a tally.
load "bench/rays_style.gp"
set datafile missing NaN  # lines go on past the rows of other curves

byThreads = results."/rays_scaling_threads.csv"
bySize = results."/rays_scaling_sizes.csv"
byTally = results."/rays_scaling_tallies.csv"
engines = wordsOf(byThreads, "engine")
ways = wordsOf(byTally, "sharing")
stats byThreads using (column("threads")) name "threads" nooutput
stats byThreads using (1e-6 * column("rays_per_second")) name "speed" nooutput
processors = entryOf(bySize, "engine", word(engines, 1), "threads") + 0
labelOf(engine) = engine eq "embree" ? "Embree" : engine
wayHue(way) = way eq "bands" ? 0x009E73 : way eq "atomics" ? 0xCC79A7 : 0x606060
wayDash(way) = way eq "bands" ? 1 : way eq "atomics" ? 2 : 4
waySymbol(way) = way eq "bands" ? 7 : way eq "atomics" ? 4 : 10
one(engine) = entryOf2(byThreads, "engine", engine, "threads", "1", "rays_per_second") * 1e-6
ideal(engine, n) = one(engine) * (n < processors ? n : processors)

place(column, row) = sprintf("set lmargin at screen %f; set rmargin at screen %f; set tmargin at screen %f; \
  set bmargin at screen %f", 0.065 + 0.385 * column, 0.375 + 0.385 * column, 0.89 - 0.48 * row, 0.57 - 0.48 * row)
sizeAxis = "set logscale x 2; set xtics (512, 1024, 2048, 4096, 8192); set xrange [430:9700]; set format x '%g'; \
  set xlabel 'width and height of the picture, pixels'"

unset key
eval terminalOf(1120, 760)
set output fileOf("rays_scaling")
set multiplot title "Threads and picture size" font ",15"
set format "%g"

eval place(0, 0)
set title "Speed by threads, 1024×1024 pixels"
set xlabel "threads"
set ylabel "million rays a second"
set xtics 1
set xrange [0.8:threads_max + 0.2]
set yrange [0:1.15 * speed_max]
plot for [e in engines] ideal(e, x) with lines linecolor rgb hue(e) dashtype 3 linewidth 1.2, \
  for [e in engines] byThreads using \
    (strcol("engine") eq e ? column("threads") : NaN):(1e-6 * column("rays_per_second")) \
  with linespoints linecolor rgb hue(e) linewidth 2 pointtype symbol(e)

eval place(1, 0)
eval sizeAxis
set title sprintf("Speed by picture size, %d threads", processors)
plot for [e in engines] bySize using (strcol("engine") eq e ? column("side") : NaN):(1e-6 * column("rays_per_second")) \
  with linespoints linecolor rgb hue(e) linewidth 2 pointtype symbol(e)

eval place(0, 1)
set title sprintf("Most memory held, %d threads", processors)
set ylabel "megabytes"
set logscale y
set format y "10^{%T}"
set yrange [*:*]
plot for [e in engines] bySize using (strcol("engine") eq e ? column("side") : NaN):(1e-6 * column("peak_memory")) \
    with linespoints linecolor rgb hue(e) linewidth 2 pointtype symbol(e), \
  for [w in ways] byTally using \
    (strcol("sharing") eq w && column("threads") == processors ? column("side") : NaN):(1e-6 * column("memory")) \
    with linespoints linecolor rgb wayHue(w) dashtype wayDash(w) linewidth 2 pointtype waySymbol(w)

eval place(1, 1)
set title sprintf("Ways to share a tally: deposits alone, %d threads", processors)
set ylabel "million deposits a second"
unset logscale y
set format y "%g"
set yrange [0:*]
plot for [w in ways] byTally using \
    (strcol("sharing") eq w && column("threads") == processors ? column("side") : NaN): \
    (1e-6 * column("run_per_second")) \
    with linespoints linecolor rgb wayHue(w) dashtype wayDash(w) linewidth 2 pointtype waySymbol(w)

set lmargin at screen 0.765
set rmargin at screen 0.99
set tmargin at screen 0.89
set bmargin at screen 0.09
eval keyPlace
plot for [e in engines] NaN with linespoints linecolor rgb hue(e) linewidth 2 pointtype symbol(e) \
    title labelOf(e).", whole renders", \
  NaN with lines linecolor rgb "#404040" dashtype 3 linewidth 1.2 title "one thread times threads", \
  NaN with points pointtype -1 title " ", \
  for [w in ways] NaN with linespoints linecolor rgb wayHue(w) dashtype wayDash(w) linewidth 2 pointtype waySymbol(w) \
    title entryOf(byTally, "sharing", w, "label")
unset multiplot
