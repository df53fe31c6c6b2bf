#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfMultiPartInputFile.h>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/exr/exr_layer.h"
#include "mirrorball/codec/exr/exr_window.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// The picture of an OpenEXR file: a layer of one of its parts (exr_layer.h), in its display window (exr_window.h).
/// Rows that the file lacks, because it was not written to its end, are black.
class ExrPart {
 public:
  /// Opens a file whose sizes have been checked (checkExrSizes). Errors in its structure throw, as OpenEXR does.
  ///
  /// file_size  in bytes
  /// layer      the name of the layer to read; empty: the picture
  /// errors     unsupported (no picture); not_found (no such layer); too_large (a row of tiles); bad_file (none of the
  ///            rows is there; windows)
  static Result<ExrPart> open(std::unique_ptr<Imf::IStream> stream, std::uint64_t file_size, const std::string& layer);

  int width() const { return window_.width(); }
  int height() const { return window_.height(); }
  /// 1, 3 or 4; Y with A becomes 4, two numbers 3.
  int channels() const;
  /// Luminance and subsampled chroma, which `readRows` does not read.
  bool hasChroma() const { return layer().kind == ExrLayerKind::chroma; }
  const ExrLayer& layer() const { return layers_[choice_.index]; }
  const ExrWindow& window() const { return window_; }
  const Imf::Header& header() const { return file_->header(layer().part); }
  bool isTiled() const;

  Metadata metadata() const;
  /// What the file states of its colour, if anything, of a layer that has some.
  std::optional<Primaries> primaries() const;
  /// "OpenEXR, half, DWAB, layer beauty"
  std::string describe() const;
  /// Describes its window and its layers; `To` is DecodedImage or RowReader::Description.
  template <typename To>
  void tell(To& to) const {
    to.window = window_.part;
    to.layer = layer().name;
    if (layers_.size() > 1) to.layers = pictureLayers(layers_);
    if (choice_.is_guessed) to.layer_guess = choice_.oddity;
    for (const std::string& oddity : {choice_.oddity, window_.oddity, rowsRemark()})
      if (!oddity.empty()) to.oddities.push_back(oddity);
  }

  /// Reads rows as floats, alpha premultiplied, primaries as the file has them; 0 where the file has no texels, and
  /// opaque where it should have some. Throws, as OpenEXR does.
  ///
  /// samples  of `count` rows, `channels()` a texel
  void readRows(int first, int count, float* samples) const;
  /// Reads channels of lines of the data window that the file has. Throws, as OpenEXR does.
  void readFrame(const Imf::FrameBuffer& frame, int first_line, int last_line) const;
  /// For each row of the data window whether the file lacks it; empty: it has all.
  std::span<const std::uint8_t> missingDataRows() const { return is_missing_; }

 private:
  /// finds_offsets  whether chunks are looked for that the table of offsets lacks, in the whole file
  void openFile(bool finds_offsets);
  /// Whether the chunk is there that was written last, of a file that is written from its top or its bottom.
  bool hasLastChunk() const;
  Result<void> findMissingRows(std::uint64_t first_chunk, std::uint64_t file_size);
  /// Counts as missing what has luminance and no chroma beside it: rows of odd numbers have none of their own.
  void dropRowsWithoutChroma();
  /// Of the picture, counted from its top.
  bool isMissing(int row) const;
  int missingRows() const;
  std::string rowsRemark() const;
  void readWholeRows(int first, int count, float* samples) const;
  void readInto(float* texels, const Imath::Box2i& rows) const;

  std::unique_ptr<Imf::IStream> stream_;
  std::unique_ptr<Imf::MultiPartInputFile> file_;
  std::vector<ExrLayer> layers_;
  ExrLayerChoice choice_;
  ExrWindow window_;
  std::vector<std::uint8_t> is_missing_ = {};  ///< of each row of the data window; empty: none is
};

/// What OpenEXR says is wrong, in one line.
std::string reasonOf(const std::exception& exception);

/// Runs what reads through OpenEXR, whose errors are exceptions.
///
/// errors   too_large (memory); bad_file; else what `work` returns
template <typename Value, typename Work>
Result<Value> decodingExr(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, "not enough memory to decode it");
  } catch (const std::exception& exception) {
    return fail(ErrorCode::bad_file, "is a damaged OpenEXR file: " + reasonOf(exception));
  }
}

}  // namespace mirrorball
