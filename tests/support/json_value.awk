# Prints one value of a JSON file: awk -v key=rays.total -f json_value.awk FILE
# The key is a path of member names (and array indices from 0). Prints nothing where there is no such value.
# Enough for our own statistics: no escapes inside strings.
{ text = text $0 " " }
END {
  depth = 0
  is_key = 1
  while (match(text, /"[^"]*"|[][{},:]|[^][{},: \t"]+/)) {
    token = substr(text, RSTART, RLENGTH)
    text = substr(text, RSTART + RLENGTH)
    if (token == "{" || token == "[") { depth++; kind[depth] = token; name[depth] = 0 }
    else if (token == "}" || token == "]") { depth-- }
    else if (token == ",") { if (kind[depth] == "[") name[depth]++; else is_key = 1; continue }
    else if (token == ":") { is_key = 0; continue }
    else {
      gsub(/"/, "", token)
      if (kind[depth] == "{" && is_key) { name[depth] = token; continue }
      path = name[1]
      for (i = 2; i <= depth; i++) path = path "." name[i]
      if (path == key) { print token; exit }
    }
    is_key = 1
  }
}
