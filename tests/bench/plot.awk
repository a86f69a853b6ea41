# From the data of one chart of `make accuracy` to a gnuplot script: awk -F, -v title=… -v x=… [-v y=…] -f plot.awk FILE.csv
# One curve for each name in the first column, in order of appearance; points of the measured front (last column 1: none is
# both faster and more exact) are ringed and named by their parameter. The script expects `terminal` and `out`.
NR == 1 { next }
{
  if (!($1 in number)) { number[$1] = curves; name[curves] = $1; ++curves }
  c = number[$1]
  points[c] = points[c] $3 " " $4 "\n"
  if ($NF == 1) { ++fronts; front_x[fronts] = $3; front_y[fronts] = $4; front_name[fronts] = $2; front_curve[fronts] = c }
}
END {
  split("#1f77b4 #d62728 #2ca02c #9467bd #ff7f0e #17becf #8c564b #e377c2 #7f7f7f #bcbd22", color, " ")
  split("7 5 9 13 11 3 2 4 1 6", mark, " ")
  print "if (terminal eq 'svg') set terminal svg size 960,720 font 'DejaVu Sans,13' background '#ffffff'"
  print "if (terminal eq 'png') set terminal pngcairo size 960,720 font 'DejaVu Sans,11'"
  print "set output out"
  printf "set title \"%s\" font ',15'\n", title
  printf "set xlabel \"%s\"\n", x
  printf "set ylabel \"%s\"\n", y != "" ? y : "error: root mean square difference from the converged picture (1/255)"
  print "set logscale xy\nset grid xtics ytics mytics lc rgb '#dddddd', lc rgb '#eeeeee'\nset border 3\nset tics nomirror"
  print "set key below maxcols 3 samplen 2\nset offsets graph 0.05, graph 0.08, graph 0.08, graph 0.05"
  print "set xtics (.25, .5, 1, 2, 3, 5, 10, 20, 30, 50, 100, 200, 300, 500, 1000)"
  print "set ytics (.05, .1, .2, .3, .5, 1, 2, 3, 5, 10, 20, 30, 50, 100)"
  for (c = 0; c < curves; c++) printf "$c%d << EOD\n%sEOD\n", c, points[c]
  if (fronts) {
    print "$front << EOD"
    for (i = 1; i <= fronts; i++) print front_x[i], front_y[i]
    print "EOD"
  }
  for (i = 1; i <= fronts; i++)
    printf "set label \"%s\" at %s,%s offset .7,.6 font ',9' tc rgb '%s'\n", front_name[i], front_x[i], front_y[i], color[front_curve[i] % 10 + 1]
  printf "plot "
  for (c = 0; c < curves; c++)
    printf "$c%d using 1:2 with linespoints lw 1.5 pt %s ps .7 lc rgb '%s' title \"%s\"%s", c, mark[c % 10 + 1], color[c % 10 + 1], name[c], c + 1 < curves || fronts ? ", \\\n  " : "\n"
  if (fronts) print "$front using 1:2 with points pt 6 ps 2 lw 1.2 lc rgb '#000000' title \"worth using (the measured front)\""
}
