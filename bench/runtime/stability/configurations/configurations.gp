# Draws the columns that configurations_lab writes: gnuplot -c configurations.gp COLUMNS_DIRECTORY OUTPUT.svg
# A row per family, a panel per method: bars go up for what is invented, down for what is lost.
columns = ARG1
set terminal svg size 1240,800 font "Helvetica,13" background "white"
set output ARG2

families = "shared-unknown some-to-infinity all-to-infinity"
array titles[3] = ["RRR-RRR: two of its configurations come to share the final unknown", \
  "PPR-RRP: slides of a link become parallel, two of four configurations run to infinity", \
  "RPR-RPR: slides of a link become parallel, both configurations run to infinity"]
array methods[5] = ["generated", "companion eigenvalues", "half-angle polynomial", "grid of 360", \
  "Newton from 64 starts"]
LOST = 0xd55e00
INVENTED = 0x0072b2

left = 0.062
width = 0.1755
gap = 0.0115
height = 0.2
bottom(row) = 0.875 - height - (row - 1) * 0.307
span(row) = 46
set style fill solid noborder
set boxwidth 0.8
unset key
set border 0
set grid ytics lc rgb "#e4e4e4" lt 1
set xrange [0.3:15.7]
set multiplot title "Configurations invented (up) and lost (down), of 20 groups at each distance from the failure" font ",17"
do for [row = 1:3] {
  family = word(families, row)
  file = sprintf("%s/%s.dat", columns, family)
  set label 1 titles[row] at screen left, screen bottom(row) + height + 0.064 font ",15" tc rgb "#111111"
  do for [k = 1:5] {
    stats file index k - 1 using 2 name "L" nooutput
    stats file index k - 1 using 3 name "I" nooutput
    set lmargin at screen left + (k - 1) * (width + gap)
    set rmargin at screen left + (k - 1) * (width + gap) + width
    set bmargin at screen bottom(row)
    set tmargin at screen bottom(row) + height
    set yrange [-span(row):span(row)]
    if (k == 1) { set ytics ("40" -40, "20" -20, "0" 0, "20" 20, "40" 40) scale 0
    } else { set ytics ("" -40, "" -20, "" 0, "" 20, "" 40) scale 0 }
    set xtics ("10^{-1}" 1, "10^{-4}" 4, "10^{-7}" 7, "10^{-10}" 10, "10^{-13}" 13, "0" 15) scale 0 \
      font ",11" offset 0,0.3
    if (k == 1) { set ylabel "configurations" offset 1.2,0 } else { unset ylabel }
    if (row == 3) { set xlabel "distance from the failure" offset 0,0.4 } else { unset xlabel }
    set label 2 methods[k] at graph 0.02, graph 1.17 font ",13" tc rgb "#111111"
    set label 3 (I_sum > 0 ? sprintf("%d invented", I_sum) : "none invented") at graph 0.02, graph 1.05 \
      font ",12" tc rgb (I_sum > 0 ? INVENTED : 0x888888)
    set label 4 (L_sum > 0 ? sprintf("%d lost", L_sum) : "none lost") at graph 0.55, graph 1.05 \
      font ",12" tc rgb (L_sum > 0 ? LOST : 0x888888)
    plot file index k - 1 using 1:3 with boxes lc rgb INVENTED, \
      file index k - 1 using 1:(-$2) with boxes lc rgb LOST, \
      0 with lines lc rgb "#888888" lw 1
    unset label 1
  }
}
unset multiplot
