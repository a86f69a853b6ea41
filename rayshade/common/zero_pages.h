// An allocator for large arrays that begin as zeros and are written soon: it takes pages from the
// operating system, which are zeros already, and fetches them at once: whoever writes does not wait
// for them. Not large pages: a virtual machine may take half a millisecond and more for each.
//
//   1. New elements are zero bytes without being written: T{} must be that, and an array must not
//      be made smaller and larger again.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace rayshade {

template <typename T>
struct ZeroPages {
  static_assert(std::is_trivially_copyable_v<T>);
  using value_type = T;

  ZeroPages() = default;
  template <typename U>
  ZeroPages(const ZeroPages<U>&) {}

  T* allocate(std::size_t count) {
    void* const pages = mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED) throw std::bad_alloc();
#ifdef MADV_POPULATE_WRITE
    madvise(pages, count * sizeof(T), MADV_POPULATE_WRITE);  // no more than advice
#endif
    return static_cast<T*>(pages);
  }
  void deallocate(T* pages, std::size_t count) { munmap(pages, count * sizeof(T)); }

  void construct(T*) {}
  template <typename... Args>
  void construct(T* place, Args&&... args) {
    ::new (place) T(std::forward<Args>(args)...);
  }

  template <typename U>
  bool operator==(const ZeroPages<U>&) const {
    return true;
  }
};

}  // namespace rayshade
