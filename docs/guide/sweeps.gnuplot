# Turns the CSV of a sweep of the worked mechanism into docs/guide/sweeps.svg:
#   build/assur sweep examples/quintero_2011_rrp_rrr.json > sweep.csv
#   gnuplot -e "csv='sweep.csv'" docs/guide/sweeps.gnuplot
set terminal svg size 900,480 font "sans,13" background "white"
set output "docs/guide/sweeps.svg"
set key off
set xlabel "crank angle phi [deg]"
set ylabel "lever joint D, y [mm]"
set xrange [0:360]
set yrange [-330:330]
set xtics 45
set grid lc rgb "#dddddd"
select(condition) = sprintf("< awk -F, 'NR==1 {for (i=1; i<=NF; i++) c[$i]=i; next} %s \
  {print $c[\"phi\"]*180/3.14159265358979, $c[\"D.y\"], \"\\\"\" $NF \"\\\"\"}' %s", condition, csv)
array colours[6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]
# A branch is drawn to the dead centres that name it, and its own name stands beside the middle of it.
array names_x[6] = [180, 95, 185, 139, 242, 312]
array names_y[6] = [-240, 312, 20, 122, 0, 225]
do for [b=1:6] {
  set label b sprintf("branch %d", b) at names_x[b], names_y[b] tc rgb colours[b]
}
# Branches lie to the left of a fold and to the right of a birth, so labels go to the other side.
plot for [b=1:6] select(sprintf("$3==%d || $NF ~ / %d( |$)/", b, b)) using 1:2 with lines lw 2 lc rgb colours[b], \
     select("$NF!=\"\"") using 1:2 with points pt 7 ps 0.7 lc rgb "black", \
     select("$NF~/^fold/") using 1:2:3 with labels left offset 0.8,0, \
     select("$NF~/^birth/") using 1:2:3 with labels right offset -0.8,0
