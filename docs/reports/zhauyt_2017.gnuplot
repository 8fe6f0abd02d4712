# Turns the CSV of the third-class six-bar's sweep into the figures of docs/reports/zhauyt_2017.md:
#   assur sweep examples/zhauyt_2017_six_bar.json > six_bar.csv
#   gnuplot -e "csv='six_bar.csv'" docs/reports/zhauyt_2017.gnuplot
# Branch 2 is the one whose output dwells. The paper's figures 2 to 8 are named in the titles.
select(columns) = sprintf("< awk -F, 'NR==1 {for (i=1; i<=NF; i++) c[$i]=i; next} \
  $c[\"branch\"]==2 {n = split(\"%s\", k, \" \"); for (i=1; i<=n; i++) printf \"%%s \", $c[k[i]]; print \"\"}' %s", columns, csv)
deg(x) = x * 180 / pi
size2(x, y) = sqrt(x * x + y * y)
set grid lc rgb "#dddddd"
set key off
blue = "#1f5fa8"; red = "#b5481d"; grey = "#777777"

set terminal svg size 900,680 font "sans,13" background "white"
set output "docs/reports/zhauyt_2017_rates.svg"
set multiplot layout 2,2 margins 0.09,0.98,0.09,0.93 spacing 0.12,0.17
set xrange [0:360]
set xtics 60
set yrange [0:*]
set ylabel "mm/s"
set title "|v| of M (fig. 2)"
plot select("phi M.vx M.vy") using (deg($1)):(size2($2, $3)) with lines lw 2 lc rgb blue
set ylabel "mm/s^2"
set title "|a| of M (fig. 3)"
plot select("phi M.ax M.ay") using (deg($1)):(size2($2, $3)) with lines lw 2 lc rgb blue
set xlabel "crank angle [deg]"
set title "|a_t| of M (fig. 4)"
plot select("phi M.a_tangential") using (deg($1)):(abs($2)) with lines lw 2 lc rgb blue
set title "|a_n| of M (fig. 5)"
plot select("phi M.a_normal") using (deg($1)):(abs($2)) with lines lw 2 lc rgb blue
unset multiplot

set terminal svg size 900,880 font "sans,13" background "white"
set output "docs/reports/zhauyt_2017_hodographs.svg"
set multiplot layout 2,1 margins 0.08,0.97,0.08,0.95 spacing 0.1,0.13
set size ratio -1
set xtics auto
set autoscale
set offsets graph 0.04, graph 0.04, graph 0.12, graph 0.12
# Dots every 30 degrees of the crank; only those that stand apart have room for a number.
dot(k) = int(k) % 30 == 0 && k < 360
number(k, x) = dot(k) ? x : 1/0
apart(k, x) = k > 130 && k < 250 ? number(k, x) : 1/0
set title "velocity of M (fig. 6)"
set xlabel "v_x  [mm/s]"; set ylabel "v_y  [mm/s]" offset 1
plot select("M.vx M.vy step") using 1:2 with lines lw 2 lc rgb blue, \
     "" using (number($3, $1)):2 with points pt 7 ps 0.5 lc rgb red, \
     "" using ($3 == 270 ? 1/0 : number($3, $1)):2:3 with labels offset -1.2,-0.8 font ",11" tc rgb grey, \
     "" using ($3 == 270 ? $1 : 1/0):2:3 with labels offset 1.4,0.6 font ",11" tc rgb grey
set title "acceleration of M (fig. 7)"
set xlabel "a_x  [mm/s^2]"; set ylabel "a_y  [mm/s^2]" offset 1
set yrange [-95:95]
plot select("M.ax M.ay step") using 1:2 with lines lw 2 lc rgb blue, \
     "" using (number($3, $1)):2 with points pt 7 ps 0.5 lc rgb red, \
     "" using (apart($3, $1)):2:3 with labels offset -1.2,-0.8 font ",11" tc rgb grey
# The angles that crowd have a part of the picture of their own.
set lmargin at screen 0.40; set rmargin at screen 0.64
set bmargin at screen 0.29; set tmargin at screen 0.44
set offsets
set xrange [-55:-27]; set yrange [4:22]
unset title; unset xlabel; unset ylabel
set xtics 5 font ",11"; set ytics 5 font ",11"
plot select("M.ax M.ay step") using 1:2 with lines lw 2 lc rgb blue, \
     "" using (number($3, $1)):2 with points pt 7 ps 0.5 lc rgb red, \
     "" using ($3 < 300 ? number($3, $1) : 1/0):2:3 with labels offset 1.6,-0.6 font ",11" tc rgb grey, \
     "" using ($3 < 300 ? 1/0 : number($3, $1)):2:3 with labels offset -1.8,0 font ",11" tc rgb grey
unset lmargin; unset rmargin; unset bmargin; unset tmargin
set xtics auto font "sans,13"; set ytics auto font "sans,13"; set autoscale
unset multiplot
set offsets

set terminal svg size 900,420 font "sans,13" background "white"
set output "docs/reports/zhauyt_2017_errors.svg"
set size noratio
set title "errors of M (fig. 8)"
set xrange [0:360]
set xtics 30
set yrange [0:*]
set xlabel "crank angle [deg]"
set ylabel "error [mm]"
set label 1 "worst case of x" at 172, 1.5 center tc rgb blue
set label 2 "worst case of y" at 190, 0.91 center tc rgb red
set label 3 "root sum square of x" at 60, 0.25 center tc rgb blue
set label 4 "root sum square of y" at 60, 0.085 center tc rgb red
plot select("phi M.worst_case_x") using (deg($1)):2 with lines lw 2 lc rgb blue, \
     select("phi M.worst_case_y") using (deg($1)):2 with lines lw 2 lc rgb red, \
     select("phi M.rss_x") using (deg($1)):2 with lines dt 2 lc rgb blue, \
     select("phi M.rss_y") using (deg($1)):2 with lines dt 2 lc rgb red
unset for [n = 1:4] label n

set output "docs/reports/zhauyt_2017_output.svg"
set title "output link DG: dwell of 146 deg within half a degree"
set yrange [-32:*]
set ylabel "angle of DG [deg]"
set arrow 1 from 86, graph 0 to 86, graph 1 nohead dt 2 lc rgb grey
set arrow 2 from 300, graph 0 to 300, graph 1 nohead dt 2 lc rgb grey
plot select("phi output.theta") using (deg($1)):(deg($2)) with lines lw 2 lc rgb blue
