#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "mirrorball/base/descriptor.h"
#include "mirrorball/base/part_file.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

using Bytes = std::vector<std::uint8_t>;

/// Values as their bytes lie in memory.
template <typename Value>
std::span<const std::uint8_t> bytesOf(std::span<const Value> values) {
  static_assert(std::is_trivially_copyable_v<Value>);
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()};
}

/// Reads a whole file; the size of one of more than 64 MB is first compared with memoryLimit().
///
/// errors   not_found; io (a folder, no permission; a pipe or a device, which may never end); too_large (above
///          `largest`, or more than the memory that may be used)
Result<Bytes> readFile(const std::filesystem::path& path, std::uintmax_t largest = std::uintmax_t{1} << 34);

/// What becomes of a symbolic link where a file is expected.
enum class Links {
  follow,
  refuse,  ///< it is not read, and replaced where a file is written
};

/// A file whose bytes are read where and when they are needed.
class FileReader {
 public:
  /// errors   not_found; io (a folder, no permission; a pipe or a device, which tell no size; a link that is refused)
  static Result<FileReader> open(const std::filesystem::path& path, Links links = Links::follow);

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }

  /// Reads bytes from a place counted from the file's beginning.
  ///
  /// returns  how many were read: fewer than `bytes` has room for only at the file's end
  /// errors   io; without the file's name
  Result<std::size_t> readAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const;

 private:
  FileReader(std::string name, Descriptor file, std::uint64_t size)
      : name_(std::move(name)), file_(std::move(file)), size_(size) {}

  std::string name_;
  Descriptor file_;
  std::uint64_t size_ = 0;
};

/// A file that is either wholly there or not at all: written under a temporary name beside its own (PartFile), then
/// renamed. Without commit() the temporary file goes away and what had the name stays.
///
/// Of a symbolic link, what it leads to is replaced, and the link stays. A pipe or a device stays too: its bytes are
/// kept in a file without a name, and commit() writes them into it. Links::refuse replaces all of them.
class FileWriter {
 public:
  /// errors   io (no such folder, no permission; a link or a pipe of another user in a world-writable folder)
  /// cost     that of listing the folder; of a pipe, until somebody reads it
  static Result<FileWriter> create(const std::filesystem::path& path, Links links = Links::follow);

  /// Writes bytes at a place counted from the file's beginning, in any order; what is never written reads as 0.
  /// Several threads may write different places at the same time.
  ///
  /// errors   io (disk full); without the file's name, as commit()'s
  Result<void> writeAt(std::uint64_t offset, std::span<const std::uint8_t> bytes) const;

  /// Reads again what was written; as FileReader::readAt.
  Result<std::size_t> readAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const;

  /// Up to the last byte that was written [bytes].
  ///
  /// errors   io
  Result<std::uint64_t> size() const;

  /// Gives the file its name, after all of it has reached the disk: whatever happens then to the machine, under this
  /// name are the old bytes or the new ones. Nothing can be written any more.
  ///
  /// errors   io (the name is a folder's, disk full)
  Result<void> commit();

  const std::string& name() const { return name_; }

 private:
  FileWriter(std::string name, std::string target, PartFile part);
  Result<void> passOn();

  std::string name_;
  std::string target_;  // what the name leads to
  PartFile part_;
  Descriptor sink_;  // the pipe or device, if it is one
};

/// What a name stands for: of a symbolic link, what it leads to, be it there or not.
///
/// errors   io (links in a circle; a link of another user in a world-writable folder, as /tmp is); without the file's
///          name
Result<std::filesystem::path> withoutLinks(std::filesystem::path path);

/// Writes a whole file with a FileWriter.
///
/// errors   io (no such folder, no permission, disk full); the temporary file is removed
Result<void> writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// The file name extension, lower case, without its dot: "hdr" of "Photo.HDR".
std::string extensionOf(const std::filesystem::path& path);

/// Refuses outputs that would overwrite what is read.
///
/// errors   usage
Result<void> refuseOverwriting(std::span<const std::string> inputs, std::span<const std::string> outputs);

/// "exr", also of ".exr".
std::string withoutDot(const std::string& extension);

/// "turn_007.png" of "turn.png": the name with a suffix before its extension.
std::string suffixed(const std::filesystem::path& path, const std::string& suffix);

}  // namespace mirrorball
