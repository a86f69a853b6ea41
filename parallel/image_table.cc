// Which images there are and which are here; see image_table.h.
#include "parallel/image_table.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "parallel/wire.h"

namespace rayshade::parallel {

ImageTable::ImageTable(const std::vector<TextureSpec>& textures) : numbers_(textures.size()) {
  for (size_t t = 0; t < textures.size(); ++t) {
    const auto* spec = std::get_if<ImageSpec>(&textures[t].kind);
    if (spec == nullptr || spec->image == nullptr) continue;
    auto known = std::find(images_.begin(), images_.end(), spec->image);
    if (known == images_.end()) {
      bytes_ += spec->image->color.size() + spec->image->alpha.size();
      known = images_.insert(known, spec->image);
    }
    numbers_[t] = static_cast<uint32_t>(known - images_.begin() + 1);
  }
}

ImageTable::ImageTable(const std::vector<TextureSpec>& textures, std::vector<uint32_t> numbers)
    : numbers_(std::move(numbers)) {
  if (numbers_.size() != textures.size()) throw WireError("image numbers for other textures");
  uint32_t greatest = 0;
  for (size_t t = 0; t < textures.size(); ++t) {
    if (std::holds_alternative<ImageSpec>(textures[t].kind) != (numbers_[t] != 0) ||
        numbers_[t] > textures.size()) {
      throw WireError("an image number that fits no texture");
    }
    greatest = std::max(greatest, numbers_[t]);
  }
  images_.resize(greatest);
}

bool ImageTable::Put(uint32_t number, std::shared_ptr<const ImageData> image) {
  if (number == 0 || number > images_.size() || image == nullptr) {
    throw WireError("an image of no texture");
  }
  if (Holds(number)) return false;
  bytes_ += image->color.size() + image->alpha.size();
  images_[number - 1] = std::move(image);
  return true;
}

}  // namespace rayshade::parallel
