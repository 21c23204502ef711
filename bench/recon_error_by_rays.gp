# SPDX-License-Identifier: Apache-2.0
load "bench/style.gp"

set logscale xy
set xlabel "rays traced"
set ylabel "relative mean square error"
set key outside right center Left reverse spacing 1.4
set title "How far the picture is from the truth, by the number of rays"
eval terminalOf(960, 560)
set output fileOf("recon_error_by_rays")
plot for [i = 1:|methods|] results."/recon_summary.csv" \
  using (strcol("scene") eq scenes[1] && strcol("method") eq methods[i] ? column("rays") : NaN):"relMSE" \
  with linespoints linestyle i title names[i]
