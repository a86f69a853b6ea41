# Which schedule wins: a column for each network and memory, a row for each coherence. By map.sh.
set datafile separator ','
file = 'doc/charts/data/map_winners.csv'
row(d) = d == 0 ? 0 : d == 1 ? 1 : 2
network(s) = s eq 'slow' ? 0 : s eq '1g' ? 1 : 2
memory(s) = s eq '768K' ? 0 : s eq '2M' ? 1 : 2
winner(s) = s eq 'data-parallel' ? 1 : s eq 'demand-driven' ? 2 : s eq 'hybrid' ? 3 : 0
set multiplot layout 1,3 title 'winner (orange: data parallel, green: demand driven, blue: hybrid) and how many times as fast it is as the second' font ',10'
unset colorbox
set palette maxcolors 4 defined (0 '#dddddd', 1 '#d95f02', 2 '#7fbf7b', 3 '#5e9ed6')
set cbrange [-0.5:3.5]
set xrange [-0.5:8.5]
set yrange [-0.5:2.5]
set ytics ('depth 0' 0, 'depth 1' 1, 'depth 5' 2)
set xtics rotate by 60 right ('slow 768K' 0, 'slow 2M' 1, 'slow 32M' 2, '1g 768K' 3, '1g 2M' 4, '1g 32M' 5, '100g 768K' 6, '100g 2M' 7, '100g 32M' 8)
unset key
do for [n in '8 32 128'] {
  set title n.' processes' font ',9'
  rows = "< grep '^".n.",' ".file
  plot rows using (3 * network(strcol(2)) + memory(strcol(3))):(row(column(4))):(.5):(.5):(winner(strcol(5))) with boxxyerror fc palette fs solid border lc 'white', \
    '' using (3 * network(strcol(2)) + memory(strcol(3))):(row(column(4))):6 with labels font ',9'
}
unset multiplot
