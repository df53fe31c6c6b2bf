#include "mirrorball/base/file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <unistd.h>

namespace mirrorball {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

std::string reason() { return std::strerror(errno); }

}  // namespace

Result<Bytes> readFile(const std::filesystem::path& path, std::uintmax_t largest) {
  const std::string name = path.string();
  std::error_code status;
  if (!std::filesystem::exists(path, status))
    return fail(ErrorCode::not_found, name + ": no such file; check the path");
  if (std::filesystem::is_directory(path, status))
    return fail(ErrorCode::io, name + ": is a folder; name a file in it");

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
}

Result<Bytes> readRegularFile(const std::filesystem::path& path) {
  std::error_code status;
  if (std::filesystem::exists(path, status) && !std::filesystem::is_regular_file(path, status))
    return fail(ErrorCode::io, path.string() + ": is no regular file");
  return readFile(path);
}

Result<void> writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  const std::string name = path.string();
  const std::string temporary = name + ".part" + std::to_string(::getpid());
  FileHandle file(std::fopen(temporary.c_str(), "wb"));
  if (!file)
    return fail(ErrorCode::io,
                name + ": cannot be written: " + reason() + "; check that the folder exists and is writable");
  const bool written = bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  const bool closed = std::fclose(file.release()) == 0;
  if (written && closed && std::rename(temporary.c_str(), name.c_str()) == 0) return {};

  const std::string why = reason();
  std::remove(temporary.c_str());
  return fail(ErrorCode::io, name + ": cannot be written: " + why);
}

std::string extensionOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

}  // namespace mirrorball
