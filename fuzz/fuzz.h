#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/base/text.h"

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

/// What is said of a file goes to a terminal: one line that a reader takes in, in which nothing of the file acts there.
/// Anything else ends the program, which libFuzzer reports as a finding.
inline void checkLine(const std::string& line) {
  constexpr std::size_t kLongest = 1000;
  if (line.size() <= kLongest && printable(line) == line) return;
  std::fprintf(stderr, "too long, or with controls: %s\n", line.c_str());
  std::abort();
}

/// What every decoder owes its caller for bytes that it refuses: such a line, which begins with the name of the file
/// where one was opened.
template <typename Value>
void checkError(const Result<Value>& result, std::string_view name = {}) {
  if (result) return;
  const std::string& message = result.error().message;
  checkLine(message);
  if (message.size() > name.size() && message.starts_with(name)) return;
  std::fprintf(stderr, "without the file's name: %s\n", message.c_str());
  std::abort();
}

}  // namespace mirrorball::fuzz
