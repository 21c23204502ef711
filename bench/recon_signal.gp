# SPDX-License-Identifier: Apache-2.0
load "bench/style.gp"

# As bench/recon_signal.cpp gives them.
array sizes = ["", "(σ = 4)", "(σ = 1 to 32)", "(Ts = 8)", "(Ts = 6)", "(Ts = 6, 3 iterations)", "(Ts = 8)", \
  "(m = 16)", "(m = 16)", "(m = 16)", ""]
set format "%g"
set xrange [0:511]
set yrange [0:14]
set ytics 0, 5
unset grid
unset key
eval terminalOf(1060, 900)
set output fileOf("recon_signal")
set multiplot layout 5, 2 margins 0.04, 0.99, 0.04, 0.93 spacing 0.045, 0.07 \
  title "Hits of one dimension (grey bars), the density they were drawn from (black), and what methods make of them" \
  font ",12"
do for [i = 2:|methods| - 1] {
  set title names[i]." ".sizes[i] offset 0, -0.7
  plot results."/recon_signal.csv" using "sample":"hits" with impulses linecolor rgb "#c8c8c8", \
    "" using "sample":"expected" with lines linecolor rgb "black", \
    "" using "sample":methods[i] with lines linecolor rgb colours[i] linewidth 2.2
}
unset multiplot
