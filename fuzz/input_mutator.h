#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

#include "file_mutation.h"

/// libFuzzer's own changes.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);

namespace mirrorball::fuzz {

/// Changes an input in place, as LLVMFuzzerCustomMutator does: most inputs become a good file with some changes, or the
/// input itself is changed as such a file is; the others are libFuzzer's own changes.
///
/// returns  the new size
inline std::size_t mutateInput(const FileMutation& mutation, std::uint8_t* data, std::size_t size, std::size_t max,
                               unsigned seed) {
  std::mt19937 random(seed);
  const unsigned way = random() % 16;
  if (way == 0) return LLVMFuzzerMutate(data, size, max);
  const Bytes file = way < 11 ? mutatedFile(mutation, static_cast<std::uint32_t>(random()), seed)
                              : mutation.changed(Bytes(data, data + size), random);
  if (file.size() > max) return LLVMFuzzerMutate(data, size, max);
  std::ranges::copy(file, data);
  return file.size();
}

}  // namespace mirrorball::fuzz
