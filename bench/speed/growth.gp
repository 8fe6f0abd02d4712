# Draws the columns that growth writes: gnuplot -c growth.gp DIRECTORY
directory = ARG1
columns = directory . "/growth.dat"
set terminal svg size 1240,450 font "Helvetica,13" background "white"
set output directory . "/growth.svg"
set grid lc rgb "#e4e4e4" lt 1
set multiplot layout 1,3 margins 0.07,0.97,0.31,0.9 spacing 0.115,0.1
set title "One configuration of a chain, with all derivatives"
set xlabel "groups in the chain"
set ylabel "time, ns" offset 1.5,0
set logscale xy
set xtics 1, 2
set mxtics 1
set label 1 "tetrads RRR-RRR" at 7, 14000 right textcolor rgb "#d00000"
set label 2 "dyads RRR" at 11, 250 left textcolor rgb "#0072b2"
plot columns index 1 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#d00000" notitle, \
  columns index 0 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#0072b2" notitle
unset logscale
unset label 1
unset label 2
unset mxtics
set xtics autofreq
set title "Emission of models 1 to n of the tetrad"
set xlabel "models"
set ylabel "time, s" offset 1.5,0
set yrange [0:*]
plot columns index 2 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#d00000" notitle
set title "Compilation of one file, g++ -O2"
set ylabel "time, s" offset 1.5,0
set xlabel "what the file includes and calls" offset 0,0.5
set xtics ("Eigen alone" 0, "model 1, no call" 1, "model 1, motion" 2, "model 1, positions" 3, \
  "model 4, motion" 4, "model 4, positions" 5, "model 15, motion" 6, "model 15, positions" 7) rotate by 35 right
set style fill solid 0.7
set boxwidth 0.6
set xrange [-0.6:7.6]
plot columns index 3 using 0:1 with boxes lc rgb "#0072b2" notitle
unset multiplot
