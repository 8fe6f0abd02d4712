# Draws the columns that stability_lab writes: gnuplot -c stability.gp COLUMNS_DIRECTORY OUTPUT.svg
# A row per family, a column per pair of methods; generated code stands behind each pair in black.
columns = ARG1
set terminal svg size 1240,1700 font "Helvetica,12" background "white"
set output ARG2

families = "half-angle special-point fold crossing self-motion parallel-slides \
zero-bar zero-side far-away units"
array titles[10] = ["An angle\ncomes to pi", "Lines BC and ED\nbecome parallel", \
  "Fold: two\nconfigurations\nmeet", "Crossing: a\nparallelogram\nfalls flat", \
  "Self-motion:\nequal links on\nequal bars", "Two slides of\none link become\nparallel", \
  "Bar CD loses\nits length", "Side BC loses\nits length", \
  "Origin at\n1 / distance", "All lengths\ntimes the\ndistance"]
array names[9] = ["generated", "partial-pivot LU", "full-pivot LU", "automatic differentiation", \
  "complex step", "half-angle tangents", "Newton from a neighbour", "central differences", \
  "special points"]
array first[4] = [2, 4, 6, 7]
array second[4] = [3, 5, 9, 8]
blue = 0x0072b2
orange = 0xd55e00
epsilon = 2.0**-52
# Failures have lanes above the line at 1; those of methods outside the panel are transparent, since
# gnuplot warns of files of which nothing is drawn.
lane(method, one, other) = method == other ? 3e6 : method == one ? 3e4 : 3e2
shown(method, one, other) = method == 1 ? 0x111111 : method == one ? blue \
  : method == other ? orange : 0xff000000

left = 0.145
right = 0.99
top = 0.923
bottom = 0.045
gap = 0.012
width = (right - left - 3 * gap) / 4
height = (top - bottom - 10 * gap) / 10
left_of(column) = left + (column - 1) * (width + gap)
top_of(row) = top - (row - 1) * (height + gap) - (row == 10 ? gap : 0)

set logscale xy
set yrange [1e-17:1e9]
set mxtics 1
set mytics 1
set grid xtics ytics lc rgb "#e4e4e4" lt 1
set datafile missing "NaN"
unset key

set multiplot
set label 100 "Largest relative error of the derivatives, as a failure is approached" \
  at screen 0.5,0.988 center font ",18"
set label 101 "black: generated code    dashed: eps times the condition number of J    " \
  . "shaded: failures" at screen 0.5,0.973 center font ",13"
set label 102 "×  some member is off by more than 1%      " \
  . "○  some member is refused by its status" at screen 0.5,0.960 center font ",13"
set label 103 "distance from the failure (last row: factor of all lengths)" \
  at screen 0.57,0.012 center font ",14"
set label 104 "largest relative error against 50 digits" \
  at screen 0.012,0.49 center rotate by 90 font ",14"
do for [column = 1:4] {
  middle = left_of(column) + width / 2
  set label 110 + 2 * column names[first[column]] at screen middle,0.942 center font ",14" \
    tc rgb blue
  set label 111 + 2 * column names[second[column]] at screen middle,0.931 center font ",14" \
    tc rgb orange
}
do for [row = 1:10] {
  family = word(families, row)
  file = sprintf("%s/%s.dat", columns, family)
  failures = sprintf("%s/%s-failures.dat", columns, family)
  set label 130 titles[row] at screen 0.028,top_of(row) - 0.25 * height left font ",13"
  set object 1 rectangle from graph 0, first 1 to graph 1, graph 1 fillcolor rgb "#f4f0ea" \
    fillstyle solid noborder behind
  if (row == 10) {
    set xrange [3e-7:3e6]
    set xtics ("10^{-6}" 1e-6, "10^{-3}" 1e-3, "1" 1, "10^{3}" 1e3, "10^{6}" 1e6)
  } else {
    set xrange [3:3e-15] reverse
    if (row == 9) {
      set xtics ("1" 1, "10^{-4}" 1e-4, "10^{-8}" 1e-8, "10^{-12}" 1e-12)
    } else {
      set xtics ("" 1, "" 1e-4, "" 1e-8, "" 1e-12)
    }
  }
  do for [column = 1:4] {
    set lmargin at screen left_of(column)
    set rmargin at screen left_of(column) + width
    set tmargin at screen top_of(row)
    set bmargin at screen top_of(row) - height
    if (column == 1) {
      set ytics ("10^{-16}" 1e-16, "10^{-8}" 1e-8, "1" 1)
    } else {
      set ytics ("" 1e-16, "" 1e-8, "" 1)
    }
    one = first[column]
    other = second[column]
    plot file index 0 using 1:(epsilon * $2 > 1 ? 1 : epsilon * $2) with lines dt 2 lw 1.2 \
        lc rgb "#777777", \
      file index 0 using 1:3 with lines lw 4 lc rgb "#111111", \
      file index one - 1 using 1:3 with lines lw 2 lc rgb blue, \
      file index other - 1 using 1:3 with lines lw 2 lc rgb orange, \
      failures using 1:(lane($2, one, other)):3:(shown($2, one, other)) with points ps 0.5 lw 1.3 \
        pt variable lc rgb variable
    if (row == 1 && column == 4) {
      unset label
    }
  }
}
unset multiplot
