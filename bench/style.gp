# SPDX-License-Identifier: Apache-2.0
# What all charts share: one colour a method, terminals, axes. Run from the root of the repository as
# gnuplot -e "results = 'FOLDER'; charts = 'FOLDER'; form = 'svg'" bench/CHART.gp

set encoding utf8
set datafile separator comma
set datafile columnheaders

array methods = ["none", "gaussian", "glassner", "marvasti", "voronoi", "voronoi-intensities", "act", "published", \
  "gather", "scatter", "adaptive"]
array names = ["plain", "one Gaussian", "Glassner", "Marvasti", "Voronoi, densities", "Voronoi, intensities", "ACT", \
  "G.-M. as published", "G.-M. gather", "G.-M. scatter", "adaptive"]
# Relatives have shades of one colour; broken lines tell them apart without it.
array colours = ["#8a8a8a", "#56a8e8", "#1f4e9c", "#00a0a0", "#2e8b2e", "#8fc98f", "#d08000", "#c29ce6", "#9467d8", \
  "#4b1f9e", "#e4002b"]
array dashes = [1, 1, 2, 2, 1, 2, 1, 2, 1, 1, 1]
array symbols = [1, 4, 6, 8, 10, 11, 12, 2, 9, 5, 7]
do for [i = 1:|methods|] {
  set style line i linecolor rgb colours[i] dashtype dashes[i] linewidth (i == |methods| ? 3.5 : 1.8) \
    pointtype symbols[i] pointsize (i == |methods| ? 1.2 : 0.9)
}

array scenes = ["mixed", "photograph", "pyramids", "display"]
array sceneNames = ["mixed: plates, columns, random", "mixed, through a 60° lens", "rings: columns and pyramids", \
  "a grand display"]

fileOf(chart) = sprintf("%s/%s.%s", charts, chart, form)
terminalOf(wide, high) = sprintf("set terminal %s size %d,%d font 'DejaVu Sans,%s' background rgb 'white'", \
  form eq "svg" ? "svg" : "pngcairo", wide, high, form eq "svg" ? "13" : "11")

set border 3 linecolor rgb "#404040"
set tics nomirror out
set grid linecolor rgb "#e0e0e0" linetype 1
set format "10^{%T}"

# How many of the scenes a summary has.
sceneCount(file) = int(system("grep -v '^#' ".file." | tail -n +2 | cut -d, -f1 | sort -u | wc -l"))

# How many numbers of rays a table has, from 10^4 by factors of 10.
rayCounts(file) = int(system("grep -v '^#' ".file." | grep -oE '\\b10{4,}\\b' | sort -u | wc -l"))

# A place for the key alone, beside several panels.
keyPlace = "unset title; unset label; unset xlabel; unset ylabel; unset tics; unset border; unset grid; \
  unset logscale; set xrange [0:1]; set yrange [0:1]; \
  set key at graph 0, graph 1 left top Left reverse samplen 2.5 spacing 1.4"
