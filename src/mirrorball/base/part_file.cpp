#include "mirrorball/base/part_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin = ".mirrorball-";
constexpr std::string_view kEnd = ".part";
constexpr std::size_t kDigits = 16;

/// A name that nobody can foretell, and so nobody can take before.
std::string newName() {
  std::random_device random;
  char digits[kDigits + 1];
  std::snprintf(digits, sizeof digits, "%08x%08x", random(), random());
  return std::string(kBegin) + digits + std::string(kEnd);
}

/// Removes a part that nobody has locked. It is ours while we have the lock, also if its owner is about to ask for it.
void removeIfAbandoned(const fs::path& path) {
  // Who names a pipe so does not make us wait.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  const bool is_ours =
      file.isOpen() && ::fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
  if (is_ours && ::flock(file.number(), LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
}

void removeAbandoned(const fs::path& folder) {
  std::error_code status;
  for (fs::directory_iterator entry(folder, status), end; !status && entry != end; entry.increment(status))
    if (isPartName(entry->path().filename())) removeIfAbandoned(entry->path());
}

/// Locks a part that was made just now.
///
/// returns  whether it has its name still; where there are no locks, nobody takes it away
bool lock(const Descriptor& file) {
  if (::flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  struct stat status {};
  return ::fstat(file.number(), &status) == 0 && status.st_nlink > 0;
}

/// Whether locks exclude others where a part lies that we have locked. Not all file systems have them, and some only
/// say so.
bool locksHold(const PartFile& part) {
  const Descriptor again(::open(part.path.path().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
  return again.isOpen() && ::flock(again.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace

Result<PartFile> makePart(const fs::path& folder) {
  const fs::path place = folder.empty() ? fs::path(".") : folder;
  constexpr int kAttempts = 100;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    PartFile part{.file = {}, .path = UnfinishedPath((place / newName()).string())};
    constexpr int kHow = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    constexpr mode_t kReadAndWrite = 0666;  // less what the user's umask takes away
    part.file = Descriptor(::open(part.path.path().c_str(), kHow, kReadAndWrite));
    const int why = errno;
    if (part.file.isOpen() && lock(part.file)) {
      if (locksHold(part)) removeAbandoned(place);
      return part;
    }
    part.path.keep();  // what has that name, if anything has, is not ours
    if (!part.file.isOpen() && why != EEXIST) return fail(ErrorCode::io, std::strerror(why));
  }
  return fail(ErrorCode::io, std::strerror(EBUSY));
}

Result<PartFile> makeUnnamedPart(const fs::path& folder) {
  constexpr mode_t kOwnerOnly = 0600;
  PartFile part;
  part.file = Descriptor(::open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, kOwnerOnly));
  if (part.file.isOpen()) return part;
  MIRRORBALL_TRY(named, makePart(folder));
  named.path.remove();  // what is open can still be written and read
  return std::move(named);
}

bool isPartName(const fs::path& path) {
  const std::string name = path.string();
  const auto isDigit = [](char letter) { return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f'); };
  return name.size() == kBegin.size() + kDigits + kEnd.size() && name.starts_with(kBegin) && name.ends_with(kEnd) &&
         std::all_of(name.begin() + kBegin.size(), name.end() - kEnd.size(), isDigit);
}

}  // namespace mirrorball
