// Values to bytes and back, for pictures that were cut short: in the byte order of the machine.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

#include "rayshade/image/picture.h"

namespace rayshade {

class ByteWriter {
 public:
  template <typename T>
  void Put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  // Only the members of a pixel, never what lies between them.
  void PutRow(const PixelValue* row, int width) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) Put(row[x].color[c]);
      Put(row[x].alpha);
      Put(static_cast<uint8_t>(row[x].full));
    }
  }
  std::string bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

inline constexpr uint64_t kSavedPixelBytes = 4 * sizeof(double) + 1;

// Reading past the end gives zeros; Holds tells beforehand.
class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(bytes) {}

  bool Holds(uint64_t more) const { return bytes_.size() - at_ >= more; }
  template <typename T>
  T Get() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    if (!Holds(sizeof value)) return value;
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  void GetRow(PixelValue* row, int width) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) row[x].color[c] = Get<double>();
      row[x].alpha = Get<double>();
      row[x].full = Get<uint8_t>() != 0;
    }
  }

 private:
  const std::string& bytes_;
  size_t at_ = 0;
};

}  // namespace rayshade
