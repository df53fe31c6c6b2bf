#include "mirrorball/codec/exr/exr_stream.h"

#include <algorithm>
#include <cstring>
#include <mutex>

#include <Iex.h>
#include <ImfThreading.h>

#include "mirrorball/base/parallel.h"

namespace mirrorball {

bool ExrInput::read(char to[], int count) {
  if (count < 0 || at_ > bytes_.size() || static_cast<std::uint64_t>(count) > bytes_.size() - at_)
    throw Iex::InputExc("the file ends early, at byte " + std::to_string(bytes_.size()));
  std::memcpy(to, bytes_.data() + at_, static_cast<std::size_t>(count));
  at_ += static_cast<std::uint64_t>(count);
  return at_ < bytes_.size();
}

bool ExrFileInput::read(char to[], int count) {
  const std::size_t wanted = static_cast<std::size_t>(std::max(count, 0));
  const auto got = file_.readAt(at_, {reinterpret_cast<std::uint8_t*>(to), wanted});
  if (!got) throw Iex::InputExc(got.error().message);
  if (*got < wanted) throw Iex::InputExc("the file ends early, at byte " + std::to_string(file_.size()));
  at_ += wanted;
  return at_ < file_.size();
}

void ExrOutput::write(const char from[], int count) {
  const std::size_t size = static_cast<std::size_t>(count);
  if (at_ + size > bytes_.size()) bytes_.resize(at_ + size);
  std::memcpy(bytes_.data() + at_, from, size);
  at_ += size;
}

void useExrThreads() {
  static std::once_flag once;
  std::call_once(once, [] {
    constexpr int kMaxThreads = 16;  // each takes the memory of two chunks
    if (Imf::globalThreadCount() == 0) Imf::setGlobalThreadCount(std::min(threadLimit(), kMaxThreads));
  });
}

}  // namespace mirrorball
