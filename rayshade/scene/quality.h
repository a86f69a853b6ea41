// --quality: how much accuracy a picture buys with how much time, as points on the measured front
// (`make accuracy`, doc/charts). It stands between the file and the single options: it replaces
// what the file says about sampling, and gives way to -S, -T, -j, -D and -C.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "rayshade/scene/settings.h"

namespace rayshade {

enum class Quality : uint8_t { kDraft, kRayshade, kFine, kReference };

// Nothing where no quality has this name.
std::optional<Quality> QualityNamed(std::string_view name);
void ApplyQuality(Quality quality, Settings* settings);

}  // namespace rayshade
