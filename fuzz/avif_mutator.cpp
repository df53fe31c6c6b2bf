// How libFuzzer changes an AVIF: most inputs are a picture that libavif wrote, changed within its boxes
// (avif_mutation.h), or one of its own, changed so; the others are its own changes.

#include <algorithm>

#include "avif_mutation.h"
#include "fuzz.h"

/// libFuzzer's own changes.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed) {
  using namespace mirrorball::fuzz;
  std::mt19937 random(seed);
  const unsigned way = random() % 16;
  if (way == 0) return LLVMFuzzerMutate(data, size, max);
  const mirrorball::Bytes file = way < 11 ? mutatedAvif(static_cast<std::uint32_t>(random()), seed)
                                          : changedAvif(mirrorball::Bytes(data, data + size), random);
  if (file.size() > max) return LLVMFuzzerMutate(data, size, max);
  std::ranges::copy(file, data);
  return file.size();
}
