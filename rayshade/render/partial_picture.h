// NAME.png.partial: a picture that was cut short, kept beside the place of the whole one until that
// is written. It holds the state of the sampling, so that -c goes on to exactly the picture of an
// undisturbed run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rayshade/scene/settings.h"

namespace rayshade {

std::string PartialFile(const std::string& file);

// Everything that must be the same for a picture to go on, as text.
std::string PictureFingerprint(const Settings& settings, int frame, uint64_t objects);

// Throws std::runtime_error where it cannot be written.
void WritePartial(const std::string& file, const std::string& fingerprint,
                  const std::string& state);
// The state kept for this file, or none. Throws std::runtime_error where it is of another picture.
std::optional<std::string> ReadPartial(const std::string& file, const std::string& fingerprint);
void RemovePartial(const std::string& file);

}  // namespace rayshade
