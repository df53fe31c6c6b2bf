#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace mirrorball {

/// Memory for texels. Large pieces ask the system for large pages: mapping 100 MB in pages of 4 KiB takes longer than
/// filling it.
///
/// errors   std::bad_alloc
void* allocateTexels(std::size_t bytes);
void freeTexels(void* memory, std::size_t bytes);

/// An allocator that leaves texels uninitialised if no value is given, so that the code that fills them, on all cores,
/// is the first to touch them.
template <typename Sample>
struct TexelAllocator {
  using value_type = Sample;

  TexelAllocator() = default;
  template <typename Other>
  explicit TexelAllocator(const TexelAllocator<Other>&) {}

  Sample* allocate(std::size_t count) { return static_cast<Sample*>(allocateTexels(count * sizeof(Sample))); }
  void deallocate(Sample* memory, std::size_t count) { freeTexels(memory, count * sizeof(Sample)); }

  template <typename Value>
  void construct(Value* place) {
    ::new (static_cast<void*>(place)) Value;
  }
  template <typename Value, typename... Arguments>
  void construct(Value* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(TexelAllocator, TexelAllocator) { return true; }
};

}  // namespace mirrorball
