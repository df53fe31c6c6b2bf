#include "mirrorball/base/descriptor.h"

#include <cerrno>
#include <cstring>
#include <string>

#include <unistd.h>

namespace mirrorball {
namespace {

/// Writes all bytes, however few `write` takes at a time.
template <typename Write>
Result<void> writeAll(std::span<const std::uint8_t> bytes, Write&& write) {
  while (!bytes.empty()) {
    const ssize_t count = write(bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return cannotBeWritten(count < 0 ? errno : ENOSPC);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return {};
}

}  // namespace

bool Descriptor::close() { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0; }

Result<std::size_t> readAt(const Descriptor& file, std::uint64_t offset, std::span<std::uint8_t> bytes) {
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t count =
        ::pread(file.number(), bytes.data() + filled, bytes.size() - filled, static_cast<off_t>(offset + filled));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return fail(ErrorCode::io, std::string("reading failed: ") + std::strerror(errno));
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  return filled;
}

Result<void> writeAt(const Descriptor& file, std::uint64_t offset, std::span<const std::uint8_t> bytes) {
  return writeAll(bytes, [&](std::span<const std::uint8_t> left) {
    const std::uint64_t at = offset + (bytes.size() - left.size());
    return ::pwrite(file.number(), left.data(), left.size(), static_cast<off_t>(at));
  });
}

Result<void> writeOn(int to, std::span<const std::uint8_t> bytes) {
  return writeAll(bytes, [to](std::span<const std::uint8_t> left) { return ::write(to, left.data(), left.size()); });
}

tl::unexpected<Error> cannotBeWritten(int number) {
  return fail(ErrorCode::io, std::string("cannot be written: ") + std::strerror(number));
}

}  // namespace mirrorball
