# Draws the columns that speed_accuracy writes: gnuplot -c speed_accuracy.gp DIRECTORY
# A panel a task, error over time, both logarithmic, one colour a family of methods; a ring marks
# failures on some input. Left and low is better.
directory = ARG1
columns = directory . "/speed_accuracy.dat"
set terminal svg size 1300,1850 font "Helvetica,13" background "white"
set output directory . "/speed_accuracy.svg"
set datafile separator "\t"

colour(name) = name[1:9] eq "generated" ? 0xd00000 : \
  name[1:5] eq "Eigen" || name[1:6] eq "Newton" || name[1:2] eq "64" ? 0x0072b2 : \
  name[1:5] eq "Ceres" || name[1:4] eq "ADOL" ? 0x009e73 : \
  name[1:7] eq "central" || name[1:7] eq "complex" ? 0x999999 : \
  name[1:7] eq "special" ? 0xcc79a7 : \
  name[1:6] eq "KINSOL" || name[1:7] eq "MINPACK" || name[1:3] eq "GSL" ? 0xd08000 : 0x7040a0
short(name, scalar) = (scalar eq "double" ? "" : scalar . ", ") . \
  (strstrt(name, "generated, ") == 1 ? name[12:*] : name)

set format x "10^{%T}"
set format y "10^{%T}"
set grid xtics ytics lc rgb "#e4e4e4" lt 1
set xlabel "ns per evaluation" offset 0,0.6
unset key
set multiplot layout 5,3 margins 0.05,0.985,0.04,0.955 spacing 0.055,0.065 \
  title "Largest relative error against 60 digits, over the time of an evaluation" font ",17"
stats columns using 1 nooutput
panels = int(STATS_blocks) - 1  # an empty block ends the file
do for [panel = 1:panels] {
  set xrange [*:*]
  set yrange [*:*]
  title = ""
  stats columns index panel - 1 using (title = strcol(6), 1) nooutput
  unset logscale
  set title title offset 0,-0.7 font ",13"
  stats columns index panel - 1 using (log10($1)) name "T" nooutput
  stats columns index panel - 1 using (log10($2)) name "E" nooutput
  set logscale xy
  set xrange [10**(T_min - 0.3):10**(T_max + 1.4)]
  set yrange [10**(E_min - 1):10**(E_max + 1 + 0.3 * (E_max - E_min))]
  plot columns index panel - 1 using 1:2:(colour(strcol(4))) with points pt 7 ps 0.7 \
      lc rgb variable, \
    "" index panel - 1 using 1:($3 > 0 ? $2 : NaN):(colour(strcol(4))) with points pt 6 ps 1.5 \
      lw 1.5 lc rgb variable, \
    "" index panel - 1 using 1:7:(short(strcol(4), strcol(5))):(colour(strcol(4))) with labels \
      left offset 0.8,0 font ",9" textcolor rgb variable
}
unset multiplot
