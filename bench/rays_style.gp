# SPDX-License-Identifier: Apache-2.0
# What the charts of tracing share. Colours follow from the words of an id, so that a new row of
# bench/rays_configurations.h or of finderKinds() needs no change here: engine by hue, path by dash, sampler by symbol,
# symmetry by width. The hues are told apart by all kinds of colour vision (Okabe & Ito).
load "bench/style.gp"

has(id, word) = strstrt(id, word) > 0
hue(id) = has(id, "embree-robust") ? 0xE69F00 : has(id, "embree") ? 0xD55E00 : has(id, "planes-float") ? 0x009E73 \
  : has(id, "planes") ? 0x0072B2 : 0x404040
dash(id) = has(id, "chance") ? 2 : 1
symbol(id) = has(id, "sobol") ? (has(id, "embree") ? 9 : 5) : has(id, "embree") ? 8 : 6
width(id) = has(id, "radial") ? 5 : has(id, "mirror") ? 3.5 : 2

# The words in a column of a table, each once, in the table's order.
wordsOf(file, name) = system(sprintf("awk -F, '/^#/ {next} \
  !c {for (i = 1; i <= NF; i++) if ($i == \"%s\") c = i; next} !seen[$c]++ {printf \"%%s \", $c}' %s", name, file))
# The entry of one column in the first row where another has some value.
entryOf(file, key, value, name) = system(sprintf("awk -F, '/^#/ {next} !k {for (i = 1; i <= NF; i++) { \
  if ($i == \"%s\") k = i; if ($i == \"%s\") c = i}; next} $k == \"%s\" {print $c; exit}' %s", key, name, value, file))
# Of the rows in which two columns have some values.
entryOf2(file, key, value, key2, value2, name) = system(sprintf("awk -F, '/^#/ {next} !k {for (i = 1; i <= NF; i++) { \
  if ($i == \"%s\") k = i; if ($i == \"%s\") l = i; if ($i == \"%s\") c = i}; next} \
  $k == \"%s\" && $l == \"%s\" {print $c; exit}' %s", key, key2, name, value, value2, file))
