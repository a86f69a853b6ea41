# Figure 7: data-parallel rays of each process with the share handed on, and its demand-driven rays. By figures.sh.
set datafile separator ','
file = 'doc/charts/data/figure7.csv'
set multiplot layout 1,2
set style data histograms
set style histogram clustered gap 1
set style fill solid 0.9 noborder
set xlabel 'trace process'
set yrange [0:*]
set grid ytics
set xtics font ',8'
set key top left samplen 1 font ',9'
set title 'data parallel'
set ylabel 'rays'
set y2range [0:1]
set y2tics
set y2label 'share handed on'
plot file skip 1 using 2:xtic(1) lc rgb '#d95f02' title 'rays', '' skip 1 using 3:xtic(1) axes x1y2 lc rgb '#999999' title 'handed on'
unset y2tics
unset y2label
set title 'demand driven'
plot file skip 1 using 4:xtic(1) lc rgb '#1b5e9e' title 'rays'
unset multiplot
