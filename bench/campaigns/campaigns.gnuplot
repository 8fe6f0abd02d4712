# Turns the table of measure.sh into docs/reports/campaigns.svg:
#   bench/campaigns/measure.sh build/assur SCENE > campaigns.tsv
#   gnuplot -e "table='campaigns.tsv'" bench/campaigns/campaigns.gnuplot
set terminal svg size 900,640 font "sans,13" background "white"
set output "docs/reports/campaigns.svg"
set multiplot layout 2,2
set grid lc rgb "#dddddd"
unset key
set style data linespoints
of(what) = sprintf("< awk '$1 == \"%s\"' %s", what, table)
set title "On several threads"
set ylabel "time per sample, µs"
set xlabel "threads"
set xtics 1
most = system(sprintf("awk '$1 == \"threads\" {most = $2} END {print most}' %s", table)) + 0
set xrange [0.8:most + 0.2]
set yrange [0:*<12]
last(what) = of(what) . " | tail -n 1"
plot of("threads") using 2:($3 / $5 * 1e6) pt 7 lc rgb "#d55e00", \
     of("threads") using 2:($4 / $5 * 1e6) pt 7 lc rgb "#0072b2", \
     last("threads") using 2:($3 / $5 * 1e6):("wall clock") with labels right offset 0, -1.3 tc rgb "#d55e00", \
     last("threads") using 2:($4 / $5 * 1e6):("processors") with labels right offset 0, -1.3 tc rgb "#0072b2"
set linetype 1 lc rgb "#0072b2"
set ylabel "processor time per sample, µs"
set logscale x 2
set xtics (1, 2, 4, 8, 16, 32, 64)
set xrange [0.8:80]
set yrange [0:*]
set title "In shards, one after the other, and merged"
set xlabel "shards"
plot of("shards") using 2:($4 / $5 * 1e6) pt 7
set title "With more groups"
set xlabel "dyads in a chain"
set logscale y
set yrange [3:1000]
plot of("groups") using 2:($4 / $5 * 1e6) pt 7
set title "With more samples"
set xlabel "samples of one run"
set logscale x 10
set xrange [0.6:2e5]
set yrange [3:1e4]
set format y "10^{%T}"
set xtics auto
set format x "10^{%T}"
plot of("samples") using 2:($4 / $5 * 1e6) pt 7
