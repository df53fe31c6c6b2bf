// How libFuzzer changes a JPEG XL: behind its headers (jxl_mutation.h).

#include "fuzz.h"
#include "input_mutator.h"
#include "jxl_mutation.h"

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed) {
  return mirrorball::fuzz::mutateInput(mirrorball::fuzz::kJxlMutation, data, size, max, seed);
}
