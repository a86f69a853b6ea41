# From the data of one chart of `make accuracy` to a gnuplot script: awk -F, -v title=… -v x=… -f plot.awk FILE.csv
# One curve for each name in the first column, in order of appearance; points worth using (last column 1) are ringed and named
# by their parameter, and those of --quality are stars with their names. The script expects `terminal` and `out`.
BEGIN { curves = 0; low_x = low_y = 1e9 }
NR == 1 { next }
{
  if ($3 < low_x) low_x = $3
  if ($3 > high_x) high_x = $3
  if ($4 < low_y) low_y = $4
  if ($4 > high_y) high_y = $4
}
$1 == "--quality" { ++qualities; quality_x[qualities] = $3; quality_y[qualities] = $4; quality[qualities] = $2; next }
{
  if (!($1 in number)) { number[$1] = curves; name[curves] = $1; ++curves }
  c = number[$1]
  points[c] = points[c] $3 " " $4 "\n"
  if ($NF == 1) { ++fronts; front_x[fronts] = $3; front_y[fronts] = $4; front_name[fronts] = $2; front_curve[fronts] = c }
}
END {
  split("#1f77b4 #d62728 #2ca02c #9467bd #ff7f0e #17becf #8c564b #e377c2 #7f7f7f #bcbd22", color, " ")
  split("7 5 9 13 11 3 2 4 1 6", mark, " ")
  print "if (terminal eq 'svg') set terminal svg size 960,760 font 'DejaVu Sans,12' background '#ffffff'"
  print "if (terminal eq 'png') set terminal pngcairo size 960,760 font 'DejaVu Sans,10'"
  print "set encoding utf8\nset output out"
  printf "set title \"%s\" font ',14'\n", title
  printf "set xlabel \"%s\" offset 0,.6\n", x
  print "set ylabel \"error: root mean square difference from the converged picture (1/255)\""
  print "set logscale xy\nset grid xtics ytics lc rgb '#dddddd'\nset border 3\nset tics nomirror"
  print "set key below maxcols 2 samplen 2 spacing 1.1"
  printf "set xrange [%g:%g]\nset yrange [%g:%g]\n", low_x / 1.3, high_x * 1.35, low_y / 1.25, high_y * 1.3
  print "set xtics (.25, .5, .7, 1, 1.5, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, 100, 200, 300, 500, 1000)"
  print "set ytics (.05, .1, .2, .3, .5, .7, 1, 1.5, 2, 3, 5, 7, 10, 15, 20, 30, 50, 100)"
  for (c = 0; c < curves; c++) printf "$c%d << EOD\n%sEOD\n", c, points[c]
  for (i = 1; i <= fronts; i++) {
    if (i == 1) print "$front << EOD"
    print front_x[i], front_y[i]
    if (i == fronts) print "EOD"
    labels = labels sprintf("set label \"%s\" at %s,%s offset .8,.7 font ',9' tc rgb '%s'\n", front_name[i], front_x[i], front_y[i], color[front_curve[i] % 10 + 1])
  }
  for (i = 1; i <= qualities; i++) {
    if (i == 1) print "$quality << EOD"
    print quality_x[i], quality_y[i]
    if (i == qualities) print "EOD"
    labels = labels sprintf("set label \"%s\" at %s,%s right offset -.9,-.7 font ',9'\n", quality[i], quality_x[i], quality_y[i])
  }
  printf "%s", labels
  for (c = 0; c < curves; c++) {
    plots = plots (c ? ", \\\n  " : "") sprintf("$c%d using 1:2 with linespoints lw 1.5 pt %s ps .8 lc rgb '%s' title \"%s\"", c, mark[c % 10 + 1], color[c % 10 + 1], name[c])
  }
  if (fronts) plots = plots ", \\\n  $front using 1:2 with points pt 6 ps 2 lw 1.2 lc rgb '#000000' title \"worth using (the measured front)\""
  if (qualities) plots = plots ", \\\n  $quality using 1:2 with points pt 3 ps 1.6 lw 1.5 lc rgb '#000000' title \"--quality\""
  print "plot " plots
}
