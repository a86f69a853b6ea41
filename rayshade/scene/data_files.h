// Files that a scene names: colour maps, height fields and images. Each is read once, at parse
// time.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "rayshade/common/diagnostics.h"
#include "rayshade/geom/spec.h"
#include "rayshade/texture/spec.h"

namespace rayshade {

struct DataFileError : std::runtime_error {
  DataFileError(Severity severity, const std::string& text)
      : std::runtime_error(text), severity(severity) {}
  Severity severity;
};

// Names are relative to the working directory, or where there is no such file to that of the scene.
// All throw DataFileError in Rayshade's words, each time that a bad file is asked for.
class DataFiles {
 public:
  explicit DataFiles(const std::string& scene_file);

  std::shared_ptr<const ColorMap> ReadColorMap(const std::string& name);
  // Rayshade's own format, or a square PNG (altitude: value / 255, bottom row first).
  HeightfieldSpec ReadHeightfield(const std::string& name);
  // PNG, or "width height", newline, and RGB bytes with the row of v = 0 first.
  std::shared_ptr<const ImageData> ReadImage(const std::string& name);

 private:
  std::string Find(const std::string& name) const;

  std::string folder_;  // of the scene, with a slash at its end; empty: the working directory
  std::map<std::string, std::shared_ptr<const ColorMap>> maps_;
  std::map<std::string, HeightfieldSpec> heightfields_;
  std::map<std::string, std::shared_ptr<const ImageData>> images_;
};

}  // namespace rayshade
