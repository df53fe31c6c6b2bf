// How libFuzzer changes an AVIF: within its boxes (avif_mutation.h).

#include "avif_mutation.h"
#include "fuzz.h"
#include "input_mutator.h"

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed) {
  return mirrorball::fuzz::mutateInput(mirrorball::fuzz::kAvifMutation, data, size, max, seed);
}
