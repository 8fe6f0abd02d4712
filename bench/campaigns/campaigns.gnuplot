# Turns the table of measure.sh into docs/guide/campaigns.svg:
#   bench/campaigns/measure.sh build/assur SCENE > campaigns.tsv
#   gnuplot -e "table='campaigns.tsv'" bench/campaigns/campaigns.gnuplot
set terminal svg size 900,620 font "sans,13" background "white"
set output "docs/guide/campaigns.svg"
set multiplot layout 2,2
set grid lc rgb "#dddddd"
set key top right
set style data linespoints
set logscale x 2
of(what) = sprintf("< awk '$1 == \"%s\"' %s", what, table)
set yrange [0:*]
set ylabel "us for a sample"
set xlabel "threads"
set xtics (1, 2, 4, 8, 16, 32, 64)
plot of("threads") using 2:($3 / $5 * 1e6) pt 7 title "wall clock", \
     of("threads") using 2:($4 / $5 * 1e6) pt 6 title "processors"
set xlabel "shards, one after the other, and merged"
plot of("shards") using 2:($4 / $5 * 1e6) pt 6 title "processors"
set xlabel "groups in a chain"
set logscale y
set yrange [*:*]
set key top left
plot of("groups") using 2:($4 / $5 * 1e6) pt 6 title "processors"
set xlabel "samples of one run"
set logscale x 10
set xtics auto
set format x "10^{%T}"
set key top right
plot of("samples") using 2:($4 / $5 * 1e6) pt 6 title "processors"
