#include "mirrorball/base/file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

#include "mirrorball/base/memory.h"

namespace mirrorball {
namespace {

tl::unexpected<Error> cannotBeOpened(const std::string& name, int number) {
  if (number == ENOENT || number == ENOTDIR) return fail(ErrorCode::not_found, name + ": no such file; check the path");
  return fail(ErrorCode::io, name + ": cannot be opened: " + std::strerror(number));
}

}  // namespace

Result<Bytes> readFile(const std::filesystem::path& path, std::uintmax_t largest) try {
  MIRRORBALL_TRY(file, FileReader::open(path));
  if (file.size() > largest)
    return fail(ErrorCode::too_large, file.name() + ": has " + std::to_string(file.size()) + " bytes; at most " +
                                          std::to_string(largest) + " are read");
  // The limit is meant for images, and what a small one needs is told better by who decodes it.
  constexpr std::uint64_t kSmall = std::uint64_t{1} << 26;
  if (file.size() > kSmall) MIRRORBALL_TRY_VOID(withName(file.name(), checkMemory(file.size())));
  Bytes bytes(static_cast<std::size_t>(file.size()));
  MIRRORBALL_TRY(count, withName(file.name(), file.readAt(0, bytes)));
  bytes.resize(count);
  return bytes;
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::too_large, path.string() + ": not enough memory to read it");
}

Result<FileReader> FileReader::open(const std::filesystem::path& path, Links links) {
  const std::string name = path.string();
  // A pipe that nobody writes into would make us wait, and a terminal become ours.
  const int refusing = links == Links::refuse ? O_NOFOLLOW : 0;
  Descriptor file(::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | refusing));
  if (!file.isOpen()) return cannotBeOpened(name, errno);
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) return cannotBeOpened(name, errno);
  if (S_ISDIR(status.st_mode)) return fail(ErrorCode::io, name + ": is a folder; name a file in it");
  if (!S_ISREG(status.st_mode))
    return fail(ErrorCode::io, name +
                                   ": is no regular file but a pipe or a device, which may never end; copy what it "
                                   "holds into a file");
  return FileReader(name, std::move(file), static_cast<std::uint64_t>(status.st_size));
}

Result<std::size_t> FileReader::readAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
  return mirrorball::readAt(file_, offset, bytes);
}

std::string extensionOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

Result<void> refuseOverwriting(std::span<const std::string> inputs, std::span<const std::string> outputs) {
  std::error_code missing;
  for (const std::string& output : outputs)
    for (const std::string& input : inputs)
      if (std::filesystem::equivalent(input, output, missing))
        return fail(ErrorCode::usage, output + ": is the input itself; give the output another name");
  return {};
}

std::string withoutDot(const std::string& extension) { return extension.substr(extension.starts_with('.') ? 1 : 0); }

std::string suffixed(const std::filesystem::path& path, const std::string& suffix) {
  return (path.parent_path() / (path.stem().string() + suffix + path.extension().string())).string();
}

}  // namespace mirrorball
