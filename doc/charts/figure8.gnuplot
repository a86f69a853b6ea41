# Figure 8: the share of processes that is busy over time. By figures.sh.
set datafile separator ','
file = 'doc/charts/data/figure8.csv'
schedules = system("awk -F, 'NR > 1 && !($1 in seen) { seen[$1]; printf \"%s \", $1 }' ".file)
set multiplot layout 1,words(schedules)
set style fill solid 0.9 noborder
set yrange [0:1]
set xlabel 'seconds since the first ray'
set ylabel 'share of processes busy'
set grid ytics
unset key
do for [s in schedules] {
  set title s
  plot file skip 1 using (strcol(1) eq s ? ($3 + $4) / 2 : NaN):5:(0.95 * ($4 - $3)) with boxes lc rgb '#1b5e9e'
}
unset multiplot
