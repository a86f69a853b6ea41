// The help text of a program.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "rayshade/scene/options.h"

namespace rayshade {

// Those of all programs, then the program's own.
std::vector<LongOption> AllLongOptions(const std::vector<LongOption>& own);

void PrintUsage(std::FILE* stream, const std::string& program, const std::vector<LongOption>& own);

}  // namespace rayshade
