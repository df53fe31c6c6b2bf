#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"

/// `MIRRORBALL_HARNESS(png) { … return 0; }` is what a fuzzer calls once an input, `data` and `size`. The replay of the
/// corpora has all harnesses in one program, each under its decoder's name.
#ifdef MIRRORBALL_REPLAY
#define MIRRORBALL_HARNESS(decoder)                                                                                 \
  static int decoder##Input(const std::uint8_t* data, std::size_t size);                                            \
  [[maybe_unused]] static const bool decoder##_is_known = ::mirrorball::fuzz::addHarness(#decoder, decoder##Input); \
  static int decoder##Input(const std::uint8_t* data, std::size_t size)
#else
#define MIRRORBALL_HARNESS(decoder) extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
#endif

namespace mirrorball::fuzz {

/// Of the replay: returns true.
bool addHarness(const char* decoder, int (*harness)(const std::uint8_t* data, std::size_t size));

/// What every decoder owes its caller for bytes that it refuses: one line, which begins with the name of the file where
/// one was opened. Anything else ends the program, which libFuzzer reports as a finding.
template <typename Value>
void checkError(const Result<Value>& result, std::string_view name = {}) {
  if (result) return;
  const std::string& message = result.error().message;
  if (message.size() > name.size() && message.starts_with(name) && message.find('\n') == std::string::npos) return;
  std::fprintf(stderr, "not one line, or without the file's name: %s\n", message.c_str());
  std::abort();
}

}  // namespace mirrorball::fuzz
