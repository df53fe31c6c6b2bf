#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

/// What a file of the cache holds. Each has its own ending of the name (cache_folder.cpp).
enum class CachedKind {
  prefiltered_chain,  ///< render/light/prefilter_cache.h
  irradiance,         ///< likewise
  occlusion,          ///< rays/occlusion_cache.h
};

/// What was written into a file of the cache, found to be whole.
struct CachedContent {
  FileReader file;
  std::uint64_t size = 0;  ///< of the content, which begins the file [bytes]; the file's seal follows
};

/// A folder of files that are slow to make, found by keys: the digits of a ContentHash of all that they are made from.
/// It is only a convenience: what cannot be read or written is made again. Each file ends with a seal, which holds its
/// kind, its key and a checksum of its content: what is damaged, cut or under another's name is not found.
///
/// The names of its files are predictable, so that a folder is only used if it is the user's own and nobody else may
/// write there; a new one gets the mode 0700. No link in it is followed.
class CacheFolder {
 public:
  static constexpr std::uintmax_t kMaxBytes = std::uintmax_t{1} << 30;

  /// folder    made when something is first written
  /// max_bytes of all kinds together; 0: nothing is kept
  explicit CacheFolder(std::filesystem::path folder, std::uintmax_t max_bytes = kMaxBytes)
      : folder_(std::move(folder)), max_bytes_(max_bytes) {}

  /// The user's own: $MIRRORBALL_CACHE, $XDG_CACHE_HOME/mirrorball or ~/.cache/mirrorball; nothing if the first is
  /// empty or none is set. $MIRRORBALL_CACHE_SIZE, as in 500M or 2G, says how large it may grow, else it is kMaxBytes.
  ///
  /// errors   usage: not a size
  static Result<std::optional<CacheFolder>> ofUser();

  const std::filesystem::path& folder() const { return folder_; }

  /// errors   io: the folder is another user's, or others may write there, so that nothing is kept or found; says what
  ///          to do
  Result<void> check() const;

  std::uintmax_t maxBytes() const { return max_bytes_; }

  /// The contents of the folder.
  struct Contents {
    std::size_t files = 0;
    std::uintmax_t bytes = 0;
  };
  Contents contents() const;

  /// Removes all cached files, and no other file in the folder.
  ///
  /// returns  what was removed
  /// errors   io: a file cannot be removed
  Result<Contents> clear() const;

  /// What was kept, now the most recently used.
  ///
  /// read     of a CachedContent; returns an optional value, or something else that is false where it is of no use
  /// returns  what `read` does; its default where there is no file, or a damaged one
  /// cost     one pass over the file for its checksum, at some GB/s, besides `read`
  template <typename Read>
  auto find(const std::string& key, CachedKind kind, Read&& read) const {
    const std::optional<CachedContent> content = open(key, kind);
    if (!content) return decltype(read(*content)){};
    auto found = read(*content);
    std::error_code status;
    if (found)
      std::filesystem::last_write_time(pathOf(key, kind), std::filesystem::file_time_type::clock::now(), status);
    return found;
  }

  /// Keeps a file, and removes the least recently used files while the cache takes more than maxBytes().
  ///
  /// write    writes the content, which ends with the last byte that it has written
  void keep(const std::string& key, CachedKind kind, const std::function<Result<void>(const FileWriter&)>& write) const;

 private:
  struct Kept {
    std::filesystem::file_time_type used;
    std::filesystem::path path;
    std::uintmax_t bytes;
  };
  std::filesystem::path pathOf(const std::string& key, CachedKind kind) const;
  std::optional<CachedContent> open(const std::string& key, CachedKind kind) const;
  bool make() const;
  std::vector<Kept> kept() const;
  void dropOldest() const;

  std::filesystem::path folder_;
  std::uintmax_t max_bytes_;
};

}  // namespace mirrorball
