#include "cli/standard_streams.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
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
#include "mirrorball/base/memory.h"
#include "mirrorball/base/unfinished.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::cli {
namespace {

namespace fs = std::filesystem;

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

/// A folder for the time of its owner's life.
Result<UnfinishedPath> makeTemporaryFolder() {
  std::error_code status;
  std::string path = (fs::temp_directory_path(status) / "mirrorball_XXXXXX").string();
  if (status || ::mkdtemp(path.data()) == nullptr) return failed(kOutputName, "no temporary folder can be made");
  return UnfinishedPath(std::move(path));
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
  MIRRORBALL_TRY(folder, makeTemporaryFolder());
  const std::string path = folder.path() + "/output" + output.substr(1);
  showAs(path, kOutputName);
  keepStandardOutputFree();
  output = path;
  MIRRORBALL_TRY_VOID(work());
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) return failed(kOutputName, "was not made");
  // Whatever ends the program while somebody reads, nothing stays.
  folder.remove();
  return copyAll(file.number(), STDOUT_FILENO, kOutputName, UINT64_MAX);
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
