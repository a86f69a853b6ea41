# The charts of doc/stability.md from the tables that the program `stability` writes:
# gnuplot -e "data='FOLDER'; charts='FOLDER'" stability.gp
set datafile separator ','
primitives = 'sphere box plane disc triangle Phong_triangle polygon cylinder cone torus blob heightfield'
name(i) = word(primitives, int(i))
title_of(i) = (int(i) == 6) ? 'Phong triangle' : name(i)
# The value of column c in the rows of panel i.
of(i, c) = (strcol(1) eq title_of(i) && column(c) > 0) ? column(c) : NaN
share(i, c, whole) = (strcol(1) eq title_of(i)) ? 100. * column(c) / column(whole) : NaN
palette_ours = '#1b6ca8'
palette_plain = '#c8553d'
set style line 1 lc rgb palette_ours lw 2 pt 7 ps .4
set style line 2 lc rgb palette_plain lw 1.5 pt 6 ps .4
set style line 3 lc rgb '#999999' lw 1 dt 2
set grid lc rgb '#e4e4e4'
set tics font ',9'
set title offset 0,-.6

array kind[2] = ['svg', 'png']
do for [k = 1:2] {
  if (k == 1) { set terminal svg size 1200,1000 font 'sans,11' background rgb 'white' }
  if (k == 2) { set terminal pngcairo size 1200,1000 font 'sans,10' }

  # Columns: 1 primitive, 2 variable, 3 rays, 4 hits, 5 to 9 ours, 10 to 14 plain
  # (wrong, wrong_counts, misplaced, median, worst).
  set logscale xy
  set format x '10^{%T}'
  set format y '10^{%T}'
  set xrange [1e-6:1e9]
  set yrange [1e-23:1e6]
  set ytics 1e-20, 1e5
  do for [v = 1:2] {
    what = v == 1 ? 'distance' : 'size'
    file = data.'/stability-'.what.'.csv'
    set output charts.'/stability-'.what.'.'.kind[k]
    set multiplot layout 4,3 title 'Worst error of a hit across the surface, in object sizes, over '. \
      (v == 1 ? 'the distance of the origin in object sizes' : 'the size of the object, from 10 sizes away')
    do for [i = 1:12] {
      set title title_of(i)
      if (i == 1) { set key top left font ',9' samplen 2 } else { unset key }
      plot file using 2:(of(i, 14)) with linespoints ls 2 title 'textbook', \
           file using 2:(of(i, 9)) with linespoints ls 1 title 'here', \
           (v == 1 ? 1.1e-16 * (x > 1 ? x : 1) : 1.1e-16) with lines ls 3 title 'one rounding of the coordinates'
    }
    unset multiplot
  }

  unset logscale y
  set format y '%g%%'
  set yrange [-5:105]
  set ytics 0, 25
  set output charts.'/stability-wrong.'.kind[k]
  file = data.'/stability-distance.csv'
  set multiplot layout 2,3 title 'Rays whose number of crossings is wrong, over the distance of the origin in object sizes'
  do for [i in '1 8 9 10 11 12'] {
    set title title_of(i)
    if (i == 1) { set key top left font ',9' samplen 2 } else { unset key }
    plot file using 2:(share(i, 11, 3)) with linespoints ls 2 title 'textbook', \
         file using 2:(share(i, 6, 3)) with linespoints ls 1 title 'here'
  }
  unset multiplot
}
