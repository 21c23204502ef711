# SPDX-License-Identifier: Apache-2.0
# One sheet a number of rays: what each method makes of it, at one exposure.
load "bench/style.gp"
if (form ne "png") { exit }  # a picture is no drawing

list = results."/pictures.csv"
sheets = system("grep -v '^#' ".list." | tail -n +2 | cut -d, -f1 | uniq")
unset border
unset tics
unset grid
unset key
set format "%g"
# Pixels: of a picture, between pictures, for a title of one, for that of all.
wide = 352.0
high = 240.0
gap = 10.0
line = 24.0
head = 40.0
W = 3 * wide + 4 * gap
H = 4 * (high + line) + head + gap
do for [rays in sheets] {
  set terminal pngcairo size W, H font "DejaVu Sans,10" background rgb "white"
  set output sprintf("%s/contact-1e%d.png", charts, strlen(rays) - 1)
  rows = int(system("grep -c '^".rays.",' ".list))
  set multiplot layout 4, 3 margins gap / W, 1 - gap / W, gap / H, 1 - (head + line) / H spacing gap / W, line / H \
    title sprintf("The sky around the sun from 10^{%d} rays, all pictures of the same mean", strlen(rays) - 1) \
    font ",13"
  do for [i = 1:rows] {
    cells = system(sprintf("grep '^%s,' %s | sed -n %dp | tr , '\n' | tail -n 3", rays, list, i))
    file = system(sprintf("echo '%s' | sed -n 1p", cells))
    text = system(sprintf("echo '%s' | sed -n 2p", cells))
    error = system(sprintf("echo '%s' | sed -n 3p", cells)) + 0
    set title (error > 0 ? sprintf("%s: relMSE %.3g", text, error) : text) offset 0, -0.8
    plot results."/".file binary filetype=png with rgbimage
  }
  unset multiplot
}
