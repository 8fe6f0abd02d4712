# Draws the columns that growth writes: gnuplot -c growth.gp DIRECTORY
directory = ARG1
columns = directory . "/growth.dat"
set terminal svg size 1240,450 font "Helvetica,13" background "white"
set output directory . "/growth.svg"
set grid lc rgb "#e4e4e4" lt 1
set key left top
set multiplot layout 1,3 margins 0.07,0.97,0.27,0.9 spacing 0.115,0.1
set title "One configuration of a chain, with all derivatives"
set xlabel "groups in the chain"
set ylabel "ns" offset 1.5,0
set logscale xy
set xtics 1, 2
plot columns index 1 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#d00000" title "RRR-RRR", \
  columns index 0 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#0072b2" title "RRR dyads"
unset logscale
set xtics autofreq
set title "Emission of models 1 to n of the tetrad"
set xlabel "models"
set ylabel "seconds" offset 1.5,0
set ytics nomirror
set y2tics
set y2label "kB" offset -0.5,0
set yrange [0:*]
set y2range [0:*]
plot columns index 2 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#d00000" title "time", \
  columns index 2 using 1:($3 / 1000) axes x1y2 with linespoints pt 5 ps 0.5 lc rgb "#999999" \
    title "headers, kB"
unset y2tics
unset y2label
set title "Compilation, g++ -O2"
set ylabel "seconds" offset 1.5,0
set xlabel "models, and what is called of each" offset 0,0.5
set xtics ("Eigen alone" 0, "1, nothing" 1, "1, derivatives" 2, "1, all" 3, "4, derivatives" 4, "4, all" 5, \
  "15, derivatives" 6, "15, all" 7) rotate by 35 right
set style fill solid 0.7
set boxwidth 0.6
set xrange [-0.6:7.6]
plot columns index 3 using 0:1 with boxes lc rgb "#0072b2" notitle
unset multiplot
