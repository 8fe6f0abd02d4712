# Turns the table of measure.sh into docs/reports/campaigns.svg:
#   bench/campaigns/measure.sh build/assur SCENE > campaigns.tsv
#   gnuplot -e "table='campaigns.tsv'" bench/campaigns/campaigns.gnuplot
set terminal svg size 900,620 font "sans,13" background "white"
set output "docs/reports/campaigns.svg"
set multiplot layout 2,2
set grid lc rgb "#dddddd"
set style data linespoints
set logscale x 2
of(what) = sprintf("< awk '$1 == \"%s\"' %s", what, table)
set yrange [0:*]
set ylabel "time of a sample, us"
set xlabel "threads"
set xtics (1, 2, 4, 8, 16, 32, 64)
set xrange [0.9:2.2]
set key top right
plot of("threads") using 2:($3 / $5 * 1e6) pt 7 lc rgb "#d55e00" title "wall clock", \
     of("threads") using 2:($4 / $5 * 1e6) pt 7 lc rgb "#0072b2" title "processors"
# The other panels have the time of processors alone, so they need no key.
unset key
set ylabel "processor time of a sample, us"
set linetype 1 lc rgb "#0072b2"
set xrange [0.9:72]
set xlabel "shards, one after the other, and merged"
plot of("shards") using 2:($4 / $5 * 1e6) pt 7
set xlabel "groups in a chain"
set logscale y
set yrange [*:*]
plot of("groups") using 2:($4 / $5 * 1e6) pt 7
set xlabel "samples of one run"
set logscale x 10
set xrange [0.8:1.2e5]
set xtics auto
set format x "10^{%T}"
plot of("samples") using 2:($4 / $5 * 1e6) pt 7
