// Reads machines; see machine.h.
#include "parallel/sim/machine.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

namespace rayshade::parallel {

namespace {

const char* const kTagsOfNumbers[] = {"paper", "manual", "measured", "fitted", "assumed"};

[[noreturn]] void Refuse(const std::string& name, int line, const std::string& what) {
  throw std::runtime_error(name + ":" + std::to_string(line) + ": " + what);
}

// One line: a number by name, if there is one on it.
void ReadLine(const std::string& name, int number, const std::string& line,
              const std::map<std::string, double*>& wanted, std::map<std::string, int>* seen) {
  std::istringstream words(line.substr(0, line.find('#')));
  std::string key, tag;
  double value = 0;
  if (!(words >> key)) return;
  const auto it = wanted.find(key);
  if (it == wanted.end()) Refuse(name, number, "no machine has a \"" + key + "\"");
  if (!seen->try_emplace(key, number).second) Refuse(name, number, key + " is there twice");
  if (!(words >> value) || !(value >= 0) || value > 1e18)
    Refuse(name, number, key + " must be a number, not negative");
  if (!(words >> tag) || std::find(std::begin(kTagsOfNumbers), std::end(kTagsOfNumbers), tag) ==
                             std::end(kTagsOfNumbers)) {
    Refuse(name, number,
           key + " must say where it is from: paper, manual, measured, fitted or assumed");
  }
  *it->second = value;
}

}  // namespace

Machine ParseMachine(const std::string& name, const std::string& text) {
  Machine machine;
  std::map<std::string, double*> wanted;
#define RAYSHADE_WANT(name) wanted[#name] = &machine.name;
  RAYSHADE_MACHINE(RAYSHADE_WANT)
#undef RAYSHADE_WANT
  std::map<std::string, int> seen;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) ReadLine(name, ++number, line, wanted, &seen);
  for (const auto& [key, value] : wanted)
    if (!seen.contains(key)) Refuse(name, number, key + " is missing");
  if (machine.slowness <= 0 || machine.node_slowness <= 0)
    Refuse(name, number, "slowness and node_slowness are more than nothing");
  if (machine.nodes < 1 || machine.processors < 1 || machine.process_bytes() <= 0)
    Refuse(name, number, "a machine has nodes, processors and memory beside its system");
  machine.name = name;
  return machine;
}

Machine FindMachine(const std::string& name_or_file) {
  std::string names;
  for (const BuiltInMachine& machine : BuiltInMachines()) {
    if (machine.name == name_or_file) return ParseMachine(name_or_file, machine.text);
    names += (names.empty() ? "" : ", ") + std::string(machine.name);
  }
  std::ifstream file(name_or_file);
  if (!file)
    throw std::runtime_error("--machine " + name_or_file + ": neither a machine (" + names +
                             ") nor a file that can be read");
  return ParseMachine(name_or_file,
                      {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
}

}  // namespace rayshade::parallel
