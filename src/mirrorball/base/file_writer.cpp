#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/part_file.h"
#include "mirrorball/base/unnamed_output.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// Whether a name is that of a pipe or a device, whose bytes go on to somebody else.
bool passesBytesOn(const fs::path& path) {
  std::error_code status;
  const fs::file_status what = fs::status(path, status);
  return fs::exists(what) && !fs::is_regular_file(what) && !fs::is_directory(what);
}

/// Whether a file, link or pipe of another user has this name in a world-writable folder: nobody else decides where our
/// bytes go. Linux refuses to follow such links where fs.protected_symlinks is set.
bool isFromAnotherUser(const fs::path& path) {
  struct stat own {};
  struct stat folder {};
  const fs::path parent = path.parent_path();
  if (::lstat(path.c_str(), &own) != 0 || ::stat(parent.empty() ? "." : parent.c_str(), &folder) != 0) return false;
  const bool is_world_writable = (folder.st_mode & S_ISVTX) != 0 && (folder.st_mode & S_IWOTH) != 0;
  return is_world_writable && own.st_uid != ::geteuid() && own.st_uid != folder.st_uid;
}

tl::unexpected<Error> createdByAnotherUser() {
  return fail(ErrorCode::io, "another user created it in a world-writable folder; remove it, or use another folder");
}

/// Gives a file the permissions of that which it takes the place of, if there is one.
void takePermissions(const Descriptor& file, const std::string& target) {
  struct stat status {};
  constexpr mode_t kPermissions = 0777;
  if (::stat(target.c_str(), &status) == 0 && S_ISREG(status.st_mode))
    static_cast<void>(::fchmod(file.number(), status.st_mode & kPermissions));  // what cannot be is not
}

/// A file without a name in the temporary folder.
Result<PartFile> makeTemporaryPart() {
  std::error_code status;
  const fs::path folder = fs::temp_directory_path(status);
  auto part = status ? Result<PartFile>(fail(ErrorCode::io, status.message())) : makeUnnamedPart(folder);
  if (part) return part;
  return fail(ErrorCode::io,
              "no temporary file can be made: " + part.error().message + "; let TMPDIR name a folder to write to");
}

/// Whether it has reached the disk; some file systems cannot be asked for that.
bool reachesDisk(const Descriptor& file) {
  return ::fsync(file.number()) == 0 || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP;
}

}  // namespace

Result<fs::path> withoutLinks(fs::path path) {
  constexpr int kMost = 40;  // as Linux follows
  std::error_code status;
  for (int followed = 0; fs::is_symlink(fs::symlink_status(path, status)); ++followed) {
    if (followed == kMost) return cannotBeWritten(ELOOP);
    if (isFromAnotherUser(path)) return createdByAnotherUser();
    const fs::path target = fs::read_symlink(path, status);
    if (status) return cannotBeWritten(status.value());
    path = path.parent_path() / target;  // which is the target, if that begins at the root
  }
  return path;
}

FileWriter::FileWriter(std::string name, std::string target, PartFile part)
    : name_(std::move(name)), target_(std::move(target)), part_(std::move(part)) {}

Result<FileWriter> FileWriter::create(const fs::path& path, Links links) {
  if (UnnamedOutput::find(path.string()) != nullptr) {
    MIRRORBALL_TRY(part, withName(path.string(), makeTemporaryPart()));
    return FileWriter(path.string(), path.string(), std::move(part));
  }
  const bool follows = links == Links::follow;
  const bool passes_on = follows && passesBytesOn(path);
  if (passes_on && isFromAnotherUser(path)) return withName(path.string(), Result<FileWriter>(createdByAnotherUser()));
  MIRRORBALL_TRY(target, passes_on || !follows ? path : withName(path.string(), withoutLinks(path)));
  const auto named = [&](const Error& error) {
    const std::string link = target == path ? "" : "is a link to " + target.string() + ", which ";
    return fail(ErrorCode::io, path.string() + ": " + link + "cannot be written: " + error.message +
                                   "; check that the folder exists and is writable");
  };
  if (!passes_on) {
    auto part = makePart(target.parent_path());
    if (!part) return named(part.error());
    return FileWriter(path.string(), target.string(), std::move(*part));
  }
  MIRRORBALL_TRY(part, withName(path.string(), makeTemporaryPart()));
  FileWriter writer(path.string(), target.string(), std::move(part));
  writer.sink_ = Descriptor(::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
  if (!writer.sink_.isOpen()) return withName(path.string(), Result<FileWriter>(cannotBeWritten(errno)));
  return writer;
}

Result<void> FileWriter::writeAt(std::uint64_t offset, std::span<const std::uint8_t> bytes) const {
  return mirrorball::writeAt(part_.file, offset, bytes);
}

Result<std::size_t> FileWriter::readAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
  return mirrorball::readAt(part_.file, offset, bytes);
}

Result<std::uint64_t> FileWriter::size() const {
  struct stat status {};
  if (::fstat(part_.file.number(), &status) != 0)
    return fail(ErrorCode::io, std::string("its size is not known: ") + std::strerror(errno));
  return static_cast<std::uint64_t>(status.st_size);
}

Result<void> FileWriter::commit() {
  if (sink_.isOpen()) return passOn();
  if (UnnamedOutput* output = UnnamedOutput::find(name_)) {
    output->take(std::move(part_.file));
    return {};
  }
  takePermissions(part_.file, target_);
  if (!reachesDisk(part_.file) || !part_.path.finishAs(target_)) return cannotBeWritten(errno);
  part_.file.close();  // and not before: it is locked so long
  return {};
}

Result<void> FileWriter::passOn() {
  std::array<std::uint8_t, std::size_t{1} << 16u> piece;
  for (std::uint64_t offset = 0;;) {
    MIRRORBALL_TRY(count, readAt(offset, piece));
    if (count == 0) break;
    MIRRORBALL_TRY_VOID(writeOn(sink_.number(), std::span(piece).first(count)));
    offset += count;
  }
  if (!sink_.close()) return cannotBeWritten(errno);
  return {};
}

Result<void> writeFile(const fs::path& path, std::span<const std::uint8_t> bytes) {
  MIRRORBALL_TRY(writer, FileWriter::create(path));
  MIRRORBALL_TRY_VOID(withName(path.string(), writer.writeAt(0, bytes)));
  return withName(path.string(), writer.commit());
}

}  // namespace mirrorball
