#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mirrorball/codec/ldr/jpeg_library.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// What libjpeg warned of while it decoded a file, and which rows of texels it did not have. libjpeg itself goes on
/// with grey, or with what damaged codes happen to mean.
///
/// Rows count as missing from the row of blocks on in which the data ended or were no codes, up to where the decoder
/// starts anew: at the next restart marker after that row's, or else at the end of the scan. Only scans that bring the
/// mean of each block count; without a later scan of a progressive file the rows are coarser, but there.
class JpegDamage {
 public:
  /// Takes the memory for a picture of that many rows; before that, warnings are of the header.
  void expectRows(std::size_t rows) {
    is_missing_.assign(rows, 0);
    end_ = rows;
  }

  /// Takes up the warning that libjpeg's error manager holds, at the place that the decoder has reached. It takes no
  /// memory, for no exception may pass through libjpeg's frames.
  void note(jpeg_decompress_struct& codec);

  /// The rows from `first` on are missing, as libjpeg's error or what follows from it says.
  void endAt(std::size_t first, const char* message);

  /// What the scans have brought once all rows are decoded, and before libjpeg gives back what it knows of them: a
  /// component of which no scan came is missing everywhere. It takes no memory.
  void checkScans(const jpeg_decompress_struct& codec);

  /// From which row on all are missing: there decoding may stop.
  std::size_t end() const { return end_; }
  std::size_t missingRows() const;

  /// Makes missing rows black, and opaque.
  void blacken(Image8& picture) const;

  /// Why rows are missing: "its data end within its first row of blocks" where libjpeg says nothing else.
  std::string cause() const;

  /// What is unusual about the file, in one line; empty: nothing is.
  std::string remark() const;

 private:
  void miss(std::size_t begin, std::size_t end);
  /// The interval of restarts that the decoder is in cannot be decoded from here on.
  void missInterval(const jpeg_decompress_struct& codec);
  std::string remarkOnRows() const;

  std::vector<std::uint8_t> is_missing_;  ///< of each row; bytes, since note() writes them
  std::size_t end_ = 0;
  bool ends_early_ = false;   ///< the bytes end before the end marker
  bool lacks_data_ = false;   ///< a scan ends before its last block
  bool is_coarse_ = false;    ///< what refines the picture is not all there
  int odd_end_of_band_ = -1;  ///< the number in a baseline scan's header that should be 63
  std::size_t stray_bytes_ = 0;
  char message_[JMSG_LENGTH_MAX] = "";  ///< libjpeg's first on anything else
};

}  // namespace mirrorball
