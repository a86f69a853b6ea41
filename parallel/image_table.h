// The images of a scene's textures, which travel with the objects that show them and with nothing
// else: a process that owns nothing an image covers never holds it [DESIGN, RJ s.1: data is where
// it is needed]. Textures without their images are in every process.
//
//   1. Images are numbered from 1 in the order of the first textures that use them; textures that
//   share an image share its number. 0: a texture without an image.
//   2. An image that has arrived stays, like a placement.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rayshade/scene/placement.h"
#include "rayshade/texture/spec.h"

namespace rayshade::parallel {

class ImageTable {
 public:
  ImageTable() = default;
  // The whole table: what the host has.
  explicit ImageTable(const std::vector<TextureSpec>& textures);
  // Numbers alone: what a trace process begins with. WireError where they do not fit the textures.
  ImageTable(const std::vector<TextureSpec>& textures, std::vector<uint32_t> numbers);

  const std::vector<uint32_t>& numbers() const { return numbers_; }  // by texture
  size_t size() const { return images_.size(); }
  bool Holds(uint32_t number) const { return images_[number - 1] != nullptr; }
  const std::shared_ptr<const ImageData>& image(uint32_t number) const {
    return images_[number - 1];
  }
  // False where it is here already. WireError where there is no such number.
  bool Put(uint32_t number, std::shared_ptr<const ImageData> image);
  uint64_t bytes() const { return bytes_; }  // of the images held

  // Calls visit(number) for every image that an object shows: by the textures along its placement,
  // and by those inside of a composite. An image may be visited more than once.
  template <class Visit>
  void ForEachOf(const Placement& placement, const Visit& visit) const {
    if (images_.empty()) return;
    for (const PathLevel& level : placement.levels) ForEachOf(level.attributes, visit);
  }
  template <class Visit>
  void ForEachOf(const GeomSpec& geom, const Visit& visit) const {
    const auto* composite = std::get_if<CompositeSpec>(&geom);
    if (images_.empty() || composite == nullptr || composite->members == nullptr) return;
    for (const PlacedSpec& member : *composite->members) {
      ForEachOf(member.attributes, visit);
      ForEachOf(member.geom, visit);
    }
  }

 private:
  template <class Visit>
  void ForEachOf(const Attributes& attributes, const Visit& visit) const {
    for (const TextureId texture : attributes.textures) {
      if (texture < numbers_.size() && numbers_[texture] != 0) visit(numbers_[texture]);
    }
  }

  std::vector<uint32_t> numbers_;
  std::vector<std::shared_ptr<const ImageData>> images_;
  uint64_t bytes_ = 0;
};

}  // namespace rayshade::parallel
