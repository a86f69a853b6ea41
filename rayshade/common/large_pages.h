// An allocator for large arrays that are touched soon and all over: asks the operating system for
// large pages, so that it does not have to be entered for every four kilobytes. Where it has none,
// memory is as ever.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace rayshade {

template <typename T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <typename U>
  LargePages(const LargePages<U>&) {}

  T* allocate(std::size_t count) {
    constexpr std::size_t kPage = std::size_t{2} << 20;
    const std::size_t bytes = (count * sizeof(T) + kPage - 1) / kPage * kPage;
    void* const block = std::aligned_alloc(kPage, bytes);
    if (block == nullptr) throw std::bad_alloc();
    madvise(block, bytes, MADV_HUGEPAGE);  // no more than advice
    return static_cast<T*>(block);
  }
  void deallocate(T* block, std::size_t) { std::free(block); }

  template <typename U>
  bool operator==(const LargePages<U>&) const {
    return true;
  }
};

}  // namespace rayshade
