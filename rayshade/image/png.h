// Pictures as PNG files, and images for textures. The only code that knows libpng.
#pragma once

#include <string>

#include "rayshade/image/picture.h"
#include "rayshade/texture/spec.h"

namespace rayshade {

enum class AlphaChannel { kNone, kCoverage, kSampleMap };

// Quantises as Rayshade does [rayshade4/1 s.10] and writes beside the file, then renames: the file
// is whole or as before. Holds nothing but the pixels (no time, command or host). Throws
// std::runtime_error naming file and reason.
// "-" writes to standard output.
void WritePng(const Picture& picture, const std::string& file, double gamma, AlphaChannel alpha);

// Throws where the file cannot be written later, before any work is done: missing directory, no
// permission.
void CheckWritable(const std::string& file);

// A PNG as image data, row 0 at the bottom; 1 or 3 channels of 8 bits, alpha apart. Throws
// std::runtime_error.
ImageData ReadPng(const std::string& file);

}  // namespace rayshade
