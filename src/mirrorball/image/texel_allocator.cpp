#include "mirrorball/image/texel_allocator.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace mirrorball {
namespace {

constexpr std::size_t kLargePage = std::size_t(2) << 20;
/// Pieces below this gain nothing from large pages.
constexpr std::size_t kLargePiece = 2 * kLargePage;

std::align_val_t alignmentOf(std::size_t bytes) { return std::align_val_t(bytes < kLargePiece ? 64 : kLargePage); }

}  // namespace

void* allocateTexels(std::size_t bytes) {
  void* memory = ::operator new(bytes, alignmentOf(bytes));
#ifdef MADV_HUGEPAGE
  // A wish: where the system has no large pages, all goes on as without.
  if (bytes >= kLargePiece) ::madvise(memory, bytes, MADV_HUGEPAGE);
#endif
  return memory;
}

// The operator that also takes the size is not there in clang before 19 by default.
void freeTexels(void* memory, std::size_t bytes) { ::operator delete(memory, alignmentOf(bytes)); }

}  // namespace mirrorball
