# Draws the columns that stability_lab writes: gnuplot -c stability.gp COLUMNS_DIRECTORY OUTPUT.svg
# A panel a family, a line a method; above the line at 1, a lane a method marks where it failed.
columns = ARG1
set terminal svg size 1240,1560 font "Helvetica,13" background "white"
set output ARG2

families = "half-angle special-point fold crossing self-motion parallel-slides \
zero-bar zero-side far-away units"
array titles[10] = ["An angle comes to pi", "Lines BC and ED become parallel", \
  "Fold: two configurations meet", "Crossing: a parallelogram falls flat", \
  "Self-motion: equal links on equal bars", "Two slides of one link become parallel", \
  "Bar CD loses its length", "Side BC loses its length", \
  "The origin is 1/distance away", "All lengths times the distance"]
stats sprintf("%s/half-angle.dat", columns) using 1 nooutput
methods = int(STATS_blocks) - 1  # an empty block ends the file

# Wide lines first, so that what coincides with them lies on them and shows both.
array colours[9] = [0x111111, 0x56b4e9, 0x0072b2, 0x009e73, 0xcc79a7, 0xd55e00, 0xf0c000, 0x999999, \
  0xe00000]
array widths[9] = [5, 3, 1.5, 1, 1.5, 2, 1.5, 1.5, 2]
array names[9] = ["generated", "partial-pivot LU", "full-pivot LU", "automatic differentiation", \
  "complex step", "half-angle tangents", "Newton from a neighbour", "central differences", \
  "special points"]
array order[9] = [1, 2, 3, 4, 8, 7, 5, 6, 9]
epsilon = 2.0**-52
shown(method) = method > 0 ? colours[method] : 0xff000000  # transparent: in every file, lest it be empty
lane(method) = 10.0**(0.5 + 0.95 * method)

set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set ytics 1e-16, 1e4, 1
set yrange [1e-17:10.0**(1.6 + 0.95 * methods)]
set mxtics 1
set mytics 1
set grid xtics ytics lc rgb "#e4e4e4" lt 1
set datafile missing "NaN"
unset key

set multiplot layout 4,3 margins 0.05,0.985,0.03,0.955 spacing 0.055,0.055 \
  title "Largest relative error of the derivatives against 50 digits, over the distance from the failure" \
  font ",17"
do for [panel = 1:10] {
  family = word(families, panel)
  file = sprintf("%s/%s.dat", columns, family)
  failures = sprintf("%s/%s-failures.dat", columns, family)
  set title titles[panel] offset 0,-0.6
  if (panel == 10) {
    set xrange [3e-7:3e6]; set xtics 1e-6, 1e3, 1e6
  } else {
    set xrange [3:3e-15] reverse; set xtics 1e-14, 1e4, 1
    set xtics ("1" 1, "10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, \
      "10^{-10}" 1e-10, "10^{-12}" 1e-12, "10^{-14}" 1e-14)
  }
  set object 1 rectangle from graph 0, first 1 to graph 1, graph 1 fillcolor rgb "#f4f0ea" \
    fillstyle solid noborder behind
  plot file index 0 using 1:(epsilon * $2 > 1 ? 1 : epsilon * $2) with lines dt 2 lw 1.5 lc rgb "#444444", \
    for [k = 1:methods] file index order[k] - 1 using 1:3 with lines lw widths[order[k]] \
      lc rgb colours[order[k]], \
    failures using 1:(lane($2)):3:(shown($2)) with points ps 0.55 lw 1.5 pt variable lc rgb variable
}

# The legend in a panel of its own, its lanes in the order of the lanes above.
unset object 1
unset logscale
unset title
unset tics
unset border
set xrange [0:1]
set yrange [0:1]
set key at graph 0, graph 1 left top Left reverse samplen 3 spacing 1.3 maxrows 10 font ",14"
plot for [k = 1:methods] -1 with lines lw widths[methods + 1 - k] lc rgb colours[methods + 1 - k] \
    title names[methods + 1 - k], \
  -1 with lines dt 2 lw 1.5 lc rgb "#444444" title "eps times the condition number of J"
set key at graph 0, graph 1 left top Left reverse samplen 1
plot -1 with points pt 2 ps 0.8 lw 1.5 lc rgb "#333333" \
    title "on some member: off by more than 1%", \
  -1 with points pt 6 ps 0.8 lw 1.5 lc rgb "#333333" title "on some member: refused by status"
unset multiplot
