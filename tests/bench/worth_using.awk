# One chart's part of doc/charts/README.md: the picture, what --quality buys there, and the measured front, fastest first.
NR == 1 { next }
$1 == "--quality" { quality = quality sprintf("| `%s` | %.1f | %.2f | %.1f |\n", $2, $3, $4, $5) }
$NF == 1 { ++n; time[n] = $3; line[n] = sprintf("%s, %s: %.1f x, error %.2f", $1, $2, $3, $4) }
END {
  printf "\n## %s\n\n![%s](%s.png)\n\n[data](data/%s.csv)\n", title, title, name, name
  if (quality != "") {
    printf "\n| `--quality` | time | error | pixels off, %% |\n| --- | --- | --- | --- |\n%s", quality
  }
  if (n == 0) exit
  printf "\nWorth using (nothing measured here is both faster and more exact):\n\n"
  for (i = 1; i <= n; i++) {
    for (k = i; k > 1 && time[order[k - 1]] > time[i]; k--) order[k] = order[k - 1]
    order[k] = i
  }
  for (i = 1; i <= n; i++) printf "- %s\n", line[order[i]]
}
