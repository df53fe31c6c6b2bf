#include "mirrorball/codec/exr_stream.h"

#include <cstring>

#include <Iex.h>

namespace mirrorball {

bool ExrInput::read(char to[], int count) {
  if (count < 0 || at_ > bytes_.size() || static_cast<std::uint64_t>(count) > bytes_.size() - at_)
    throw Iex::InputExc("the file ends early, at byte " + std::to_string(bytes_.size()));
  std::memcpy(to, bytes_.data() + at_, static_cast<std::size_t>(count));
  at_ += static_cast<std::uint64_t>(count);
  return at_ < bytes_.size();
}

void ExrOutput::write(const char from[], int count) {
  const std::size_t size = static_cast<std::size_t>(count);
  if (at_ + size > bytes_.size()) bytes_.resize(at_ + size);
  std::memcpy(bytes_.data() + at_, from, size);
  at_ += size;
}

}  // namespace mirrorball
