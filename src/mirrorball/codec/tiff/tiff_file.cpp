#include "mirrorball/codec/tiff/tiff_file.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

/// Unsigned numbers of a TIFF, in its byte order and of the width of its offsets.
class TiffNumbers {
 public:
  explicit TiffNumbers(std::span<const std::uint8_t> bytes)
      : bytes_(bytes), is_big_endian_(bytes[0] == 'M'), is_big_tiff_(number(2, 2) == 43) {}

  bool isBigTiff() const { return is_big_tiff_; }
  std::uint64_t size() const { return bytes_.size(); }

  /// count   of bytes, that the file has
  std::uint64_t number(std::uint64_t at, int count) const {
    std::uint64_t value = 0;
    for (int i = 0; i < count; ++i)
      value = value << 8 | bytes_[std::size_t(at) + std::size_t(is_big_endian_ ? i : count - 1 - i)];
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool is_big_endian_;
  bool is_big_tiff_;
};

constexpr std::uint64_t kBeyond = std::numeric_limits<std::uint64_t>::max();

/// Where the values of one entry of a directory end that do not fit into it; 0 where they do.
///
/// from   TIFF 6.0, section 2: Field Types; BigTIFF's are twice as wide
std::uint64_t valuesEnd(const TiffNumbers& file, std::uint64_t entry) {
  constexpr std::array<std::uint64_t, 19> kBytes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
  const int wide = file.isBigTiff() ? 8 : 4;
  const std::uint64_t type = file.number(entry + 2, 2), count = file.number(entry + 4, wide);
  const std::uint64_t bytes = type < kBytes.size() ? kBytes[type] : 0;
  if (bytes == 0 || count <= std::uint64_t(wide) / bytes) return 0;
  const std::uint64_t begin = file.number(entry + 4 + std::uint64_t(wide), wide);
  return count > (kBeyond - begin) / bytes ? kBeyond : begin + count * bytes;
}

/// Where the first directory ends with all its values; beyond all numbers where the file does not have all its entries.
std::uint64_t directoryEnd(const TiffNumbers& file, std::uint64_t begin) {
  const int count_size = file.isBigTiff() ? 8 : 2;
  const std::uint64_t entry_size = file.isBigTiff() ? 20 : 12;
  if (begin > file.size() || file.size() - begin < std::uint64_t(count_size)) return kBeyond;
  const std::uint64_t entries = begin + std::uint64_t(count_size);
  const std::uint64_t count = file.number(begin, count_size);
  if (count > (file.size() - entries) / entry_size) return kBeyond;
  std::uint64_t end = entries + count * entry_size;
  for (std::uint64_t i = 0; i < count; ++i) end = std::max(end, valuesEnd(file, entries + i * entry_size));
  return end;
}

/// What is wrong with a file that ends before its directory does, which libtiff writes last; empty: it does not.
std::string missingDirectory(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLargestHeader = 16;
  if (bytes.size() < kLargestHeader) return {};
  const TiffNumbers file(bytes);
  const std::uint64_t begin = file.isBigTiff() ? file.number(8, 8) : file.number(4, 4);
  const std::string use = ", which says how large it is and where its rows are";
  if (begin == 0) return "has no directory" + use + ": its program has not written it to its end; save it again";
  if (directoryEnd(file, begin) <= file.size()) return {};
  return "ends at byte " + std::to_string(file.size()) + (begin < file.size() ? ", within" : ", before") +
         " its directory at byte " + std::to_string(begin) + use + "; copy or save it again";
}

}  // namespace

TiffFile::TiffFile(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  if (!options) return;
  TIFFOpenOptionsSetErrorHandlerExtR(options, onError, this);
  TIFFOpenOptionsSetWarningHandlerExtR(options, onWarning, this);
  constexpr auto kMax = static_cast<std::uint64_t>(std::numeric_limits<tmsize_t>::max());
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, static_cast<tmsize_t>(std::min(memoryLimit(), kMax)));
  const auto write = [](thandle_t, void*, tmsize_t) { return tmsize_t{-1}; };
  const auto close = [](thandle_t) { return 0; };
  const auto size = [](thandle_t self) { return toff_t{static_cast<TiffFile*>(self)->bytes_.size()}; };
  const auto unmap = [](thandle_t, void*, toff_t) {};
  tiff_ = TIFFClientOpenExt("TIFF", "r", this, read, write, seek, close, size, map, unmap, options);
  TIFFOpenOptionsFree(options);
}

TiffFile::~TiffFile() {
  if (tiff_) TIFFClose(tiff_);
}

tl::unexpected<Error> TiffFile::damaged() const {
  if (const std::string missing = missingDirectory(bytes_); !missing.empty()) return fail(ErrorCode::bad_file, missing);
  constexpr std::size_t kLongestReason = 200;
  const std::string what = excerpt(error_[0] != '\0' ? error_ : warning_, kLongestReason);
  return fail(ErrorCode::bad_file, "is a damaged or truncated TIFF" + (what.empty() ? "" : ": " + what));
}

/// returns  that libtiff's own handler, which prints, is not to be called as well
int TiffFile::onError(TIFF*, void* user, const char*, const char* format, va_list arguments) {
  auto* file = static_cast<TiffFile*>(user);
  if (file->error_[0] == '\0') std::vsnprintf(file->error_, sizeof file->error_, format, arguments);
  return 1;
}

int TiffFile::onWarning(TIFF*, void* user, const char*, const char* format, va_list arguments) {
  auto* file = static_cast<TiffFile*>(user);
  std::vsnprintf(file->warning_, sizeof file->warning_, format, arguments);
  ++file->warnings_;
  return 1;
}

tmsize_t TiffFile::read(thandle_t self, void* to, tmsize_t count) {
  auto* file = static_cast<TiffFile*>(self);
  const toff_t size = file->bytes_.size();
  const toff_t read = std::min<toff_t>(static_cast<toff_t>(count), size - std::min(file->at_, size));
  if (read > 0) std::memcpy(to, file->bytes_.data() + file->at_, read);
  file->at_ += read;
  return static_cast<tmsize_t>(read);
}

toff_t TiffFile::seek(thandle_t self, toff_t offset, int from) {
  auto* file = static_cast<TiffFile*>(self);
  const toff_t begin = from == SEEK_CUR ? file->at_ : from == SEEK_END ? file->bytes_.size() : 0;
  file->at_ = begin + offset;
  return file->at_;
}

/// libtiff reads what is mapped where it stands, and changes none of it.
int TiffFile::map(thandle_t self, void** begin, toff_t* size) {
  const auto* file = static_cast<TiffFile*>(self);
  *begin = const_cast<std::uint8_t*>(file->bytes_.data());
  *size = file->bytes_.size();
  return 1;
}

}  // namespace mirrorball
