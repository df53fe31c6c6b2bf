// How libFuzzer makes models to be shown: most are made of a seed (model_mutation.h), which get past the readers; the
// others are its own changes of those that it has.

#include <algorithm>

#include "fuzz.h"
#include "model_mutation.h"

/// libFuzzer's own changes.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed) {
  constexpr unsigned kModels = 256;
  if (seed / kModels % 8 == 0) return LLVMFuzzerMutate(data, size, max);
  const mirrorball::Bytes model = mirrorball::fuzz::mutatedModel(seed % kModels, seed / kModels);
  if (model.size() > max) return LLVMFuzzerMutate(data, size, max);
  std::copy(model.begin(), model.end(), data);
  return model.size();
}
