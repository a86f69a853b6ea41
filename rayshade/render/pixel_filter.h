// What the filter and the contrast test do with the samples of one pixel [rayshade4/1 s.8.2, 8.8].
#pragma once

#include <vector>

#include "rayshade/common/color.h"
#include "rayshade/scene/settings.h"

namespace rayshade {

// Weights of the n*n sub-cells, index b * n + a; their sum is 1.
std::vector<double> FilterWeights(const Settings& settings);

// True where five neighbouring pixels differ too much in some channel.
bool ContrastFires(const Color* const pixels[5], const Color& threshold);

}  // namespace rayshade
