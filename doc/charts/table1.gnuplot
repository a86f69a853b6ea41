# Table 1: seconds over processes, the paper's (dashed) and ours. By table1.sh.
set datafile separator ','
set datafile missing NaN  # lines go on past rows of other curves
set multiplot layout 1,3
set logscale xy 2
set logscale y 10
set xtics (1, 2, 4, 8, 16, 24, 32)
set xrange [0.9:36]
set yrange [5:10000]
set xlabel 'trace processes'
set ylabel 'seconds'
set key top right samplen 2 font ',9'
set grid ytics
ours = 'doc/charts/data/table1.csv'
paper = 'doc/charts/data/paper_table1.csv'
seconds(scene, s, sh) = (strcol(1) eq scene && strcol(3) eq s && strcol(4) eq sh && strcol(6) ne 'o.m.') ? column(6) : NaN
told(scene, s) = (strcol(1) eq scene && strcol(2) eq s && strcol(4) ne 'o.m.') ? column(4) : NaN
do for [scene in 'balls5 room8 room30'] {
  set title scene
  plot paper skip 1 using 3:(told(scene, 'data-parallel')) with linespoints dt 2 lw 2 pt 4 lc rgb '#d95f02' title 'data parallel, paper', \
    ours skip 1 using 5:(seconds(scene, 'data-parallel', 'local')) with linespoints lw 2 pt 5 lc rgb '#d95f02' title 'shadows local', \
    ours skip 1 using 5:(seconds(scene, 'data-parallel', 'travel')) with linespoints lw 2 pt 7 lc rgb '#e6ab02' title 'shadows travel', \
    paper skip 1 using 3:(told(scene, 'hybrid')) with linespoints dt 2 lw 2 pt 4 lc rgb '#1b5e9e' title 'hybrid, paper', \
    ours skip 1 using 5:(seconds(scene, 'hybrid', 'local')) with linespoints lw 2 pt 5 lc rgb '#1b5e9e' title 'hybrid'
}
unset multiplot
