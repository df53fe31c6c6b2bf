#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"

/// What a fuzzer and the replay of its corpus call, once an input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace mirrorball::fuzz {

/// What every decoder owes its caller for bytes that it refuses: one line that begins with the file's name. Anything
/// else ends the program, which libFuzzer reports as a finding.
template <typename Value>
void checkError(const Result<Value>& result, std::string_view name) {
  if (result) return;
  const std::string& message = result.error().message;
  if (message.starts_with(name) && message.find('\n') == std::string::npos) return;
  std::fprintf(stderr, "not one line that begins with the file's name: %s\n", message.c_str());
  std::abort();
}

}  // namespace mirrorball::fuzz
