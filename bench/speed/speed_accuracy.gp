# Draws the columns that speed_accuracy writes: gnuplot -c speed_accuracy.gp DIRECTORY
# speed_accuracy.svg has a panel per task, speed_summary.svg the four main ones. Error over time,
# both logarithmic; a method's name stands at the right, a line leads to it.
directory = ARG1
array charts[2] = ["speed_accuracy", "speed_summary"]
set datafile separator "\t"

# The colours and marks, by the number that a family or a scalar has in the columns.
array colours[7] = [0xd00000, 0x0072b2, 0x00875a, 0x707070, 0xc0509a, 0xb86000, 0x6a3d9a]
array families[7] = ["generated", "by hand, LU", "autodiff", "differences", "special points", \
  "general solvers", "root finders"]
array marks[3] = [7, 9, 5]
array scalars[3] = ["double", "float", "long double"]
named(name, value) = strlen(name) > 0 ? value : NaN
paler(colour) = (0xa0 << 24) + colour

set format x "10^{%T}"
set format y "10^{%T}"
set grid xtics ytics lc rgb "#e0e0e0" lt 1
set border 3 lc rgb "#a0a0a0"
set tics scale 0 nomirror font ",12" textcolor rgb "#505050"
unset key
do for [figure = 1:2] {
  columns = directory . "/" . charts[figure] . ".dat"
  stats columns using 1 nooutput
  tasks = int(STATS_blocks) - 1  # an empty block ends the file
  array titles[tasks]
  array occurs[7] = [0, 0, 0, 0, 0, 0, 0]
  do for [task = 1:tasks] {
    stats columns index task - 1 using (titles[task] = strcol(7), occurs[int($5)] = 1, 1) nooutput
  }
  rows = (tasks + 1) / 2
  head = 96.0
  each = 302.0
  height = head + each * rows
  set terminal svg size 900,height font "Helvetica,13" background "white"
  set output directory . "/" . charts[figure] . ".svg"
  set multiplot
  set label 30 "Largest relative error over the time of an evaluation: lower left is better" \
    at screen 0.02, 1 - 20 / height font ",16"
  entry = 0
  do for [n = 1:7] {
    if (occurs[n]) {
      set label n families[n] at screen (24 + 126 * entry) / 900.0, 1 - 46 / height \
        point pt 7 ps 0.9 lc rgb colours[n] offset 0.8,-0.25 textcolor rgb colours[n]
      entry = entry + 1
    }
  }
  do for [n = 1:(figure == 1 ? 3 : 0)] {
    set label 10 + n scalars[n] at screen (24 + 122 * (n - 1)) / 900.0, 1 - 68 / height \
      point pt marks[n] ps 0.9 lc rgb colours[1] offset 0.8,-0.25
  }
  set label 20 "fails on some inputs (on how many)" \
    at screen (figure == 1 ? 390 : 24) / 900.0, 1 - 68 / height point pt 6 ps 1.6 lw 1.5 lc rgb 0x404040 offset 1.1,-0.25
  place = 0
  do for [task = 1:tasks] {
    unset logscale
    set xrange [*:*]
    set yrange [*:*]
    stats columns index task - 1 using (log10($1)) name "T" nooutput
    stats columns index task - 1 using 9 name "LOW" nooutput
    stats columns index task - 1 using 10 name "HIGH" nooutput
    # Times within one power of ten get an axis that begins at a power of ten.
    first = T_max - T_min < 1 ? floor(T_min) : T_min - 0.25
    last = T_max + 0.3 > first + 1.6 ? T_max + 0.3 : first + 1.6
    names = 10**(last + 0.05 * (last - first))
    set logscale xy
    set xrange [10**first:10**(last + 1.05 * (last - first))]
    set yrange [LOW_min:HIGH_max]
    set xtics 10**ceil(first), 10, 10**floor(last)
    top = 1 - (head + each * (place / 2) + 38) / height
    set lmargin at screen 0.055 + 0.5 * (place % 2)
    set rmargin at screen 0.497 + 0.5 * (place % 2)
    set tmargin at screen top
    set bmargin at screen top - (each - 78) / height
    set label 40 titles[task] at graph 0, 1.14 font ",14"
    set label 41 "largest relative error" at graph 0, 1.04 font ",11" textcolor rgb "#707070"
    set label 42 "time of an evaluation, ns" at graph 1, -0.04 right font ",11" textcolor rgb "#707070"
    plot columns index task - 1 using (named(strcol(4), $1)):2:(names - $1):($8 - $2): \
        (paler(colours[int($5)])) with vectors nohead lw 0.8 lc rgb variable, \
      "" index task - 1 using 1:2:(marks[int($6)]):(colours[int($5)]) \
        with points pt variable ps 0.9 lc rgb variable, \
      "" index task - 1 using 1:($3 > 0 ? $2 : NaN):(colours[int($5)]) \
        with points pt 6 ps 1.6 lw 1.5 lc rgb variable, \
      "" index task - 1 using (names):(named(strcol(4), $8)):4:(colours[int($5)]) \
        with labels left offset 0.2,0 font ",12" textcolor rgb variable
    do for [n = 1:30] { unset label n }
    place = place + 1
  }
  unset multiplot
}
