#include "cli/standard_streams.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/interruption.h"
#include "cli/terminal.h"
#include "mirrorball/base/descriptor.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/unnamed_output.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::cli {
namespace {

/// Of what is shorter, the whole is asked what it is.
constexpr std::size_t kTellingBytes = 1024;
constexpr std::size_t kPieceBytes = std::size_t{1} << 16;
constexpr const char* kInputName = "standard input";
constexpr const char* kOutputName = "standard output";

tl::unexpected<Error> failed(const char* name, const char* what) {
  return fail(ErrorCode::io, std::string(name) + ": " + what + ": " + std::strerror(errno));
}

/// Refuses what will be no input, however much of it is still to come.
///
/// begin    its first bytes, and there are more
/// errors   bad_file
Result<void> checkBegin(std::span<const std::uint8_t> begin) {
  if (isImage(begin) || isModel(begin)) return {};
  return fail(
      ErrorCode::bad_file,
      "does not begin as an image, or as a model that is read without its name (binary glTF, PLY); give its file");
}

/// Copies all that there is to read.
///
/// check    of the first bytes of what is longer than kTellingBytes
/// errors   io; too_large: more than `max` bytes; interrupted; as check's
Result<void> copyAll(int from, int to, const char* name, std::uint64_t max,
                     Result<void> (*check)(std::span<const std::uint8_t>) = nullptr) {
  std::array<std::uint8_t, kPieceBytes> piece;
  std::uint64_t copied = 0;
  std::vector<std::uint8_t> begin;
  while (true) {
    // A signal ends the waiting, but not a read.
    pollfd input{.fd = from, .events = POLLIN, .revents = 0};
    const bool is_ready = ::poll(&input, 1, -1) > 0;
    if (interrupted()) return fail(ErrorCode::interrupted, "interrupted; nothing was written");
    if (!is_ready) continue;
    const ssize_t count = ::read(from, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failed(name, "reading failed");
    if (count == 0) return {};
    const auto bytes = std::span(piece).first(static_cast<std::size_t>(count));
    copied += bytes.size();
    if (check != nullptr) {
      begin.insert(begin.end(), bytes.begin(), bytes.end());
      if (begin.size() >= kTellingBytes) MIRRORBALL_TRY_VOID(withName(name, std::exchange(check, nullptr)(begin)));
    }
    if (copied > max) return withName(name, checkMemory(copied));
    MIRRORBALL_TRY_VOID(withName(name, writeOn(to, bytes)));
  }
}

/// Makes a regular file of what is piped in, which then is standard input.
Result<void> keepInMemory() {
  struct stat status {};
  if (::fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode)) return {};
  const Descriptor memory(::memfd_create("standard input", MFD_CLOEXEC));
  if (memory.number() < 0) return failed(kInputName, "cannot be kept");
  MIRRORBALL_TRY_VOID(copyAll(STDIN_FILENO, memory.number(), kInputName, memoryLimit(), checkBegin));
  if (::dup2(memory.number(), STDIN_FILENO) < 0) return failed(kInputName, "cannot be kept");
  return {};
}

}  // namespace

Result<void> readStandardInput(const std::vector<std::string*>& inputs) {
  const auto asked = std::ranges::count_if(inputs, [](const std::string* input) { return *input == "-"; });
  if (asked == 0) return {};
  if (asked > 1)
    return fail(ErrorCode::usage, "- is given " + std::to_string(asked) +
                                      " times, and standard input is one file; name a file for the other");
  if (::isatty(STDIN_FILENO) == 1)
    return fail(ErrorCode::usage,
                "- reads standard input, and nothing is piped into it; name a file, or write "
                "mirrorball … - <FILE");
  MIRRORBALL_TRY_VOID(keepInMemory());
  constexpr const char* kPath = "/dev/stdin";
  for (std::string* input : inputs)
    if (*input == "-") *input = kPath;
  showAs(kPath, kInputName);
  showAs(std::string(" ") + kPath + "`", " -`");  // in a command to be typed
  return {};
}

Result<void> writeStandardOutput(std::string& output, const std::function<Result<void>()>& work) {
  if (output == "-")
    return fail(ErrorCode::usage, "--output - tells no format; write its extension behind it, as in -o -.exr");
  if (!output.starts_with("-.")) return work();
  if (::isatty(STDOUT_FILENO) == 1)
    return fail(ErrorCode::usage, "--output " + output +
                                      " writes to standard output, and that is a terminal; redirect "
                                      "it, or name a file");
  // No such file can be there, but a folder, which is looked for before long work.
  const std::string path = "/dev/fd/1" + output.substr(1);
  const UnnamedOutput written(path);
  showAs(path, kOutputName);
  // Where no such file can be made, that is known before the work and not after it.
  if (auto trial = FileWriter::create(path); !trial) return fail(std::move(trial));
  keepStandardOutputFree();
  output = path;
  MIRRORBALL_TRY_VOID(work());
  if (!written.file().isOpen()) return fail(ErrorCode::io, std::string(kOutputName) + ": was not made");
  if (::lseek(written.file().number(), 0, SEEK_SET) < 0) return failed(kOutputName, "cannot be read again");
  return copyAll(written.file().number(), STDOUT_FILENO, kOutputName, UINT64_MAX);
}

Result<void> withStandardStreams(const std::vector<std::string*>& inputs, std::string& output,
                                 const std::function<Result<void>()>& work) {
  MIRRORBALL_TRY_VOID(readStandardInput(inputs));
  return writeStandardOutput(output, work);
}

std::vector<std::string*> pointersTo(std::vector<std::string>& inputs) {
  std::vector<std::string*> pointers;
  for (std::string& input : inputs) pointers.push_back(&input);
  return pointers;
}

}  // namespace mirrorball::cli
