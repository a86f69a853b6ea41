# Unit costs from measured runs: nonnegative least squares of relative errors, by coordinate descent.
#   awk -f fit.awk FILE
# FILE: a first line of names, then one line a run: its name, seconds, and how often each operation was done.
# Prints "NAME SECONDS" for each operation, and on standard error how well each run is told.
NR == 1 { n = NF; for (j = 1; j <= n; j++) name[j] = $j; next }
{
  m++
  run[m] = $1
  seconds[m] = $2
  for (j = 1; j <= n; j++) count[m, j] = $(j + 2) / $2
}
END {
  for (j = 1; j <= n; j++) for (k = 1; k <= n; k++) for (i = 1; i <= m; i++) square[j, k] += count[i, j] * count[i, k]
  for (j = 1; j <= n; j++) for (i = 1; i <= m; i++) right[j] += count[i, j]
  for (turn = 0; turn < 200000; turn++) {
    for (j = 1; j <= n; j++) {
      if (square[j, j] == 0) continue
      rest = right[j]
      for (k = 1; k <= n; k++) if (k != j) rest -= square[j, k] * cost[k]
      cost[j] = rest > 0 ? rest / square[j, j] : 0
    }
  }
  for (j = 1; j <= n; j++) printf "%s %.4g\n", name[j], cost[j]
  for (i = 1; i <= m; i++) {
    told = 0
    for (j = 1; j <= n; j++) told += count[i, j] * cost[j]
    printf "%-16s %8.4f s, told %+5.1f%%\n", run[i], seconds[i], 100 * (told - 1) >"/dev/stderr"
  }
}
