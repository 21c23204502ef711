# SPDX-License-Identifier: Apache-2.0
# How the stages share a ray's time: one bar an engine and set of vector registers.
load "bench/rays_style.gp"

table = results."/rays_stages.csv"
array stages = ["start", "entry", "embree_calls", "intersection", "optics", "deposit", "pool"]
array names = ["numbers, orientation, point of entry", "entry", "Embree's own calls", "next face otherwise", \
  "optics of internal encounters", "turning exits to the world, camera, tally", "keeping the pool full"]
array hues = [0x56B4E9, 0x0072B2, 0xD55E00, 0xE69F00, 0x009E73, 0xCC79A7, 0x909090]
upTo(s) = s == 0 ? 0 : column(stages[s]) + upTo(s - 1)
engineOf(id) = id eq "embree" ? "Embree" : id
registersOf(id) = id eq "avx512" ? "AVX-512" : id eq "avx2" ? "AVX2" : id
labelOf(row) = engineOf(strcol("engine")).", ".registersOf(strcol("registers"))
endOf(row) = sprintf("%.0f ns; %.0f %% of the bare loop", upTo(|stages|), \
  100 * column("hits_per_second") / column("loop_per_second"))
stats table using (column("whole")) name "whole" nooutput

eval terminalOf(1120, 520)
set output fileOf("rays_stages")
set title "Time of a ray by stages, one thread" font ",15"
set format "%g"
set xlabel "nanoseconds a ray; at the end: hits a second of the whole, as a share of the bare search for the next face"
set xrange [0:1.32 * whole_max]
set yrange [whole_records - 0.4:-0.6]
set ytics scale 0
set grid noytics xtics
set style fill solid 1.0 noborder
set bmargin 8.5
set key at screen 0.5, screen 0.16 center top horizontal Left reverse samplen 1 width 2 maxrows 3
plot for [s = 1:|stages|] table using \
    (upTo(s)):0:(upTo(s - 1)):(upTo(s)):($0 - 0.36):($0 + 0.36):yticlabels(labelOf(0)) \
    with boxxyerror linecolor rgb hues[s] title names[s], \
  table using (upTo(|stages|) + 0.005 * whole_max):0:(endOf(0)) with labels left notitle
