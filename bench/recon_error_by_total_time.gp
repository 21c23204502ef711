# SPDX-License-Identifier: Apache-2.0
load "bench/style.gp"

set logscale xy
set xlabel "seconds of tracing and reconstruction together"
set ylabel "relative mean square error"
set format x "%g"
set key outside right center Left reverse spacing 1.4
set title "How long a picture of some quality takes (10^4, 10^5, 10^6, ... rays along each line)"
eval terminalOf(960, 560)
set output fileOf("recon_error_by_total_time")
plot for [i = 1:|methods|] results."/recon_summary.csv" \
  using (strcol("scene") eq scenes[1] && strcol("method") eq methods[i] \
    ? column("seconds") + column("tracing_seconds") : NaN):"relMSE" \
  with linespoints linestyle i title names[i]
