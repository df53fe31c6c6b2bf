#include "mirrorball/codec/tiff/tiff_file.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"

namespace mirrorball {

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
