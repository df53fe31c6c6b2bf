#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <tiffio.h>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// libtiff's view of a file in memory. What libtiff says stays here; it prints nothing.
class TiffFile {
 public:
  /// The bytes must outlive it.
  explicit TiffFile(std::span<const std::uint8_t> bytes);
  ~TiffFile();
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;

  /// Nothing where the bytes are no TIFF or its first directory is damaged.
  TIFF* get() const { return tiff_; }
  std::size_t size() const { return bytes_.size(); }
  std::span<const std::uint8_t> bytes() const { return bytes_; }

  /// How often libtiff has warned of something that it went on with.
  int warnings() const { return warnings_; }

  /// The error for a directory that the file ends before, or else for what libtiff first complained of or last warned
  /// of.
  tl::unexpected<Error> damaged() const;

 private:
  static int onError(TIFF* tiff, void* user, const char* module, const char* format, va_list arguments);
  static int onWarning(TIFF* tiff, void* user, const char* module, const char* format, va_list arguments);
  static tmsize_t read(thandle_t self, void* to, tmsize_t count);
  static toff_t seek(thandle_t self, toff_t offset, int from);
  static int map(thandle_t self, void** begin, toff_t* size);

  std::span<const std::uint8_t> bytes_;
  toff_t at_ = 0;
  // Without std::string: no exception may pass through libtiff's frames.
  char error_[160] = "";
  char warning_[160] = "";
  int warnings_ = 0;
  TIFF* tiff_ = nullptr;
};

}  // namespace mirrorball
