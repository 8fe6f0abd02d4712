# Turns the CSV of two sweeps into docs/guide/forces_crane.svg and docs/guide/forces_four_bar.svg:
#   build/assur sweep examples/crane.json --nearest > crane.csv
#   build/assur sweep examples/four_bar_torque.json --nearest > four_bar.csv
#   gnuplot -e "crane='crane.csv'; four_bar='four_bar.csv'" docs/guide/forces.gnuplot
set terminal svg size 460,300 font "sans,12" background "white"
set key off
set grid lc rgb "#dddddd"
column_of(x, y, file) = sprintf("< awk -F, 'NR==1 {for (i=1; i<=NF; i++) c[$i]=i; next} $NF==\"\" \
  {print $c[\"%s\"], $c[\"%s\"]}' %s", x, y, file)
set output "docs/guide/forces_crane.svg"
set xlabel "length of the cylinder [m]"
set ylabel "force of the cylinder [kN]"
set yrange [0:100]
plot column_of("stroke", "cylinder.effort", crane) using 1:($2/1000) with lines lw 2 lc rgb "#0072b2"
set output "docs/guide/forces_four_bar.svg"
set xlabel "angle of the crank [deg]"
set ylabel "torque at the crank [N m]"
set xrange [0:360]
set yrange [-3:3]
set xtics 60
degrees(x) = (x * 180 / pi) - 360 * floor(x / (2 * pi))
plot column_of("phi", "A.effort", four_bar) using (degrees($1)):2 smooth unique with lines lw 2 lc rgb "#d55e00"
