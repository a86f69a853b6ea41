// An array of plain values that grows by an eighth and through realloc, so that a large one is
// remapped by the operating system rather than copied, and pages that were never written cost
// nothing: millions of spheres are held once even while they are being read. Elements lie at
// multiples of their alignment, however large.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace rayshade {

template <typename T>
class GrowingArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  GrowingArray() = default;
  GrowingArray(GrowingArray&& o) noexcept { *this = std::move(o); }
  GrowingArray& operator=(GrowingArray&& o) noexcept {
    std::swap(block_, o.block_);
    std::swap(data_, o.data_);
    std::swap(size_, o.size_);
    std::swap(capacity_, o.capacity_);
    return *this;
  }
  GrowingArray(const GrowingArray&) = delete;
  GrowingArray& operator=(const GrowingArray&) = delete;
  ~GrowingArray() { std::free(block_); }

  void push_back(const T& value) {
    const T copy = value;
    if (size_ == capacity_) Reserve(size_ + size_ / 8 + 16);
    data_[size_++] = copy;
  }
  // New elements are zero bytes.
  void resize(size_t size) {
    if (size > capacity_) Reserve(size);
    for (size_t i = size_; i < size; ++i) data_[i] = T{};
    size_ = size;
  }
  void clear() { size_ = 0; }
  // Gives back what growing took in advance, but for `spare` elements that may be read (and hold
  // nothing).
  void ShrinkToFit(size_t spare = 0) {
    if (size_ == 0) spare = 0;
    if (capacity_ != size_ + spare) Reserve(size_ + spare);
  }

  T& operator[](size_t i) { return data_[i]; }
  const T& operator[](size_t i) const { return data_[i]; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  size_t bytes() const { return capacity_ * sizeof(T); }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

 private:
  static constexpr size_t kExtra = alignof(T) > alignof(std::max_align_t) ? alignof(T) : 0;

  void Reserve(size_t capacity) {
    if (capacity == 0) {
      std::free(block_);
      block_ = nullptr;
      data_ = nullptr;
    } else {
      const size_t shift = reinterpret_cast<char*>(data_) - static_cast<char*>(block_);
      void* moved = std::realloc(block_, capacity * sizeof(T) + kExtra);
      if (moved == nullptr) throw std::bad_alloc();
      block_ = moved;
      const uintptr_t address = reinterpret_cast<uintptr_t>(moved);
      const size_t aligned = (address + alignof(T) - 1) / alignof(T) * alignof(T) - address;
      char* begin = static_cast<char*>(moved);
      if (kExtra != 0 && data_ != nullptr && aligned != shift) {
        std::memmove(begin + aligned, begin + shift, size_ * sizeof(T));
      }
      data_ = reinterpret_cast<T*>(begin + (kExtra != 0 ? aligned : 0));
    }
    capacity_ = capacity;
  }

  void* block_ = nullptr;  // as realloc gave it
  T* data_ = nullptr;
  size_t size_ = 0;
  size_t capacity_ = 0;
};

}  // namespace rayshade
