#include "mirrorball/base/file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mirrorball {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

tl::unexpected<Error> cannotBeWritten(int error_number) {
  return fail(ErrorCode::io, std::string("cannot be written: ") + std::strerror(error_number));
}

std::string reason() { return std::strerror(errno); }

Result<void> checkReadable(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::exists(path, status))
    return fail(ErrorCode::not_found, path.string() + ": no such file; check the path");
  if (std::filesystem::is_directory(path, status))
    return fail(ErrorCode::io, path.string() + ": is a folder; name a file in it");
  return {};
}

Result<void> checkRegular(const std::filesystem::path& path) {
  std::error_code status;
  if (std::filesystem::exists(path, status) && !std::filesystem::is_regular_file(path, status))
    return fail(ErrorCode::io, path.string() + ": is no regular file");
  return {};
}

/// Reads up to the file's end at most.
Result<std::size_t> readFrom(int descriptor, std::uint64_t offset, std::span<std::uint8_t> bytes) {
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t count =
        ::pread(descriptor, bytes.data() + filled, bytes.size() - filled, static_cast<off_t>(offset + filled));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return fail(ErrorCode::io, "reading failed: " + reason());
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  return filled;
}

}  // namespace

Result<Bytes> readFile(const std::filesystem::path& path, std::uintmax_t largest) try {
  const std::string name = path.string();
  MIRRORBALL_TRY_VOID(checkReadable(path));
  std::error_code status;
  FileHandle file(std::fopen(name.c_str(), "rb"));
  if (!file) return fail(ErrorCode::io, name + ": cannot be opened: " + reason());
  const std::uintmax_t size = std::filesystem::file_size(path, status);
  if (!status && size > largest)
    return fail(ErrorCode::too_large,
                name + ": has " + std::to_string(size) + " bytes; at most " + std::to_string(largest) + " are read");

  // A pipe or a device tells no size: then the file is read in pieces until it ends.
  // One byte more than a file has tells its end without growing the memory.
  Bytes bytes(status ? 0 : static_cast<std::size_t>(size) + 1);
  std::size_t filled = 0;
  while (true) {
    if (filled == bytes.size()) bytes.resize(filled + (std::size_t{1} << 16));
    const std::size_t count = std::fread(bytes.data() + filled, 1, bytes.size() - filled, file.get());
    filled += count;
    if (filled > largest) return fail(ErrorCode::too_large, name + ": is larger than can be read");
    if (count == 0) break;
  }
  if (std::ferror(file.get())) return fail(ErrorCode::io, name + ": reading failed: " + reason());
  bytes.resize(filled);
  return bytes;
} catch (const std::bad_alloc&) {
  return fail(ErrorCode::too_large, path.string() + ": not enough memory to read it");
}

Result<Bytes> readRegularFile(const std::filesystem::path& path) {
  MIRRORBALL_TRY_VOID(checkRegular(path));
  return readFile(path);
}

Result<FileReader> FileReader::open(const std::filesystem::path& path) {
  const std::string name = path.string();
  MIRRORBALL_TRY_VOID(checkReadable(path));
  MIRRORBALL_TRY_VOID(checkRegular(path));
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return fail(ErrorCode::io, name + ": cannot be opened: " + reason());
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) {
    const std::string why = reason();
    ::close(descriptor);
    return fail(ErrorCode::io, name + ": cannot be opened: " + why);
  }
  return FileReader(name, descriptor, static_cast<std::uint64_t>(status.st_size));
}

FileReader::FileReader(FileReader&& other) noexcept
    : name_(std::move(other.name_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

FileReader::~FileReader() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<std::size_t> FileReader::readAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
  return readFrom(descriptor_, offset, bytes);
}

FileWriter::FileWriter(std::string name, UnfinishedPath temporary, int descriptor)
    : name_(std::move(name)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : name_(std::move(other.name_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

FileWriter::~FileWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<FileWriter> FileWriter::create(const std::filesystem::path& path) {
  const std::string name = path.string();
  UnfinishedPath temporary(name + ".part" + std::to_string(::getpid()));
  constexpr mode_t kReadAndWrite = 0666;  // less what the user's umask takes away
  const int descriptor = ::open(temporary.path().c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, kReadAndWrite);
  if (descriptor < 0)
    return fail(ErrorCode::io,
                name + ": cannot be written: " + reason() + "; check that the folder exists and is writable");
  return FileWriter(name, std::move(temporary), descriptor);
}

Result<void> FileWriter::writeAt(std::uint64_t offset, std::span<const std::uint8_t> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return cannotBeWritten(count < 0 ? errno : ENOSPC);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
  return {};
}

Result<std::size_t> FileWriter::readAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
  return readFrom(descriptor_, offset, bytes);
}

Result<std::uint64_t> FileWriter::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) return fail(ErrorCode::io, "its size is not known: " + reason());
  return static_cast<std::uint64_t>(status.st_size);
}

Result<void> FileWriter::commit() {
  const bool is_on_disk = ::fsync(descriptor_) == 0;
  const int why = errno;
  if (::close(std::exchange(descriptor_, -1)) == 0 && is_on_disk && temporary_.finishAs(name_)) return {};
  return cannotBeWritten(is_on_disk ? errno : why);
}

Result<void> writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  MIRRORBALL_TRY(writer, FileWriter::create(path));
  MIRRORBALL_TRY_VOID(withName(path.string(), writer.writeAt(0, bytes)));
  return withName(path.string(), writer.commit());
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
